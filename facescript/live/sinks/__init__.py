"""What a run shows and says, to whom it goes: one file an address, `registry.py` has a row each."""
