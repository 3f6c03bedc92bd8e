"""A performance to a page: the face, its sound and its words in one file that a browser plays by itself."""
