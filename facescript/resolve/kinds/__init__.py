"""Definitions of kinds of faces (`kind fox = ...`) to data that the rig draws."""
