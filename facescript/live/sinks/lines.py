"""A run to standard output: lines of JSON, the layout first."""

from __future__ import annotations

import os
import sys

from facescript.live.address import Address
from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.sinks.counting import Counting
from facescript.live.sinks.messages import Named, layout_text, mark_text, utterance_text
from facescript.live.sinks.setting import Setting
from facescript.live.sinks.writer import Writer


class LinesSink(Counting):
    """Who reads too slowly misses lines. Once nobody reads any more, `frame` raises `BrokenPipeError`, so that the run
    ends as other programs in a pipe do."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._patient = setting.patient
        self._writer: Writer | None = None

    async def open(self, layout: Layout) -> None:
        sys.stdout.flush()
        self._writer = Writer(os.fdopen(os.dup(sys.stdout.fileno()), "wb", buffering=0), self._patient)
        self._named = Named(layout.names)
        self._put(layout_text(layout))

    def frame(self, frame: Frame) -> None:
        if self.due(frame):
            self._put(self._named.text(frame))

    def mark(self, mark: Mark) -> None:
        self._put(mark_text(mark))

    def utter(self, utterance: Utterance) -> None:
        self._put(utterance_text(utterance))

    async def close(self) -> None:
        left = 0 if self._writer is None else self._writer.close()
        self._counts["sent"] -= left
        self._counts["dropped"] += left

    def _put(self, line: str) -> None:
        assert self._writer is not None
        if isinstance(self._writer.failed, BrokenPipeError):
            raise self._writer.failed
        self._counts["sent" if self._writer.put(line) else "dropped"] += 1
