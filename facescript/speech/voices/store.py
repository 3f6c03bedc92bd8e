"""Spoken lines to and from the user's cache, each under what it was made from and by."""

from __future__ import annotations

import hashlib
from dataclasses import astuple, replace
from functools import cache
from pathlib import Path
from typing import Any

from facescript.cache import Room
from facescript.ir.acts import Say
from facescript.speech.model import Doubt, PhoneTime, Spoken, WordTime

ROOM = Room("spoken", largest=128 << 20, bound=512 << 20)
"""A line of 50 minutes, and three hours in all."""


def key_of(line: Say, identity: str) -> str:
    """The name under which a line is kept: a digest over its text, its marks, its voice, the engine's `identity`, and
    the sources that made it."""
    made_from = (line.text, line.stretches, replace(line.voice, volume=1.0), identity, _sources())
    return hashlib.sha256(repr(made_from).encode()).hexdigest()[:40]


def known(line: Say, identity: str) -> Spoken | None:
    """The times of a line that has been spoken before, without its sound; None where it has not, or is not kept."""
    if not identity:
        return None
    head = ROOM.head(key_of(line, identity))
    return None if head is None else _spoken(head, b"")


def load(key: str) -> Spoken | None:
    """A line that has been spoken before; None where it has not, or is not kept."""
    found = ROOM.load(key)
    return None if found is None else _spoken(*found)


def save(key: str, spoken: Spoken) -> None:
    """Keep a spoken line."""
    words, phones, doubts = ([astuple(one) for one in part] for part in (spoken.words, spoken.phones, spoken.doubts))
    ROOM.save(key, [spoken.rate, spoken.duration, words, phones, doubts, spoken.marks], spoken.pcm)


def _spoken(head: Any, pcm: bytes) -> Spoken:
    rate, duration, words, phones, doubts, marks = head
    return Spoken(
        pcm,
        rate,
        duration,
        tuple(WordTime(*word) for word in words),
        tuple(PhoneTime(*phone) for phone in phones),
        doubts=tuple(Doubt(*doubt) for doubt in doubts),
        marks=tuple((name, time) for name, time in marks),
    )


@cache
def _sources() -> str:
    """A digest of this package and its tables: what another version made is not its own."""
    speech = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for path in sorted(path for path in speech.rglob("*.*") if path.suffix in (".py", ".txt", ".json")):
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()
