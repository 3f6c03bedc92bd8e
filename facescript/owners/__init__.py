"""A channel and a moment to who owned it, what was added, and what the blending law made of that."""
