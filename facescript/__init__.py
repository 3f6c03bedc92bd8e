"""FaceScript: a small language for faces, and its compiler."""

__version__ = "0.1.0"
