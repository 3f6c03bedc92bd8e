"""A place in a document to what may be written there: what stands before it, what is around it, and lists to offer."""
