"""The program flite as an engine of speech."""
