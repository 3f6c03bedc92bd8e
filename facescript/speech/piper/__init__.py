"""The program piper as an engine of speech."""
