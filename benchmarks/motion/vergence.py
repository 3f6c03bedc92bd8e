"""Vergence (V1, V2): how well both eyes meet on a target, and how much of a change is done with the saccade."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from bars import APART_CM, Trace, vergence_share
from playing import Place, Playing, Studio, eye_height, on_way, place_words, script
from table import Measures, Row, row

from facescript.space.room import towards

DISTANCES = (30, 40, 50, 70, 100, 150, 200, 300, 450, 600)
REST = 2.0
"""Seconds of a look."""


def fits(studio: Studio) -> Iterator[Row]:
    """The angle at which the eyes' lines meet beside the angle at the target between the eyes, after 2 s."""
    places = [(place, distance) for place in ((0.0, 0.0), (20.0, 0.0), (-20.0, 8.0), (0.0, -15.0))
              for distance in DISTANCES]  # fmt: skip
    playing = _looks(studio, places)
    found = [
        abs(_angle(playing.trace(REST * (number + 1) - 0.01, REST * (number + 1))) - _geometry(distance))
        for number, (_, distance) in enumerate(places, start=1)
    ]
    yield row(
        "V1", "0.3..6 m", "vergence off the geometry, 0.3 to 6 m", found, f"{len(found)} targets, four directions"
    )


def _looks(studio: Studio, places: list[tuple[Place, int]], manner: str = "") -> Playing:
    height = studio.once(eye_height)
    targets = [f"target t{number} at {place_words(place, distance, height)}"
               for number, (place, distance) in enumerate(places, start=1)]  # fmt: skip
    looks = [f"at {REST * number:.1f}s: look at t{number}{manner}" for number in range(1, len(places) + 1)]
    return studio.play(script(*targets, *looks, f"wait {REST * (len(places) + 2):.1f}s"))


def _angle(trace: Trace) -> float:
    """The angle between both eyes' lines at the trace's end, deg."""
    lines = [towards(*(trace.channels[f"eye.{side}.{axis}"][-1] for axis in ("yaw", "pitch"))) for side in
             ("left", "right")]  # fmt: skip
    return float(np.degrees(np.arccos(np.clip(np.dot(*lines), -1.0, 1.0))))


def _geometry(distance: float) -> float:
    """2 atan(IPD/2d), deg: a little more than the true angle aside, where the eyes are seen at a slant."""
    return float(2 * np.degrees(np.arctan(APART_CM / 2 / distance)))


PAIRS = ((300, 40), (200, 50), (600, 30))
"""Distances of a far and a near target, cm."""


def with_saccades(studio: Studio) -> Iterator[Row]:
    shifts = [(on_way(-size / 2, way), on_way(size / 2, way)) for size in (20, 25, 30, 40) for way in (0, 180, 20)]
    for case in ("convergence", "divergence"):
        ways = PAIRS if case == "convergence" else [(near, far) for far, near in PAIRS]
        found = [share for way in ways for share in _shares(studio, shifts, *way)]
        over = f"{len(found)} saccades of 20 to 40 deg, three pairs of distances"
        yield row("V2", case, f"share of {case} done inside the saccade", found, over)


def _shares(studio: Studio, shifts: list[tuple[Place, Place]], first: int, second: int) -> Iterator[float]:
    places = [place for start, end in shifts for place in ((start, first), (end, second))]
    playing = _looks(studio, places, ", eyes only")
    for number in range(1, len(shifts) + 1):
        onset = REST * 2 * number
        yield vergence_share(playing.trace(onset - 0.05, onset + REST - 0.05), "yaw")


MEASURES: Measures = {"V1": fits, "V2": with_saccades}
