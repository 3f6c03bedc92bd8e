"""All channels of a frame to the datagrams of Open Sound Control, and to those of avatars."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
from _sending import Waves, layout
from row import Row

from facescript.live.sinks.datagrams import DatagramSink
from facescript.live.sinks.registry import open_sink

BAR = 0.5
"""ms of processor time for all channels."""

FRAMES = 2000


def rows() -> Iterator[Row]:
    for address, bar in (("osc", BAR), ("vmc", None), ("livelink", None), ("udp-json", None)):
        sink = open_sink(f"{address}://127.0.0.1:9000")
        assert isinstance(sink, DatagramSink)
        sink.begin(layout())
        yield from _row(address, sink, bar)


def _row(name: str, sink: DatagramSink, bar: float | None) -> Iterator[Row]:
    performer = Waves(layout())
    frames = [performer.frame(number) for number in range(FRAMES)]
    packets = sink.packets(frames[0])
    took = []
    for frame in frames:
        began = time.perf_counter()
        packets = sink.packets(frame)
        took.append((time.perf_counter() - began) * 1000)
    middle, late = np.percentile(took, (50, 99))
    sizes = ", ".join(str(len(packet)) for packet in packets)
    what = f"{len(performer.layout.names)} channels to {name}"
    found = f"{middle:.3f} ms p50, {late:.3f} ms p99; {len(packets)} datagrams of {sizes} bytes"
    met = None if bar is None else middle <= bar and max(map(len, packets)) <= 1400
    yield Row(what, f"{bar:g} ms, 1400 bytes each" if bar else "", found, met)
