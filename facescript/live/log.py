"""A run to its log, and a log to the run that it was: JSON lines, first what was run, then what was heeded and when."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from itertools import islice
from pathlib import Path
from typing import TextIO

from facescript.live.messages import LARGEST, LATEST, Nonsense, as_object, loaded, number, of_object
from facescript.live.model import Frame, Happening, Mark, Told
from facescript.resolve.told import HUSHED, LONGEST, TOLD

FORM = 1
"""The form of logs; another number is for logs that this version cannot read."""

FASTEST = 1000.0
"""Frames a second of a run, at most."""

LAST = 10**10
"""No frame has a higher number."""


class LogFault(Exception):
    """A log that cannot be used; `args[0]` is a clause for the author."""


@dataclass(frozen=True, slots=True)
class Head:
    """What was run: the script's name, the hash of its files, how it was set, with which version, and when (seconds of
    the Unix epoch)."""

    script: str
    sha256: str
    seed: int
    fps: float
    facescript: str
    began: float = 0.0
    set: dict[str, str] = field(default_factory=dict)


class Log:
    """Writes a log, each line as soon as it is known, so that what was cut off is a log too."""

    def __init__(self, out: TextIO, head: Head) -> None:
        self._out = out
        self._write(log=FORM, **asdict(head))

    def heeded(self, number: int, item: Told) -> None:
        self._write(frame=number, **as_object(item))

    def dropped(self, first: int, end: int) -> None:
        self._write(frame=first, dropped=end - first)

    def given(self, frame: Frame, marks: Sequence[Mark], now: float) -> None:
        pass

    def ended(self, number: int) -> None:
        self._write(frame=number, ended=True)

    def _write(self, **values: object) -> None:
        self._out.write(json.dumps(values, ensure_ascii=False) + "\n")
        self._out.flush()


@dataclass(frozen=True, slots=True)
class Entry:
    """A line of a log: what a frame heeded, how many frames from there on were dropped, or that it ended there."""

    frame: int
    told: tuple[Told, ...] = ()
    dropped: int = 0
    ended: bool = False


@dataclass(frozen=True, slots=True)
class Recorded:
    """A log that was read through: its head, and the frame before which it ends."""

    path: Path
    head: Head
    end: int


def open_log(path: Path) -> Recorded:
    """Reads a log through. Raises `LogFault`."""
    end, last = 0, 0
    for entry in entries(path):
        if entry.frame < last:
            raise LogFault(f"frame {entry.frame} stands behind frame {last}")
        last = entry.frame
        end = entry.frame if entry.ended else max(end, entry.frame + max(1, entry.dropped))
    return Recorded(path, head(path), end)


def head(path: Path) -> Head:
    """The first line of a log. Raises `LogFault`."""
    message = next((message for _, message in lines(path)), {})
    if message.pop("log", None) != FORM:
        raise LogFault("it does not begin as one")
    try:
        found = Head(**message)  # type: ignore[arg-type]
        number(found.fps, 1e-3, FASTEST, "")
        number(found.seed, 0, 1e15, "")
    except (TypeError, Nonsense):
        raise LogFault("its first line is not what a log begins with") from None
    if not all(isinstance(text, str) for text in (found.script, found.sha256, found.facescript)) or not _texts(found):
        raise LogFault("its first line is not what a log begins with")
    return found


def _texts(head: Head) -> bool:
    values = head.set
    return isinstance(values, dict) and all(isinstance(value, str) for value in values.values())


def entries(path: Path) -> Iterator[Entry]:
    """The lines of a log behind its head. Raises `LogFault`."""
    for line, message in islice(lines(path), 1, None):
        try:
            yield _entry(message)
        except Nonsense as fault:
            raise LogFault(f"line {line}: {fault.args[0]}") from None


def _entry(message: dict[str, object]) -> Entry:
    frame = int(number(message.pop("frame", None), 0, LAST, "it has no frame"))
    if "dropped" in message:
        return Entry(frame, dropped=int(number(message["dropped"], 1, LAST, "so many frames were not dropped")))
    if "ended" in message:
        return Entry(frame, ended=True)
    if TOLD in message or HUSHED in message:
        return Entry(frame, (_statement(message),))
    return Entry(frame, of_object(message))


def _statement(message: dict[str, object]) -> Happening:
    """What a program told the run, or that it interrupted a face: only a log says so."""
    kind = TOLD if TOLD in message else HUSHED
    text = message[kind]
    if not isinstance(text, str) or len(text) > LONGEST:
        raise Nonsense(f"what is told has at most {LONGEST} characters")
    return Happening(kind, number(message.get("time"), 0.0, LATEST, "a time is seconds of the run"), text)


def lines(path: Path) -> Iterator[tuple[int, dict[str, object]]]:
    """The objects of a file with the numbers of their lines, one by one; a last line that was cut off is left out.
    Raises `LogFault`."""
    try:
        with path.open("rb") as file:
            count = 0
            while line := file.readline(16 * LARGEST):
                count += 1
                if not line.endswith(b"\n"):
                    if len(line) < 16 * LARGEST:
                        return
                    raise LogFault(f"line {count} is too long")
                yield count, _object(line, count)
    except OSError as fault:
        raise LogFault(f"it cannot be read ({fault.strerror})") from None


def _object(line: bytes, count: int) -> dict[str, object]:
    with suppress(Nonsense, UnicodeDecodeError):
        return loaded(line.decode("utf-8"))
    raise LogFault(f"line {count} is not JSON")


class Replay:
    """A `Feed` that heeds what a log says, at the same frames, and leaves out the same."""

    def __init__(self, recorded: Recorded) -> None:
        self._entries, self._end = entries(recorded.path), recorded.end
        self._next = next(self._entries, None)
        self._held: list[Told] = []

    def following(self, number: int) -> int | None:
        while self._next is not None and self._next.frame <= number:
            if self._next.dropped:
                number = max(number, self._next.frame + self._next.dropped)
            self._held += self._next.told
            self._next = next(self._entries, None)
        return number if number < self._end else None

    def due(self, number: int, after: float, upto: float) -> list[Told]:
        self.following(number)
        held, self._held = self._held, []
        return held
