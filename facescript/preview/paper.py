"""A script's file to its text as it stands, and edits made on the page to the file; each can be taken back."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from pathlib import Path

from facescript.backends.output import write_script
from facescript.preview.places import Units
from facescript.world import LARGEST_SCRIPT, WorldFailure, decode

REMEMBERED = 200
"""Edits that can be taken back."""


class Refusal(Exception):
    """An edit that is not made; `args[0]` is a clause for the author."""


@dataclass(frozen=True, slots=True)
class Edit:
    """What was replaced: places in UTF-16 units of the text before, and what stands there now."""

    first: int
    last: int
    text: str


class Paper:
    """The text, and how many there have been: `version`. Without a `path` it came from standard input, and stays, or it
    is a `scratch`, which nobody keeps."""

    def __init__(self, path: Path | None, text: str, scratch: bool = False) -> None:
        self.path, self.text, self.version, self.scratch = path, text, 1, scratch
        self._undone: deque[tuple[str, str]] = deque(maxlen=REMEMBERED)

    @property
    def writable(self) -> bool:
        return self.path is not None or self.scratch

    def read(self) -> bool:
        """Reads the file again; whether it says something else now. One that cannot be read is left for later."""
        if self.path is None:
            return False
        try:
            text = _read(self.path)
        except (OSError, WorldFailure):
            return False
        return self.take(text)

    def take(self, text: str) -> bool:
        """The text is another now; whether it is."""
        if text == self.text:
            return False
        self.text = text
        self.version += 1
        return True

    def edit(self, base: int, edit: Edit) -> None:
        """Makes an edit of the text `base` in the file. Raises `Refusal`."""
        units = self.check(base, edit)
        first, last = units.offset(edit.first), units.offset(edit.last)
        before = self.text
        self._write(self.text[:first] + edit.text + self.text[last:])
        self._undone.append((before, self.text))

    def check(self, base: int, edit: Edit) -> Units:
        """The places of the text, where the edit is of it. Raises `Refusal`."""
        if base != self.version:
            raise Refusal("the script has changed since")
        units = Units(self.text)
        if not 0 <= edit.first <= edit.last <= units.at(len(self.text)):
            raise Refusal("the script has no such place")
        return units

    def undo(self) -> Edit:
        """Takes the last edit back; what that replaces. Raises `Refusal`."""
        if not self._undone:
            raise Refusal("there is nothing to take back")
        before, after = self._undone[-1]
        if after != self.text:
            self._undone.clear()
            raise Refusal("the script has been edited elsewhere since")
        edit = difference(after, before)
        self._write(before)
        self._undone.pop()
        return edit

    def _write(self, text: str) -> None:
        """Only where the file is still what the page shows."""
        if not self.writable:
            raise Refusal("it came from standard input")
        if len(text.encode("utf-8", "replace")) > LARGEST_SCRIPT:
            raise Refusal(f"a script has at most {LARGEST_SCRIPT // 1024 // 1024} MiB")
        try:
            if self.path is not None and _read(self.path) != self.text:
                raise Refusal("the file has changed since")
            if decode(text.encode()) != text:
                raise Refusal("it is not plain text")
            if self.path is not None:
                write_script(self.path, text)
        except (OSError, UnicodeError, WorldFailure) as fault:
            raise Refusal(getattr(fault, "strerror", None) or str(fault) or "the file cannot be written") from None
        self.take(text)


def difference(before: str, after: str) -> Edit:
    """The one edit that makes a text of another."""
    shorter = min(len(before), len(after))
    head = next((n for n in range(shorter) if before[n] != after[n]), shorter)
    tail = next((n for n in range(shorter - head) if before[-1 - n] != after[-1 - n]), shorter - head)
    units = Units(before)
    return Edit(units.at(head), units.at(len(before) - tail), after[head : len(after) - tail])


def _read(path: Path) -> str:
    with path.open("rb") as file:
        data = file.read(LARGEST_SCRIPT + 1)
    if len(data) > LARGEST_SCRIPT:
        raise WorldFailure(f"it is larger than {LARGEST_SCRIPT // 1024 // 1024} MiB")
    return decode(data)
