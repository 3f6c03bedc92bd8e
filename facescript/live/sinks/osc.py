"""A run to Open Sound Control: an address a channel, and one for what begins."""

from __future__ import annotations

import numpy as np

from facescript.live.model import Frame, Layout, Mark
from facescript.live.sinks.bundles import Bundles, bundle, message
from facescript.live.sinks.datagrams import DatagramSink

PREFIX = "facescript"


class OscSink(DatagramSink):
    """`head.yaw` goes to `/facescript/head/yaw`, after `/facescript/time`; the address's path stands for the first
    word. A mark is `/facescript/mark` with its kind, text, time, face and label."""

    def begin(self, layout: Layout) -> None:
        self._prefix = f"/{self._address.path or PREFIX}"
        names = ["time", *layout.names]
        self._bundles = Bundles([(message(self._at(name), 0.0), 1) for name in names])

    def packets(self, frame: Frame) -> list[bytes]:
        return self._bundles.packets(np.concatenate(([frame.time], frame.values)))

    def mark(self, mark: Mark) -> None:
        about = message(self._at("mark"), mark.kind, mark.text, float(mark.time), mark.face or "", mark.label or "")
        self.send([bundle(about)])

    def _at(self, name: str) -> str:
        return f"{self._prefix}/{name.replace('.', '/')}"
