"""A line that is put in far away redraws nothing: it moves what hangs on later speech, the rest stays in its place."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from living import PRESETS, preset, stretches, talk
from performing import HERE, Floats, channels, grid, score

from facescript.ir.acts import Glance, Look
from facescript.ir.values import AtCamera, Towards
from facescript.motion.perform import perform
from facescript.schedule.score import FOREVER, TimedAct, TimedLine
from facescript.space.plan import GazePlan

RATE = 50.0
SHIFTS = st.integers(5, 40).map(lambda rows: rows / RATE * 10.0)
SEEDS = st.integers(0, 1000)
LIVING = [name for name in PRESETS if name != "still"]
BEFORE = talk(4.0, 4.6, "before")
TURNS = tuple(talk(40.0 + 14.0 * turn, 9.2, f"turn {turn % 2}") for turn in range(4))
END = 100.0


def drawn(what: str, lines: tuple[TimedLine, ...], acts: tuple[TimedAct, ...] = (), seed: int = 1) -> dict[str, Floats]:
    return channels(perform(score(acts, END + 20.0, preset(what), lines, seed)), grid(END + 20.0, RATE))


def later(lines: tuple[TimedLine, ...], shift: float) -> tuple[TimedLine, ...]:
    return tuple(replace(line, start=line.start + shift) for line in lines)


def part(values: Floats, start: float, end: float) -> Floats:
    return values[round(start * RATE) : round(end * RATE)]


@pytest.mark.parametrize("name", LIVING)
@settings(max_examples=3, deadline=None)
@given(SHIFTS, SEEDS)
def test_what_does_not_hang_on_speech_stays_where_it_is(name: str, shift: float, seed: int) -> None:
    one = drawn(name, TURNS, seed=seed)
    other = drawn(name, (BEFORE, *later(TURNS, shift)), seed=seed)
    for channel in ("head.yaw", "head.roll"):
        if name != "conversation" and name != "calm":
            assert np.array_equal(one[channel], other[channel])
    # Blinks, but for what the lids follow of the eyes: those of a face whose eyes rest.
    quiet = f"{name}, saccades 0/min, avert 0%, nods 0%"
    one, other = drawn(quiet, TURNS, seed=seed), drawn(quiet, (BEFORE, *later(TURNS, shift)), seed=seed)
    assert np.array_equal(one["lid.left"], other["lid.left"])
    assert np.array_equal(one["head.pitch"], other["head.pitch"])


@settings(max_examples=8, deadline=None)
@given(SHIFTS, SEEDS)
def test_nods_go_with_their_pauses(shift: float, seed: int) -> None:
    what = "announcer, sway 0%"
    one, other = drawn(what, TURNS, seed=seed), drawn(what, (BEFORE, *later(TURNS, shift)), seed=seed)
    nodded = part(one["head.pitch"], 39.0, END)
    assert nodded.min() < -1.0
    assert part(other["head.pitch"], 39.0 + shift, END + shift) == pytest.approx(nodded, abs=1e-6)


@settings(max_examples=8, deadline=None)
@given(SHIFTS, SEEDS)
def test_looks_away_in_a_turn_go_with_the_turn(shift: float, seed: int) -> None:
    what = "conversation, saccades 0/min, blink 0/min, sway 0%, nods 0%"
    one, other = drawn(what, TURNS, seed=seed), drawn(what, (BEFORE, *later(TURNS, shift)), seed=seed)
    for turn in TURNS:
        for channel in ("gaze.yaw", "gaze.pitch"):
            looked = part(one[channel], turn.start, turn.end)
            assert part(other[channel], turn.start + shift, turn.end + shift) == pytest.approx(looked, abs=1e-6)


@settings(max_examples=8, deadline=None)
@given(st.sampled_from(["conversation", "reading", "calm"]), SEEDS)
def test_a_glance_early_in_a_long_silence_is_soon_forgotten(name: str, seed: int) -> None:
    plan = GazePlan(AtCamera(), "eyes only", 5.0, 5.05, 5.0, 5.0, (0.0, 0.0), 0.0)
    glance = TimedAct(0, Glance(AtCamera()), "ada", 0, 5.0, 5.5, 5.5, 5.5, HERE, plan=(plan,))
    late = np.arange(240.0, 300.0, 1.0 / RATE)
    one, other = (channels(perform(score(acts, 320.0, preset(name), (), seed)), late) for acts in ((), (glance,)))
    for channel in ("gaze.yaw", "gaze.pitch", "lid.left"):
        assert one[channel] == pytest.approx(other[channel], abs=1e-9)


def shifted(start: float, order: int, yaw: float) -> TimedAct:
    """A gaze shift of 24 deg by its plan: it may bring a blink or not."""
    plan = GazePlan(
        Towards(yaw, 0.0), "eyes then head", start, start + 0.1, start + 0.02, start + 0.4, (0.0, 0.0), 24.0
    )
    look = Look(Towards(yaw, 0.0))
    return TimedAct(order, look, "ada", 0, start, start + 0.1, FOREVER, FOREVER, HERE, plan=(plan,))


@settings(max_examples=8, deadline=None)
@given(SHIFTS, SEEDS)
def test_blinks_of_gaze_shifts_go_with_their_looks(shift: float, seed: int) -> None:
    looks = tuple(shifted(30.0 + 3.0 * index, index, float(index)) for index in range(20))
    moved = tuple(shifted(30.0 + 3.0 * index + shift, index + 1, float(index)) for index in range(20))
    what = "calm, blink 0.01/min, saccades 0/min, avert 0%"
    one, other = drawn(what, (), looks, seed), drawn(what, (), (shifted(6.0, 0, 77.0), *moved), seed)
    blinks = [stretches(made["lid.left"] > 0.25, RATE)[:, 0] for made in (one, other)]
    found = [each[(each > 29.5 + late) & (each < 89.5 + late)] for each, late in zip(blinks, (0.0, shift), strict=True)]
    assert 4 <= len(found[0]) <= 19
    assert found[1] - shift == pytest.approx(found[0], abs=1.01 / RATE)
