"""Recordings and their words to when each word and phone is said."""
