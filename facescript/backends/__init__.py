"""Outputs: one file a kind, from a performance to bytes."""
