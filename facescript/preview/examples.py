"""The scripts that the playground offers, in the order in which they teach; none needs another file."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

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


FIRST = "conversation"
"""What stands in the playground at first."""


@dataclass(frozen=True, slots=True)
class Example:
    """A script with its name, and in a clause what it shows."""

    name: str
    says: str
    text: str


def examples() -> tuple[Example, ...]:
    """All of them. What one shows is what its first line says."""
    return tuple(_example(name) for name in NAMES)


def first() -> str:
    """The text that stands in the playground at first."""
    return _example(FIRST).text


def playground(editor: bool) -> bytes:
    """What the page asks for once, as JSON: the examples, and whether `editor.js` is there."""
    return json.dumps({"editor": editor, "examples": [asdict(each) for each in examples()]}).encode()


def _example(name: str) -> Example:
    text = (folder("examples") / f"{name}.face").read_text("utf-8")
    first = text.partition("\n")[0]
    return Example(name, first.partition(f"{name}.face: ")[2] or first, text)
