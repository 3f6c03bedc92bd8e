"""What is said in a film as captions: files of them, and pictures laid over its frames."""
