"""One file a feature: what an editor asks, to the answer; each has `register(server)`."""
