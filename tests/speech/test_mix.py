"""Lines to one track: each at its time and volume, cut where it is cut, never beyond full scale."""

from __future__ import annotations

import tracemalloc
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.speech.model import Spoken
from facescript.speech.sound.mix import BLOCK, FADE, KNEE, soundtrack

RATE = 22_050


@dataclass(frozen=True)
class Line:
    start: float
    spoken: Spoken
    volume: float = 1.0
    cut: float | None = None


@dataclass(frozen=True)
class Lines:
    lines: tuple[Line, ...]
    duration: float


def tone(level: int, seconds: float = 1.0, rate: int = RATE) -> Spoken:
    samples = np.full(round(seconds * rate), level, "<i2")
    return Spoken(samples.tobytes(), rate, seconds, (), ())


def track(*lines: Line, duration: float = 3.0) -> np.ndarray:
    sound = soundtrack(Lines(lines, duration))
    samples = sound.samples()
    assert sound.rate == RATE
    assert samples.dtype == np.int16
    assert len(samples) == len(sound) == round(duration * RATE)
    return samples


def test_a_line_sounds_at_its_time_and_volume() -> None:
    samples = track(Line(0.5, tone(1000), 0.7))
    first, last = np.flatnonzero(samples)[[0, -1]]
    assert (first, last) == (round(0.5 * RATE), round(1.5 * RATE) - 1)
    assert set(samples[first:last]) == {700}


def test_lines_add() -> None:
    samples = track(Line(0, tone(1000)), Line(0.5, tone(3000)))
    assert [int(samples[round(at * RATE)]) for at in (0.2, 0.7, 1.2, 1.7)] == [1000, 4000, 3000, 0]


def test_a_cut_line_fades_into_its_cut() -> None:
    samples = track(Line(0.5, tone(1000), cut=1.0))
    assert not samples[round(1.0 * RATE) :].any()
    assert samples[round((1.0 - FADE) * RATE) - 2] == 1000
    assert np.abs(np.diff(samples[round(0.6 * RATE) :])).max() < 10


def test_what_lies_beyond_the_film_is_silent() -> None:
    assert track(Line(2.5, tone(1000)), Line(5.0, tone(1000))).any()
    assert not track(Line(-2.0, tone(1000)), Line(0.5, tone(1000), cut=0.5)).any()
    assert track(Line(-0.5, tone(1000)))[: round(0.5 * RATE)].all()
    assert len(track(duration=0.0)) == 0


def test_another_rate_keeps_its_length() -> None:
    samples = track(Line(0.25, tone(1000, rate=16_000)))
    edges = np.flatnonzero(np.diff(samples > 500))
    assert edges == pytest.approx([0.25 * RATE, 1.25 * RATE], abs=2)


@pytest.mark.parametrize(
    ("rates", "chosen"),
    [
        ((), RATE),
        ((8_000,), RATE),
        ((16_000, 24_000), 24_000),
        ((44_100, RATE), 44_100),
        ((44_101,), 48_000),
        ((96_000, RATE), 48_000),
    ],
)
def test_a_track_loses_nothing_of_its_lines(rates: tuple[int, ...], chosen: int) -> None:
    lines = tuple(Line(0.0, tone(1000, 0.1, rate)) for rate in rates)
    sound = soundtrack(Lines(lines, 0.2))
    assert sound.rate == chosen
    assert len(sound) == round(0.2 * chosen)


def test_an_estimated_line_asks_for_no_rate() -> None:
    assert soundtrack(Lines((Line(0.0, Spoken(b"", 48_000, 1.0, (), (), True)),), 1.0)).rate == RATE


def test_a_stretch_of_a_track_is_as_long_as_asked_for() -> None:
    sound = soundtrack(Lines((Line(0.5, tone(1000)), Line(1.0, tone(500, rate=16_000))), 2.0))
    whole, part = sound.samples(), sound.between(0.25, 3.0)
    assert np.array_equal(part.samples()[: round(1.75 * RATE)], whole[round(0.25 * RATE) :])
    assert len(part.samples()) == len(part) == round(3.0 * RATE) - round(0.25 * RATE)
    assert (sound.silent, sound.between(0.0, 0.4).silent) == (False, True)


@given(st.lists(st.integers(-32768, 32767), min_size=1, max_size=5), st.floats(0, 4))
def test_nothing_wraps_around(levels: list[int], volume: float) -> None:
    samples = track(*(Line(0, tone(level, 0.01), volume) for level in levels), duration=0.01)
    total = sum(levels) * volume
    assert np.sign(samples[0]) == np.sign(total) or abs(total) < 1
    assert abs(int(samples[0])) <= 32767
    if abs(total) <= KNEE * 32767:
        assert abs(float(samples[0]) - total) <= 1


def test_the_same_score_gives_the_same_bytes() -> None:
    score = Lines((Line(0.1, tone(20_000)), Line(0.4, tone(20_000), 0.9, 1.1)), 2.0)
    assert soundtrack(score).samples().tobytes() == soundtrack(score).samples().tobytes()


def test_blocks_make_no_difference(monkeypatch: pytest.MonkeyPatch) -> None:
    """A long film is mixed a piece at a time; nobody can hear where the pieces meet."""
    lines = (Line(0.2, tone(9000, 1.1)), Line(0.9, tone(20000, 0.7), cut=1.3), Line(1.25, tone(-8000, 0.4, 16000)))
    whole = track(*lines)
    for size in (9_970, 28_100, 28_500):
        monkeypatch.setattr("facescript.speech.sound.mix.BLOCK", size)
        assert np.array_equal(track(*lines), whole)


def test_three_hours_never_lie_in_memory() -> None:
    """However long a film is, what is held of its track is a block."""
    sound = soundtrack(Lines((Line(10_000.0, tone(1000)),), 10_800.0))
    tracemalloc.start()
    try:
        total = sum(len(block) for block in sound.between(0.0, 10_800.0).blocks())
        assert tracemalloc.get_traced_memory()[1] < 16 * BLOCK
    finally:
        tracemalloc.stop()
    assert total == 10_800 * RATE
