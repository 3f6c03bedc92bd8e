"""Where events of a live run come from: one file an address, `registry.py` has a row each."""
