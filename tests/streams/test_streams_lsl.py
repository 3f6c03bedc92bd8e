"""A run to the Lab Streaming Layer: what an inlet of pylsl records."""

from __future__ import annotations

import time

import pytest
from streaming import HELLO, ONSET, layout, opened, smiling

pylsl = pytest.importorskip("pylsl")


async def test_channels_and_markers_are_on_one_clock() -> None:
    of = layout()
    name = f"face {time.monotonic_ns()}"
    async with opened(f"lsl://{name}", of) as sink:
        streams = {kind: _inlet(name, kind) for kind in ("Face", "Markers")}
        sink.mark(HELLO)  # told before the first frame
        sink.frame(smiling(0, of))
        for number in range(1, 61):
            sink.frame(smiling(number, of))
        sink.mark(ONSET)
        samples, times = _pulled(streams["Face"], 61)
        marks, moments = _pulled(streams["Markers"], 2)
        info = streams["Face"].info()
    assert (info.channel_count(), info.nominal_srate(), info.type()) == (len(of.names), 60.0, "Face")
    assert info.get_channel_labels() == list(of.names)
    smile = of.names.index("cheek.lower.left")
    assert [sample[smile] for sample in samples] == pytest.approx([number / 100 for number in range(61)])
    assert [time - times[0] for time in times] == pytest.approx([number / 60 for number in range(61)])
    assert marks == [["word: Hello"], ["onset"]]
    assert [moment - times[0] for moment in moments] == pytest.approx([0.25, 0.5])
    assert sink.counts() == {"sent": 61, "dropped": 0, "markers": 2}


def _inlet(name: str, kind: str) -> object:
    (found,) = pylsl.resolve_bypred(f"starts-with(name,'{name}') and type='{kind}'", timeout=5)
    inlet = pylsl.StreamInlet(found)
    inlet.open_stream(timeout=5)
    return inlet


def _pulled(inlet: object, many: int) -> tuple[list[list[object]], list[float]]:
    """So many samples, with their times on LSL's clock."""
    samples, times = [], []
    for _ in range(many):
        sample, moment = inlet.pull_sample(timeout=5)  # type: ignore[attr-defined]
        samples.append(sample)
        times.append(moment)
    return samples, times
