"""Where faces and targets are, and how long gaze takes to get there."""
