"""A run to the Lab Streaming Layer: a regular stream of the channels, and one of markers, on one clock."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np
import pylsl

from facescript.live.address import Address
from facescript.live.model import Frame, Layout, Mark
from facescript.live.sinks.counting import Counting
from facescript.live.sinks.setting import Setting


class LslSink(Counting):
    """`NAME` has the channels, `NAME markers` a text for each mark: the author's label, else its kind and what it is.
    Times are those of the run, put on LSL's clock at the first frame: a mark's is when it was to begin."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._name = address.path
        self._offset: float | None = None
        self._channels: Any = None
        self._markers: Any = None
        self._waiting: list[Mark] = []
        self._counts["markers"] = 0

    async def open(self, layout: Layout) -> None:
        same = hashlib.sha256("\0".join([layout.title, self._name, *layout.names]).encode()).hexdigest()[:16]
        count, fps = len(layout.names), layout.fps
        info = pylsl.StreamInfo(self._name, "Face", count, fps, pylsl.cf_float32, f"facescript-{same}")
        channels = info.desc().append_child("channels")
        for name, channel in zip(layout.names, layout.channels, strict=True):
            one = channels.append_child("channel")
            one.append_child_value("label", name)
            one.append_child_value("unit", channel.unit)
        info.desc().append_child_value("seed", str(layout.seed))
        self._channels = pylsl.StreamOutlet(info)
        marks = pylsl.StreamInfo(
            f"{self._name} markers", "Markers", 1, pylsl.IRREGULAR_RATE, pylsl.cf_string, f"facescript-{same}-markers"
        )
        self._markers = pylsl.StreamOutlet(marks)

    def frame(self, frame: Frame) -> None:
        if self._offset is None:
            self._offset = pylsl.local_clock() - frame.time
        for mark in self._waiting:
            self._push(mark, self._offset)
        self._waiting.clear()
        self._channels.push_sample(frame.values.astype(np.float32).tolist(), self._offset + frame.time)
        self._counts["sent"] += 1

    def mark(self, mark: Mark) -> None:
        if self._offset is None:
            self._waiting.append(mark)
        else:
            self._push(mark, self._offset)

    async def close(self) -> None:
        self._channels = self._markers = None

    def _push(self, mark: Mark, offset: float) -> None:
        self._markers.push_sample([mark.label or f"{mark.kind}: {mark.text}"], offset + mark.time)
        self._counts["markers"] += 1
