"""Poses to geometry."""
