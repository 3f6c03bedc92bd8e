"""A run to a page that fills a screen: the face, what it says, and a button for each thing that can be touched."""
