"""Faces, background and view to layers of the picture over time."""
