"""Text to a tree, and back in one layout."""
