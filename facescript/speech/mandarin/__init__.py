"""Mandarin: syllables, and their shapes of the mouth."""
