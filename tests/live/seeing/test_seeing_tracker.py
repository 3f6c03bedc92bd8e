"""Frames of faces to persons: who arrives and leaves, who is whom after a crossing, what is bounded."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain

import numpy as np
import pytest

from facescript.live.seeing.geometry import Box
from facescript.live.seeing.tracker import MOST, Seen, Tracker

FPS = 30
Walk = Callable[[float], tuple[float, float, float] | None]
"""The middle of a face and its size at a time, pixels; None where it is hidden."""


def frame(x: float, y: float, side: float) -> Box:
    return Box(x - side / 2, y - side / 2, side, side)


def watched(
    walks: list[Walk], seconds: float, tracker: Tracker, seed: int = 0
) -> Iterator[tuple[float, list[int], Seen]]:
    """The pictures of a time: which walks are seen in them, as noisy as a cascade's frames, and what is told."""
    chance = np.random.default_rng(seed)
    for number in range(int(seconds * FPS)):
        time = number / FPS
        places = [(walk, place) for walk, there in enumerate(walks) if (place := there(time)) is not None]
        boxes = []
        for _, (x, y, side) in places:
            dx, dy, ds = chance.normal(0.0, 0.03 * side, 3)
            boxes.append(frame(x + dx, y + dy, side + ds))
        order = chance.permutation(len(boxes))
        seen = tracker.step([boxes[place] for place in order], time)
        yield time, [places[place][0] for place in order], seen


def straight(x: float, speed: float, y: float = 240.0, side: float = 60.0, gap: tuple[float, float] = (9, 9)) -> Walk:
    return lambda time: None if gap[0] <= time < gap[1] else (x + speed * time, y, side)


def test_who_is_seen_for_half_a_second_has_arrived_and_leaves_a_second_after() -> None:
    walk: Walk = lambda time: (300.0, 240.0, 60.0) if time < 2.0 else None  # noqa: E731
    told = [(round(time, 3), seen.arrived, seen.left) for time, _, seen in watched([walk], 4, Tracker())]
    assert [(time, arrived) for time, arrived, _ in told if arrived] == [(0.5, ("person 1",))]
    ((left, names),) = [(time, names) for time, _, names in told if names]
    assert names == ("person 1",) and 2.9 < left <= 3.05


def test_a_frame_that_comes_and_goes_is_nobody() -> None:
    blinks: Walk = lambda time: (300.0, 240.0, 60.0) if int(time * 10) % 5 == 0 else None  # noqa: E731
    assert not any(seen.arrived or seen.faces for _, _, seen in watched([blinks], 10, Tracker()))


def test_who_is_hidden_for_less_than_a_second_is_still_there() -> None:
    told = [seen for _, _, seen in watched([straight(100, 60, gap=(2.0, 2.8))], 6, Tracker())]
    assert list(chain.from_iterable(seen.arrived for seen in told)) == ["person 1"]
    assert not any(seen.left for seen in told)
    assert told[-1].faces[0][0] == "person 1"


@pytest.mark.parametrize("seed", range(8))
def test_one_of_three_is_followed_through_the_others(seed: int) -> None:
    """Two cross her way in front of her and hide her for the time; she keeps her name, and they keep theirs."""

    def hidden(walk: Walk, *before: Walk) -> Walk:
        """What is seen of a walk behind others."""

        def seen(time: float) -> tuple[float, float, float] | None:
            place = walk(time)
            covers = [other for one in before if (other := one(time)) is not None and place is not None]
            return None if any(abs(other[0] - place[0]) < 0.6 * other[2] for other in covers if place) else place

        return seen

    first = straight(60, 90, side=80)
    second = straight(600, -180, y=235, side=70)
    her = hidden(straight(400, -45, y=238, side=60), first, second)
    walks = [first, hidden(second, first), her]
    tracker = Tracker()
    names: dict[int, set[str]] = {0: set(), 1: set(), 2: set()}
    for time, order, seen in watched(walks, 4.0, tracker, seed):
        middles = {walk: place for walk, there in enumerate(walks) if (place := there(time)) is not None}
        for name, box in seen.faces:
            nearest = min(middles, key=lambda walk: abs(middles[walk][0] - box.x - box.width / 2))
            assert nearest in order
            names[nearest].add(name)
    assert [len(found) for found in names.values()] == [1, 1, 1], names
    assert tracker.persons == 3


def test_no_more_are_followed_than_there_is_room_for() -> None:
    walks = [straight(40.0 * number, 0.0, side=30.0) for number in range(MOST + 4)]
    tracker = Tracker()
    told = [seen for _, _, seen in watched(walks, 1, tracker)]
    assert len(told[-1].faces) == MOST == len(tracker.tracks)
    assert tracker.refused > 0


def test_a_picture_that_is_not_later_than_the_one_before_is_passed_over() -> None:
    tracker = Tracker()
    tracker.step([frame(100, 100, 50)], 1.0)
    assert tracker.step([frame(500, 100, 50)], 1.0) == Seen() == tracker.step([], 0.5)
    assert len(tracker.tracks) == 1
