"""The scripts that the playground offers, in the order in which they teach; none needs another file."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.resources import folder

NAMES = (
    "hello",
    "words",
    "conversation",
    "dialogue",
    "expressions",
    "gestures",
    "gaze",
    "vergence",
    "idle",
    "crowd",
    "scenes",
    "kiosk",
    "mandarin",
    "muscles",
    "degrees",
    "monster",
)


@dataclass(frozen=True, slots=True)
class Example:
    """A script with its name, and in a clause what it shows."""

    name: str
    says: str
    text: str


def examples() -> tuple[Example, ...]:
    """All of them. What one shows is what its first line says."""
    return tuple(_example(name) for name in NAMES)


def _example(name: str) -> Example:
    text = (folder("examples") / f"{name}.face").read_text("utf-8")
    first = text.partition("\n")[0]
    return Example(name, first.partition(f"{name}.face: ")[2] or first, text)
