"""Files that say when words and phones are, to times and back."""
