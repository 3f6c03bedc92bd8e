"""The flat screen (D1): how much of the true angle is drawn, `screen measured`; and the patent's own example."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from playing import Place, Studio, eye_height, on_way, place_words, script
from table import Check, Measures, Row, row

from facescript.space.room import towards

SIZES = (5, 10, 20, 30, 40, 50)
WAYS = tuple(range(0, 360, 45))


def angle(place: Place) -> float:
    """How far a direction is from straight ahead, deg."""
    return float(np.degrees(np.arccos(towards(*place)[2])))


def gains(studio: Studio) -> Iterator[Row]:
    places = [(size, way) for size in SIZES for way in WAYS if size <= 30 or way % 180 == 0]
    found = []
    for distance in (100, 200):
        seen = _seen(studio, [on_way(*place) for place in places], "measured", distance)
        found += [angle(gaze) / angle(on_way(*place)) for gaze, place in zip(seen, places, strict=True)]
    yield row("D1", "default", "total rotation over true angle, `screen measured`", found, f"{len(found)} targets")
    drawn = [angle(gaze) for gaze in _seen(studio, [(30.0, 0.0), (-30.0, 0.0)], "patent", 200)]
    check = Check("", tuple(drawn), 9.5, 10.5)
    yield Row("D1", "`screen patent`: an object at 30 deg is looked at by 10", "left and right", (check,))


def _seen(studio: Studio, places: list[Place], screen: str, distance: float) -> Iterator[Place]:
    """Where gaze points when it has come to targets in these directions."""
    height = studio.once(eye_height)
    targets = [f"target t{number} at {place_words(place, distance, height)}" for number, place in enumerate(places)]
    looks = [f"at {2 * number + 1}s: look at t{number}" for number in range(len(places))]
    text = script(*targets, *looks, f"wait {2 * len(places) + 2}s").replace("screen none", f"screen {screen}")
    playing = studio.play(text)
    for number in range(len(places)):
        end = playing.trace(2 * number + 2.9, 2 * number + 2.95)
        yield float(end.gaze("yaw")[-1]), float(end.gaze("pitch")[-1])


MEASURES: Measures = {"D1": gains}
