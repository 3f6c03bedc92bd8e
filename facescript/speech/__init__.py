"""Texts to sound, words, phonemes and mouth shapes."""
