"""Sound from a room to the phrases that a script waits for."""
