"""A script that is being written to a page on this machine: the face beside the text, and the time it takes below."""
