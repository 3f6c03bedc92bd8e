"""Pictures to what a run is told, with a finder for bright squares: sightings first, and presence without a face."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from facescript.ir.values import Point
from facescript.live.model import Happening, Sighting
from facescript.live.seeing.background import Background
from facescript.live.seeing.faces import Picture, distinct
from facescript.live.seeing.geometry import FACE, Box, Camera
from facescript.live.seeing.presence import ABSENT, PRESENT, Presence
from facescript.live.seeing.watch import Watcher

FPS = 30


class Squares:
    """Finds the one white square of a picture."""

    width = FACE

    def faces(self, picture: Picture, near: Sequence[Box] | None = None) -> list[Box]:
        rows, columns = np.nonzero(picture[:, :, 0] == 255)
        if not len(rows) or near == []:
            return []
        top, left = rows.min(), columns.min()
        return [Box(float(left), float(top), float(columns.max() - left + 1), float(rows.max() - top + 1))]


def picture(x: int | None = None, body: int | None = None, light: int = 0) -> Picture:
    """A dim room, with a square face whose left edge is at `x`, or a grey body without a face."""
    found = np.full((240, 320, 3), 60 + light, dtype=np.uint8)
    if body is not None:
        found[100:, body : body + 80] = 130 + light
    if x is not None:
        found[80:120, x : x + 40] = 255
    return found


def told(watcher: Watcher, pictures: Sequence[Picture], start: float = 0.0) -> list[Sighting | Happening]:
    return [item for number, one in enumerate(pictures) for item in watcher.look(one, start + number / FPS)]


def test_a_person_is_seen_before_she_arrives_and_is_where_she_is() -> None:
    camera = Camera(Point(0.0, 0.0, 0.0))
    watcher = Watcher(camera, Squares())
    found = told(watcher, [picture(40)] * 30)
    assert isinstance(found[0], Sighting) and found[1] == Happening("arrives", found[0].time, person="person 1")
    assert all(isinstance(item, Sighting) and item.person == "person 1" for item in found[2:])
    assert found[0].place == camera.locate(Box(40, 80, 40, 40), 320, 240) and found[0].place.x > 0
    gone = [item for number in range(60) for item in watcher.blind(1.0 + number / FPS)]
    assert [(item.kind, item.person) for item in gone] == [("leaves", "person 1")]


def test_the_same_pictures_tell_the_same() -> None:
    walk = [picture(20 + 2 * number) for number in range(60)]
    one, other = (told(Watcher(Camera(Point(0.0, 0.0, 0.0)), Squares()), walk) for _ in range(2))
    assert one == other


def test_somebody_without_a_face_is_present_and_the_light_is_nobody() -> None:
    watcher = Watcher(Camera(Point(0.0, 0.0, 0.0)), Squares(), frozenset({PRESENT, ABSENT}))
    brighter = [picture(light=min(number, 40)) for number in range(60)]
    assert told(watcher, brighter) == []
    walk = [picture(body=2 * number, light=40) for number in range(60)]
    assert [item.text for item in told(watcher, walk, 2.0) if isinstance(item, Happening)] == [PRESENT]
    empty = told(watcher, [picture(light=40)] * 120, 4.0)
    assert [item.text for item in empty if isinstance(item, Happening)] == [ABSENT]


def test_who_turns_away_is_there_as_long_as_somebody_stands_there() -> None:
    """Her face is not seen for three seconds, but she is; then she has gone."""
    empty, turned = [picture()] * 5, [picture(body=20)] * (3 * FPS)
    facing = turned[0].copy()
    facing[80:120, 40:80] = 255
    watcher = Watcher(Camera(Point(0.0, 0.0, 0.0)), Squares())
    comings = []
    for number, one in enumerate([*empty, *[facing] * FPS, *turned, *[facing] * FPS, *[picture()] * (2 * FPS)]):
        comings += [item for item in watcher.look(one, number / FPS) if isinstance(item, Happening)]
    assert [(item.kind, item.person) for item in comings] == [("arrives", "person 1"), ("leaves", "person 1")]
    assert comings[1].time == pytest.approx((len(empty) + 5 * FPS) / FPS + 1.0, abs=0.1)


def test_what_stays_becomes_background_after_a_minute_or_two() -> None:
    background = Background()
    background.differs(picture(), 0.0)
    shares = [background.differs(picture(body=100), float(second)) for second in range(1, 181)]
    assert shares[20] > 0.1 and shares[-1] == 0.0


@pytest.mark.parametrize(("there", "signals"), [([True] * 10, []), ([True] * 20, [PRESENT])])
def test_presence_is_told_of_once_it_lasts(there: list[bool], signals: list[str]) -> None:
    presence = Presence()
    steps = [*there, *[False] * 100]
    found = [signal for number, one in enumerate(steps) if (signal := presence.step(one, number / FPS))]
    assert found == ([*signals, ABSENT] if signals else [])


def test_a_frame_within_a_face_or_nearly_the_same_is_no_second_face() -> None:
    face = Box(100, 100, 80, 80)
    assert distinct([Box(120, 120, 30, 30), Box(104, 98, 78, 78), face, Box(200, 100, 60, 60)]) == [
        face,
        Box(200, 100, 60, 60),
    ]
