"""A book as EPUB 3: its text, the sound of each chapter, and overlays that say which word is read when."""
