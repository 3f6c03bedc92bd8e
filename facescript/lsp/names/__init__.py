"""The names of a project's scripts: where each is defined, and every place that means it."""
