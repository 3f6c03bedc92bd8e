"""Chance as a function: a number in [0, 1) for a seed and a place, the same for ever."""

from __future__ import annotations

import hashlib


def chance(seed: int, *place: object) -> float:
    """Uniform in [0, 1) for `seed` and a place (any values with a stable `str`), independent between places."""
    text = "\x1f".join(map(str, (seed, *place)))
    digest = hashlib.blake2b(text.encode(), digest_size=8).digest()
    return int.from_bytes(digest, "big") / 2**64


def between(low: float, high: float, seed: int, *place: object) -> float:
    """Uniform in [low, high) for `seed` and a place."""
    return low + (high - low) * chance(seed, *place)
