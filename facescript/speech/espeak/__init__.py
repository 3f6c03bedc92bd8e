"""The default voice: espeak-ng."""
