"""A score to where a face looks: the line of sight, how near the eyes converge, the head that goes along."""
