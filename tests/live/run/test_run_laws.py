"""What holds of a run, whatever is written and whatever happens."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from running import FPS, HEAD, Whole, happenings, rows, running, scripts, speeds

from facescript.live.model import Happening

few = settings(max_examples=2, deadline=None)

HEAD_TOP, GAZE_TOP = 320.0, 750.0
"""Degrees a second that no head and no gaze goes faster."""


@few
@given(scripts(), happenings(4, 3.0), st.integers(0, 3), st.floats(0.5, 3.0))
def test_nothing_that_was_shown_depends_on_what_comes(
    text: str, events: list[Happening], number: int, time: float
) -> None:
    before = [event for event in events if event.time <= time]
    with_it, without = running(text, [*before, Happening("heard", time, str(number))]), running(text, before)
    shown = int(time * FPS) + 1
    assert np.array_equal(rows(with_it, shown / FPS), rows(without, shown / FPS))


@few
@given(scripts(), happenings(6, 4.0))
def test_no_channel_jumps(text: str, events: list[Happening]) -> None:
    run = running(text, events)
    values = rows(run, 5.0)
    assert np.isfinite(values).all()
    assert speeds(run, values, "head.yaw", "head.pitch", "head.roll") < HEAD_TOP
    assert speeds(run, values, "gaze.yaw", "gaze.pitch") < GAZE_TOP


@few
@given(scripts(), happenings(5, 9.0))
def test_what_is_forgotten_is_not_missed(text: str, events: list[Happening]) -> None:
    """Sums are made in another order, so it is the same but for the last digits."""
    values = rows(running(text, events, fps=10.0), 10.0)
    assert np.abs(values - rows(running(text, events, Whole, fps=10.0), 10.0)).max() < 1e-9


@few
@given(scripts(), happenings(4, 2.5), st.sets(st.integers(0, 150), min_size=20))
def test_frames_that_are_left_out_change_no_other(text: str, events: list[Happening], numbers: set[int]) -> None:
    values = rows(running(text, events), 2.6)
    run = running(text, events)
    for number in sorted(numbers):
        assert run.frame(number).values.tobytes() == values[number].tobytes()


def test_a_mouth_that_is_broken_off_does_not_jump() -> None:
    """Where the event comes it is on its way to a sound that is not said: it goes on from there."""
    line, stop = 'say "Umbababa, a mop, a pump, maybe."', 'when heard "0":\n    say "Oh."\n'
    text = (
        HEAD.format(seed=1, life="still") + f"scene main:\n    repeat forever:\n        {line}\n        wait 1s\n{stop}"
    )
    worst = 0.0
    for number in range(10):
        time = 0.5 + 0.05 * number
        run = running(text, [Happening("heard", time, "0")], fps=1000.0)
        around = np.array([run.frame(frame).values for frame in range(int(time * 1000) - 5, int(time * 1000) + 15)])
        worst = max(worst, np.abs(np.diff(around, axis=0)).max())
    assert worst < 0.06
