"""A play to a score: when each act starts, settles and ends."""
