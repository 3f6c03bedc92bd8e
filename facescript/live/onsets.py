"""What begins in a run to a table of when it was planned, in which frame it is, and when that frame was given."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from typing import TextIO

from facescript.live.model import Frame, Mark, Told

HEADER = ("kind", "label", "face", "text", "planned", "frame", "real")

KINDS = ("act", "line", "event", "scene")


class Onsets:
    """A row an act, a line, a scene and an event that was heeded, as soon as it is known: all times are seconds of the
    run; `real` is by its clock, when the frame had been given to all sinks."""

    def __init__(self, out: TextIO) -> None:
        self._out, self._rows = out, csv.writer(out, lineterminator="\n")
        self._write(HEADER)

    def heeded(self, number: int, item: Told) -> None:
        pass

    def dropped(self, first: int, end: int) -> None:
        pass

    def given(self, frame: Frame, marks: Sequence[Mark], now: float) -> None:
        for mark in marks:
            if mark.kind in KINDS:
                times = (f"{time:.6f}" for time in (mark.time, frame.time, now))
                self._write((mark.kind, mark.label or "", mark.face or "", mark.text, *times))

    def ended(self, number: int) -> None:
        pass

    def _write(self, row: Sequence[str]) -> None:
        self._rows.writerow(row)
        self._out.flush()
