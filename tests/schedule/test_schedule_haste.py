"""Changes and gestures that would be faster than heads and eyes: they take as long as they need, and it is told."""

from __future__ import annotations

import numpy as np
import pytest
from scheduling import scheduled

from facescript.motion.gesture import PROFILES
from facescript.performance.easing import EASINGS
from facescript.schedule.explain import explain
from facescript.schedule.haste import PACES, STEEPEST, STROKE

SHARE = np.linspace(0.0, 1.0, 20_001)


def lengths(text: str) -> tuple[list[float], list[str]]:
    """How long each statement takes until the next may start, and the codes of what is told."""
    done = scheduled(text)
    rows = [row for row in explain(done.solved) if row.kind == "act"]
    return [round(row.settled - row.start, 3) for row in rows], [item.code for item in done.diagnostics]


def test_what_is_too_fast_takes_as_long_as_it_needs() -> None:
    told = lengths("nod for 50ms\nadd head.yaw 30deg over 10ms\nadd eye.yaw 20deg over 5ms\nblink for 20ms\n")
    assert told == ([0.269, 0.296, 0.09, 0.15], ["FS608"] * 4)


def test_what_jumps_jumps_and_what_is_slow_enough_is_left() -> None:
    text = "add head.yaw 30deg over 0ms\nnod\nshake 50% for 500ms\nadd AU12 over 1ms\nshow head.roll 5deg over 200ms\n"
    assert lengths(text) == ([0.0, 0.7, 0.5, 0.001, 0.2], [])


@pytest.mark.parametrize("kind", PACES)
def test_no_gesture_is_steeper_than_is_reckoned(kind: str) -> None:
    speed = np.gradient(PROFILES[kind](SHARE), SHARE)
    assert 0.9 * PACES[kind] < np.abs(speed).max() <= PACES[kind]


def test_no_curve_is_steeper_than_is_reckoned() -> None:
    for name, ease in EASINGS.items():
        speed = np.gradient(ease(SHARE), SHARE)
        assert np.abs(speed).max() <= STEEPEST
        if name != "linear":
            assert np.abs(np.gradient(speed, SHARE)).max() <= STROKE * STEEPEST**2
