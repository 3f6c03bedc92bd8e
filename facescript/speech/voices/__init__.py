"""Engines of speech behind one interface, and what they have spoken."""
