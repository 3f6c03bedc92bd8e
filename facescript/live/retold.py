"""The log of a run to a script of its `event` lines and of targets that move as its persons did, for builds."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from facescript.ir.values import Point
from facescript.live.log import LogFault, Recorded, entries
from facescript.live.messages import TEXTUAL
from facescript.live.model import Sighting
from facescript.writing.quotes import quoted

EVERY = 0.1
"""Seconds between two keys of a person's way, at least."""

UNSEEN = Point(0.0, 0.0, 100.0)
"""Where a person is of whom no place is told."""


@dataclass(slots=True)
class Way:
    """A person of a log: the target's name, and where it was when."""

    name: str
    keys: list[tuple[float, Point]] = field(default_factory=list)

    def pass_by(self, time: float, place: Point) -> None:
        if not self.keys or time >= self.keys[-1][0] + EVERY:
            self.keys.append((time, place))


def retold(recorded: Recorded) -> str:
    """What was heeded, as a script says it. Raises `LogFault`."""
    ways: dict[str, Way] = {}
    lines = []
    for entry in entries(recorded.path):
        for item in entry.told:
            if isinstance(item, Sighting):
                _way(ways, item.person).pass_by(item.time, item.place)
            elif item.person is not None:
                lines.append(f"event {_way(ways, item.person).name} {item.kind} at {_number(item.time)}s")
            elif item.kind not in TEXTUAL:
                raise LogFault(f"at frame {entry.frame} a program told the face what to do, which no `event` says")
            else:
                lines.append(f"event {item.kind} {quoted(item.text)} at {_number(item.time)}s")
    return "\n".join([*(line for way in ways.values() for line in _target(way)), *lines, ""])


def _way(ways: dict[str, Way], person: str) -> Way:
    return ways.setdefault(person, Way(f"logged_{len(ways) + 1}"))


def _target(way: Way) -> Iterator[str]:
    if len(way.keys) < 2:
        yield f"target {way.name} at {_place(way.keys[0][1] if way.keys else UNSEEN)}"
        return
    yield f"target {way.name} moves"
    for time, place in way.keys:
        yield f"    {_number(time)}s {_place(place)}"


def _place(place: Point) -> str:
    return " ".join(f"{_number(size)}cm" for size in (place.x, place.y, place.z))


def _number(value: float) -> str:
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
