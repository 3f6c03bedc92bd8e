"""A script to a play: names, units, the library, checks."""
