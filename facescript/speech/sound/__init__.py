"""Sound: what is measured in it, and lines mixed to one track."""
