"""Shapes and points to pixels."""
