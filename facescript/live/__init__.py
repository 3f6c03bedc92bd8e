"""A script running now: events in, frames, marks and sound out, sixty times a second."""
