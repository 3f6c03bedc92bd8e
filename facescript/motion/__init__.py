"""A score to a performance: gaze, expression, mouth, gesture, life, and the law that blends them."""
