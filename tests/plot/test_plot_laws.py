"""Laws of the parts of a plot: ticks, texts, envelopes."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from facescript.performance.channels import INDEX
from facescript.performance.performance import REST, Frames
from facescript.plot.axis import APART, Scale
from facescript.plot.font import CUT, fit, width
from facescript.plot.sample import STRAIGHT, envelopes, straightened

LENGTHS = st.floats(1e-3, 14_400.0)


@given(start=st.floats(0.0, 14_000.0), length=LENGTHS, wide=st.integers(400, 8192))
def test_ticks_of_time_stand_apart_and_bear_different_names(start: float, length: float, wide: int) -> None:
    scale = Scale(92.0, wide - 20.0, start, start + length)
    times, names = zip(*scale.ticks(), strict=True) if scale.ticks() else ((), ())
    assert all(start - 1e-5 <= time <= start + length + 1e-5 for time in times)
    assert all(np.diff([scale.x(time) for time in times]) >= APART - 1)
    assert len(set(names)) == len(names)


@given(text=st.text(max_size=40), room=st.floats(0.0, 300.0))
def test_what_fits_is_a_beginning_and_has_room(text: str, room: float) -> None:
    found = fit(text, 11, room)
    assert found == text or found == "" or text.startswith(found.removesuffix(CUT))
    assert found == "" or width(found, 11) <= room


@given(
    values=st.lists(st.floats(-100.0, 100.0), min_size=2, max_size=30),
    steps=st.lists(st.floats(0.0, 3.0), min_size=30, max_size=30),
)
def test_a_straightened_line_stays_where_it_was(values: list[float], steps: list[float]) -> None:
    x, y = np.cumsum(steps[: len(values)]) * 0.5 + np.arange(len(values)) * 0.01, np.array(values)
    kept = np.array(straightened(x, y))
    assert tuple(kept[0]) == (x[0], y[0]) and tuple(kept[-1]) == (x[-1], y[-1])
    assert np.abs(np.interp(x, kept[:, 0], kept[:, 1]) - y).max() <= STRAIGHT + 1e-9


class Spike:
    """A head that stands still but for one millisecond."""

    def __init__(self, at: float) -> None:
        self.at = at

    def sample(self, times: np.ndarray) -> Frames:
        frames = np.repeat(REST[None], len(times), axis=0)
        frames[:, INDEX["head.yaw"]] = np.where(np.abs(times - self.at) <= 0.001, 30.0, 0.0)
        return frames


@given(at=st.floats(0.01, 59.9), columns=st.integers(100, 2000))
def test_an_envelope_has_every_extreme(at: float, columns: int) -> None:
    scale = Scale(0.0, float(columns), 0.0, 60.0)
    (found,) = envelopes(Spike(at), [("head.yaw",)], scale)
    assert (found.low, found.high) == (0.0, 30.0)
    assert (np.diff(found.times.ravel()) >= 0).all()
    assert abs(found.times[found.values == 30.0] - at).max() <= 0.002
