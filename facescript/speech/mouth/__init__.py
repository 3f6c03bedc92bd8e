"""Sounds of speech to shapes of the mouth."""
