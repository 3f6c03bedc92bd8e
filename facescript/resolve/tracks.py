"""Tracks that targets follow: CSV files of the project to key places by time, and to when the target is not seen."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
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

PERSON = "person"
"""The column that says whose a row is, in a track of several persons (live use)."""

LONGEST_NAME = 40
"""Signs of such a name."""

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


def tracks(project: Project, path: String) -> dict[str, Track]:
    """The tracks of the persons that a file holds, by what its column `person` says; of one, "", where it has none.
    Those who are nowhere seen are left out. Raises `Refused`."""
    return _Reading(project, path, 0, PERSON).tracks()


@dataclass(slots=True)
class _Course:
    """The keys of one target so far. `before` is the time of its last row, and `unseen` that no place stood there."""

    times: list[float] = field(default_factory=list)
    places: list[Point] = field(default_factory=list)
    lost: list[tuple[float, float]] = field(default_factory=list)
    before: float = -1.0
    unseen: bool = False

    def add(self, time: float, place: Point | None) -> None:
        self.before = time
        if place is None:
            self.unseen = True
            return
        if self.unseen and time - (self.times[-1] if self.times else -LARGEST[TIME]) > BRIDGED:
            self.lost.append((self.times[-1] if self.times else -LARGEST[TIME], time))
        self.times.append(time)
        self.places.append(place)
        self.unseen = False

    def track(self) -> Track:
        if self.unseen and self.before - self.times[-1] > BRIDGED:
            self.lost.append((self.times[-1], LARGEST[TIME]))
        return Track(tuple(self.times), tuple(self.places), tuple(self.lost))


class _Reading:
    """Reads one file, a row at a time, so that a file that is too long or has a fault is given up where that shows.
    `known` rows of other tracks were read before; `apart` is the column that tells targets apart, where it is there."""

    def __init__(self, project: Project, path: String, known: int, apart: str = "") -> None:
        self.project, self.path, self.known = project, path, known
        self.rows = cells(project, path, LARGEST_TRACK)
        header = next(self.rows, [])
        self.places = self._places(header)
        names = [name.strip().casefold() for name in header]
        self.apart = names.index(apart) if names.count(apart) == 1 else None
        self.number = 0
        self.courses: dict[str, _Course] = {}

    def track(self) -> Track:
        (found,) = self.tracks().values()
        return found

    def tracks(self) -> dict[str, Track]:
        for course, time, place in self._keys():
            course.add(time, place)
        found = {name: course.track() for name, course in self.courses.items() if course.times}
        if not found:
            raise self._refused("it has no rows" if self.number == 0 else "no row says where the target is")
        return found

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

    def _keys(self) -> Iterator[tuple[_Course, float, Point | None]]:
        """Whose each row is, its time and its place; no place where the target is not seen."""
        for row in self.rows:
            self.number += 1
            if self.number + self.known > MOST_KEYS:
                raise self._refused(f"the tracks of this script have more than {MOST_KEYS} rows")
            texts = [row[column].strip() if column < len(row) else "" for _, column in self.places]
            course = self._course(row)
            time = self._time(texts[0], course.before)
            values = [self._value(name, text) for (name, _), text in zip(self.places[1:], texts[1:], strict=True)]
            yield course, time, self._place(values) if all(map(isfinite, values)) else None

    def _course(self, row: list[str]) -> _Course:
        name = row[self.apart].strip() if self.apart is not None and self.apart < len(row) else ""
        if len(name) > LONGEST_NAME or not name.isprintable():
            raise self._wrong(PERSON, name, f"is no name of at most {LONGEST_NAME} signs")
        return self.courses.setdefault(name, _Course())

    def _time(self, text: str, before: float) -> float:
        time = self._number(TIMES, text) if text else float("nan")
        if not isfinite(time):
            raise self._wrong(TIMES, text, "is no number")
        if not 0.0 <= time <= LARGEST[TIME]:
            raise self._wrong(TIMES, text, f"is not within 0 and {LARGEST[TIME]:.0f} s")
        if time <= before:
            span, path = self.path.span, self.path.value
            raise self.project.refuse("FS708", span, text=text, row=self.number, path=path)
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
