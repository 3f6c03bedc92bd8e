"""Channels to the shapes that other faces are made of (ARKit, VRM, MPEG-4), and back, by tables of the library."""
