"""The cartoon rig: the woman and the man."""
