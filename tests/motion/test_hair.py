"""Hair trails behind the head as damped springs do, as a function of time, and not at all where nothing moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from performing import Floats, add, gesture, grid, score

from facescript.motion import hair
from facescript.motion.hair import DAMPING, LEAST, MOST, RATES, Hair
from facescript.motion.perform import perform
from facescript.performance.channels import HAIR, INDEX
from facescript.performance.easing import smooth
from facescript.schedule.score import Score, TimedScene

COLUMNS = [INDEX[channel.name] for channel in HAIR]
NOD = gesture(1.0, "nod", {"head.pitch": -12.0})
TURN = add(2.0, {"head.yaw": 30.0}, over=0.3)


def turned(times: Floats) -> Floats:
    """A head that turns by 20 degrees in 400 ms, from 1 s on."""
    heads = np.zeros((len(times), 5))
    heads[:, 0] = 20.0 * smooth((times - 1.0) / 0.4)
    return heads


def trails(played: Score, times: Floats) -> Floats:
    return perform(played).sample_face("ada", times)[:, COLUMNS]


def integrated(times: Floats, rate: float) -> Floats:
    """u'' + 2 d w u' + w^2 u = -a of `turned`, in steps of 50 us (semi-implicit Euler)."""
    step = 5e-5
    fine = np.arange(0.0, times[-1] + 2 * step, step)
    pull = np.diff(turned(fine)[:, 0], 2) / step**2
    w = 2.0 * np.pi * rate
    place, speed, found = 0.0, 0.0, np.zeros(len(pull))
    for number, push in enumerate(pull):
        speed += step * (-push - 2.0 * DAMPING * w * speed - w * w * place)
        place += step * speed
        found[number] = place
    return np.interp(times, fine[1:-1] + step, found)


@pytest.mark.parametrize("lock", range(3))
def test_a_lock_is_a_damped_spring_on_the_head(lock: int) -> None:
    times = grid(3.0, 100.0)
    swung = MOST * np.tanh(integrated(times, RATES[lock]) / MOST)
    found = Hair(turned, [(0.0, 10.0)]).sample(times)[:, 2 * lock]
    assert np.abs(swung).max() > 1.5
    assert np.abs(found - (swung - np.clip(swung, -LEAST, LEAST))).max() < 0.05


def test_it_trails_against_the_turn_and_comes_to_rest() -> None:
    """A turn to the viewer's right leaves hair to the left, a nod leaves it up; it dies away."""
    found = trails(score([NOD, TURN], 8.0), grid(8.0, 60.0))
    aside, up = found[:, 0::2], found[:, 1::2]
    during = slice(int(2.0 * 60), int(2.15 * 60))
    assert (aside[during] <= 0.0).all() and (aside[during].min(axis=0) < -0.5).all()
    assert (up[int(1.0 * 60) : int(1.15 * 60)].max(axis=0) > 0.2).all()
    assert not found[: int(1.0 * 60)].any() and not found[-60:].any()


def test_what_stands_still_has_hair_that_hangs() -> None:
    assert not trails(score([], 4.0), grid(4.0, 60.0)).any()
    assert not trails(score([add(0.0, {"head.roll": 20.0}, over=0.0)], 4.0), grid(4.0, 60.0)).any()


def test_any_order_and_chunk_gives_the_same_bits() -> None:
    """Forty seconds with a nod every five: at once, one by one, backwards, by another performance that saw nothing."""
    played = score([gesture(5.0 * k + 1.0, "nod", {"head.pitch": -12.0}, order=k) for k in range(8)], 40.0)
    times = grid(40.0, 7.3)
    at_once = trails(played, times)
    performance = perform(played)
    one_by_one = [performance.sample_face("ada", times[[k]])[0, COLUMNS] for k in range(len(times) - 1, -1, -1)]
    assert np.array_equal(at_once, np.array(one_by_one[::-1]))
    assert np.array_equal(trails(played, times[-5:]), at_once[-5:])
    assert at_once.any(axis=1).sum() > 50


def test_what_is_left_of_a_block_before_is_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run from rest two blocks before, it is the same to 1e-9 deg."""
    times = grid(30.0, 50.0)

    def shaken(moments: Floats) -> Floats:
        heads = np.zeros((len(moments), 5))
        heads[:, 0] = 40.0 * np.sin(9.5 * moments)
        return heads

    found = Hair(shaken, [(0.0, 60.0)]).sample(times)
    monkeypatch.setattr(hair, "BLOCK", 3 * hair.BLOCK)
    assert np.abs(Hair(shaken, [(0.0, 60.0)]).sample(times) - found).max() < 1e-9


def test_a_jump_of_the_head_does_not_fling_it() -> None:
    found = trails(score([add(1.0, {"head.yaw": 40.0, "head.x": 5.0}, over=0.0)], 4.0), grid(4.0, 240.0))
    assert 5.0 < np.abs(found).max() < MOST


def test_a_scene_begins_with_hair_at_rest() -> None:
    """However fast the head was when the scene before was cut, and wherever it is now."""
    scenes = [TimedScene("one", ("ada",), 0.0, 1.2), TimedScene("two", ("ada",), 1.2, 3.0)]
    scenes += [TimedScene("empty", (), 3.0, 4.0)]
    played = score([replace(NOD, start=0.9, end=1.6)], 4.0, scenes=scenes)
    found = trails(played, np.array([1.19, 1.2, 1.25, 2.0, 3.0, 3.5]))
    assert found[0].any() and not found[1:].any()


def test_what_comes_after_a_cut_does_not_show_before_it() -> None:
    """Not even in the last step of the grid, which ends after the cut."""

    def cut(times: Floats) -> Floats:
        return np.where(times[:, None] < 1.203, turned(times), 90.0)

    times = grid(1.203, 1000.0)
    assert np.array_equal(Hair(cut, [(0.0, 1.203)]).sample(times), Hair(turned, [(0.0, 1.203)]).sample(times))


def test_hair_may_be_still() -> None:
    played = score([NOD, TURN], 8.0)
    (face,) = played.faces
    still = replace(played, faces=(replace(face, hair="still"),))
    times = grid(8.0, 30.0)
    assert not trails(still, times).any()
    moving = perform(played).sample_face("ada", times)
    moving[:, COLUMNS] = 0.0
    assert np.array_equal(perform(still).sample_face("ada", times), moving)


def test_tables_know_nothing_of_hair() -> None:
    performance = perform(score([NOD], 4.0))
    assert not any(name.startswith("hair") for name in performance.names)
    assert performance.sample(grid(4.0, 10.0)).shape == (40, len(performance.names))
