"""What all engines share about how a line is to be said: what they cannot do, and when a plosive is heard."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import zip_longest

from facescript.ir.acts import Say
from facescript.speech.model import Doubt, PhoneTime
from facescript.speech.mouth.visemes import visemes

CLOSED = 0.6
"""The share of a plosive during which the mouth is closed, where an engine counts the closure as part of it."""


def doubts(line: Say, unable: Iterable[str]) -> tuple[Doubt, ...]:
    """A warning where a line asks for what its engine is `unable` to do: `pitch`, `range`, `stress`."""
    asked = {name for name in ("pitch", "range") if getattr(line.voice, name) != 1}
    asked |= {"stress" for mark in line.stretches if mark.kind == "stress"}
    reasons = [UNABLE[name] for name in unable if name in asked]
    return (Doubt("FS509", f"`{line.voice.engine}` {' and '.join(reasons)}"),) if reasons else ()


UNABLE = {
    "pitch": "has no `pitch` for it",
    "range": "has no `range` for it",
    "stress": "stresses no marked word",
}
"""What is told of an engine."""


def with_bursts(phones: Sequence[PhoneTime]) -> Iterator[PhoneTime]:
    """Phones of an engine whose plosives contain their closure: each plosive from its burst on."""
    begun = 0.0
    for phone, after in zip_longest(phones, phones[1:]):
        start = begun or phone.start
        begun = after.start + CLOSED * (after.end - after.start) if after and is_plosive(after) else 0.0
        yield replace(phone, start=start, end=begun or phone.end)


def is_plosive(phone: PhoneTime) -> bool:
    return any(shape.kind == "stop" for shape in visemes(phone.symbol)[:1])
