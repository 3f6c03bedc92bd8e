"""A play to a script that compiles to the same play, and to whether it does."""
