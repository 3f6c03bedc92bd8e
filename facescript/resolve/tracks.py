"""Tracks that targets follow: CSV files of the project to key places by time, and to when the target is not seen."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite

from facescript.ir.values import Point
from facescript.resolve.files import project_path
from facescript.resolve.places import polar
from facescript.resolve.project import Project, Refused
from facescript.resolve.tables import cells
from facescript.resolve.units import ANGLE, LARGEST, LENGTH, TIME
from facescript.syntax.tree import String

MOST_KEYS = 250_000
"""Rows of all tracks of a script together: more than an hour at 60 a second."""

LARGEST_TRACK = 64 * 1024 * 1024
"""Bytes of a track."""

BRIDGED = 0.3
"""A target that is not seen for so long is taken to have gone on; one that is not seen for longer is lost, s."""

TIMES = "time"
FORMS = (("x", "y", "z"), ("azimuth", "elevation", "distance"))
"""The columns of a place: cm, cm, cm or deg, deg, cm."""

_MOST = {"azimuth": LARGEST[ANGLE], "elevation": LARGEST[ANGLE]}


@dataclass(frozen=True, slots=True)
class Track:
    """Key places by time, and the stretches in which the target is lost, as `ir.play.MovingTarget` has them."""

    times: tuple[float, ...]
    places: tuple[Point, ...]
    lost: tuple[tuple[float, float], ...]


def track(project: Project, path: String) -> Track:
    """The track that a file holds. Raises `Refused`."""
    project.notes.passing = True  # how many rows may be read hangs on the tracks before
    name = project_path(path.span, path.value)
    known = project.tracks.get(name)
    if known is None:
        rows = sum(len(other.times) for other in project.tracks.values())
        known = project.memo.once(project, ("track", name, rows), path, lambda: _Reading(project, path, rows).track())
        project.tracks[name] = known
    return known


class _Reading:
    """Reads one file, a row at a time, so that a file that is too long or has a fault is given up where that shows.
    `known` rows of other tracks were read before."""

    def __init__(self, project: Project, path: String, known: int) -> None:
        self.project, self.path, self.known = project, path, known
        self.rows = cells(project, path, LARGEST_TRACK)
        self.places = self._places(next(self.rows, []))
        self.number = 0
        self.before = -1.0

    def track(self) -> Track:
        times: list[float] = []
        places: list[Point] = []
        lost: list[tuple[float, float]] = []
        unseen = False
        for time, place in self._keys():
            if place is None:
                unseen = True
                continue
            if unseen and time - (times[-1] if times else -LARGEST[TIME]) > BRIDGED:
                lost.append((times[-1] if times else -LARGEST[TIME], time))
            times.append(time)
            places.append(place)
            unseen = False
        if not times:
            raise self._refused("it has no rows" if self.number == 0 else "no row says where the target is")
        if unseen and self.before - times[-1] > BRIDGED:
            lost.append((times[-1], LARGEST[TIME]))
        return Track(tuple(times), tuple(places), tuple(lost))

    def _places(self, header: list[str]) -> tuple[tuple[str, int], ...]:
        """The columns of time and place, by name and number: `x y z` where both kinds of place are there."""
        names = [name.strip().casefold() for name in header]
        for form in FORMS:
            wanted = (TIMES, *form)
            if all(names.count(name) == 1 for name in wanted):
                return tuple((name, names.index(name)) for name in wanted)
        form = max(FORMS, key=lambda form: sum(name in names for name in form))
        lacking = [f"`{name}`" for name in (TIMES, *form) if name not in names]
        twice = [f"`{name}`" for name in (TIMES, *form) if names.count(name) > 1]
        raise self._refused(f"it has no column {', '.join(lacking)}" if lacking else f"it has {', '.join(twice)} twice")

    def _keys(self) -> Iterator[tuple[float, Point | None]]:
        """The time and the place of each row; no place where the target is not seen."""
        for row in self.rows:
            self.number += 1
            if self.number + self.known > MOST_KEYS:
                raise self._refused(f"the tracks of this script have more than {MOST_KEYS} rows")
            texts = [row[column].strip() if column < len(row) else "" for _, column in self.places]
            time = self._time(texts[0])
            values = [self._value(name, text) for (name, _), text in zip(self.places[1:], texts[1:], strict=True)]
            yield time, self._place(values) if all(map(isfinite, values)) else None

    def _time(self, text: str) -> float:
        time = self._number(TIMES, text) if text else float("nan")
        if not isfinite(time):
            raise self._wrong(TIMES, text, "is no number")
        if not 0.0 <= time <= LARGEST[TIME]:
            raise self._wrong(TIMES, text, f"is not within 0 and {LARGEST[TIME]:.0f} s")
        if time <= self.before:
            span, path = self.path.span, self.path.value
            raise self.project.refuse("FS708", span, text=text, row=self.number, path=path)
        self.before = time
        return time

    def _value(self, name: str, text: str) -> float:
        """A coordinate; not a finite one where there is none."""
        value = self._number(name, text) if text else float("nan")
        if isfinite(value):
            if abs(value) > _MOST.get(name, LARGEST[LENGTH]):
                raise self._wrong(name, text, f"is beyond {_MOST.get(name, LARGEST[LENGTH]):.0f}")
            if name == "distance" and value <= 0.0:
                raise self._wrong(name, text, "is not above 0")
        return value

    def _number(self, name: str, text: str) -> float:
        try:
            return float(text if "_" not in text else "")
        except ValueError:
            raise self._wrong(name, text, "is no number") from None

    def _place(self, values: list[float]) -> Point:
        return Point(*values) if self.places[1][0] == "x" else polar(*values)

    def _refused(self, reason: str) -> Refused:
        return self.project.refuse("FS706", self.path.span, path=self.path.value, reason=reason)

    def _wrong(self, column: str, text: str, reason: str) -> Refused:
        span, path = self.path.span, self.path.value
        return self.project.refuse(
            "FS707", span, text=text[:40], row=self.number, column=column, path=path, reason=reason
        )
