"""A life to what a living face does unasked: blinks, brows, head, eyes, and what its voice brings about."""
