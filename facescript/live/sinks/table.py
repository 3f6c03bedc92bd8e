"""A run to a table: the file that `facescript build SCRIPT -o FILE.csv` would make of it."""

from __future__ import annotations

import math
from pathlib import Path

from facescript.backends.tables import cell, number
from facescript.live.address import Address, AddressFault
from facescript.live.model import Frame, Layout, Mark
from facescript.live.sinks.counting import Counting
from facescript.live.sinks.setting import Setting
from facescript.live.sinks.writer import Writer


class TableSink(Counting):
    """A row a frame: `time`, every channel, and under `marker` the names of the statements that begin in it. A row is
    written whole when the next comes: then all that begins in it has been told."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._address, self._setting = address, setting
        self._held: list[Frame] = []
        self._marks: list[tuple[float, str]] = []
        self._told = False
        self._writer: Writer | None = None

    async def open(self, layout: Layout) -> None:
        try:
            file = Path(self._address.path).open("wb", buffering=0)  # noqa: SIM115 - the writer closes it
        except OSError as fault:
            reason = (fault.strerror or "it cannot be made").lower()
            raise AddressFault("FS903", path=self._address.path, reason=reason) from None
        self._writer = Writer(file, self._setting.patient)
        self._put(",".join(["time", *layout.names, "marker"]))

    def frame(self, frame: Frame) -> None:
        if not self.due(frame):
            return
        self._held.append(frame)
        if len(self._held) > 1:
            self._row()

    def mark(self, mark: Mark) -> None:
        if mark.label is not None:
            self._marks.append((mark.time, mark.label))

    async def close(self) -> None:
        while self._held:
            self._row()
        left = 0 if self._writer is None else self._writer.close()
        self._counts["sent"] -= left
        self._counts["dropped"] += left

    def _row(self) -> None:
        """Writes the first row that is held, with what begins before the next."""
        frame = self._held.pop(0)
        until = self._held[0].time - 1e-9 if self._held else math.inf
        self._marks.sort(key=lambda mark: mark[0])
        inside = [name for time, name in self._marks if time < until]
        self._marks = self._marks[len(inside) :]
        values = ",".join(map(number, frame.values.tolist()))
        self._put(f"{number(frame.time)},{values},{cell(' '.join(inside))}")

    def _put(self, row: str) -> None:
        assert self._writer is not None
        self._counts["sent" if self._writer.put(row) else "dropped"] += 1
        if self._writer.failed is not None and not self._told:
            self._told = True
            reason = (self._writer.failed.strerror or "it takes no more").lower()
            self._setting.tell(f"{self._address.path} cannot be written any more: {reason}.")
