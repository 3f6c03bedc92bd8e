"""The room: what a face aims at, at a time, to the point it is and the direction in which it is looked at."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from math import hypot, inf
from typing import NamedTuple

from facescript.ir.play import Crowd, Face, Film, FixedTarget, MovingTarget, Target
from facescript.ir.values import (
    Aim,
    AtCamera,
    AtFace,
    AtPerson,
    AtTarget,
    Draw,
    PicturePlace,
    Point,
    Towards,
)
from facescript.space.direction import angles, towards
from facescript.space.layout import EYES, MOUTH, lay_out
from facescript.space.live import LiveSightings, LiveTarget, Whereabouts
from facescript.space.path import Path
from facescript.space.sightings import Sightings

CAMERA_CM = 60.0
"""How far straight ahead the camera is, cm."""

PICTURE_CM = 40.0
"""How far in front of the picture faces and places in it are looked at; from here on the screen's fraction is full."""

AHEAD_CM = 600.0
"""The distance of a look in a direction, where there is nothing to converge on, cm."""

NEAREST_CM = 8.0
"""The nearest point both eyes can converge on, cm."""

FARTHEST_CM = 1e7
"""Beyond this both eyes look straight on, cm; so far a script's places lie at most."""

KEPT = 4096
"""Lines of sight to places that stay that are kept."""

PEOPLE = "people"
"""The crowd of those whom the camera sees."""


class Sight(NamedTuple):
    """A line of sight as it is drawn: yaw (+ the viewer's right) and pitch (+ up) in deg, and the distance in cm at
    which both eyes converge."""

    yaw: float
    pitch: float
    distance: float


class Room:
    """A film's faces and targets. Times are seconds of the scene's own clock. `left` is how many movements
    may still be worked out for the plans of gaze made in it.

    In a `live` room persons come in whom no script knows of (`targets`). They move by the film's time: `scene` is when
    the scene starts, and of what came after `now` (s of the clock) nothing is known of them."""

    def __init__(self, film: Film, faces: Sequence[Face], targets: Sequence[Target]) -> None:
        self.film = film
        self.layout = lay_out(film, faces)
        self.targets: dict[str, Target] = {target.name: target for target in targets}
        self.left = inf
        self.scene, self.now = 0.0, inf
        self.live = any(isinstance(target, LiveTarget) for target in targets)
        self._eyes: dict[str, tuple[float, float]] = {}
        self._still: dict[tuple[str, Aim], Sight] = {}
        self._paths: dict[str, Path | Whereabouts] = {}
        self._sightings: dict[tuple[str, str], Sightings | LiveSightings] = {}
        self._crowds: dict[str, tuple[Aim, ...]] = {}

    def of(self, scene: float) -> Room:
        """The same room for a scene that starts at `scene` s of the film."""
        if not self.live:
            return self
        room = copy(self)
        room.scene, room._paths, room._sightings = scene, {}, {}
        return room

    def turn_to(self, now: float) -> None:
        """Know no more of those who are seen live than was known at a time."""
        if not self.live:
            return
        self.now = now
        for path in self._paths.values():
            if isinstance(path, Whereabouts):
                path.now = now

    def bind(
        self,
        face: str,
        aim: Aim,
        time: float,
        persons: Sequence[tuple[str, str]] = (),
        people: Sequence[str] = (),
    ) -> Aim:
        """The aim made definite: a person becomes the target it is, the nearest of a crowd the one nearest at `time`.

        `persons` says which target a person is, `people` whom the camera sees; nobody there is the camera.
        """
        if isinstance(aim, AtPerson):
            aim = self._member(dict(persons).get(aim.name, aim.name)) or AtCamera()
        if not isinstance(aim, AtTarget):
            return aim
        members = self.members(aim.name, people)
        if members is None:
            return aim
        if isinstance(aim.member, int):
            return members[aim.member - 1] if aim.member <= len(members) else AtCamera()
        return self.nearest_first(face, members, time)[0] if members else AtCamera()

    def members(self, crowd: str, people: Sequence[str] = ()) -> tuple[Aim, ...] | None:
        """The members of a crowd in their order, made definite; None where the name is no crowd."""
        if crowd == PEOPLE and crowd not in self.targets:
            return tuple(member for member in map(self._member, people) if member)
        target = self.targets.get(crowd)
        if not isinstance(target, Crowd):
            return None
        if crowd not in self._crowds:
            numbered = enumerate(target.members, 1)
            members = (self._member(m) if isinstance(m, str) else AtTarget(crowd, n) for n, m in numbered)
            self._crowds[crowd] = tuple(member for member in members if member)
        return self._crowds[crowd]

    def _member(self, name: str) -> Aim | None:
        if name in self.targets:
            return AtTarget(name)
        return AtFace(name) if name in self.layout.standings else None

    def nearest_first(self, face: str, aims: Sequence[Aim], time: float) -> tuple[Aim, ...]:
        """The aims by their distance from the face at `time`, those that are lost last."""
        return tuple(sorted(aims, key=lambda aim: (self.lost(aim, time), self.sight(face, aim, time).distance)))

    def lost(self, aim: Aim, time: float) -> bool:
        """Whether nobody knows where the target of a definite aim is at `time`."""
        target = self.moving(aim)
        return target is not None and self._path(target).known(time) < time

    def moving(self, aim: Aim) -> MovingTarget | None:
        """The moving target that a definite aim is at, if it is one."""
        place = self._place(aim)
        return place if isinstance(place, MovingTarget) else None

    def point(self, face: str, aim: Aim, time: float) -> Point:
        """Where a definite aim is, cm. A direction is a point far away in it, as the face at rest would see it."""
        eyes = self.layout.part(face, EYES)
        if isinstance(aim, AtCamera):
            return Point(*eyes, CAMERA_CM)
        if isinstance(aim, AtFace):
            return Point(*self.layout.part(aim.face, MOUTH if aim.part == "mouth" else EYES), PICTURE_CM)
        if isinstance(aim, Towards):
            x, y, z = towards(_number(aim.yaw), _number(aim.pitch))
            return Point(eyes[0] + x * AHEAD_CM, eyes[1] + y * AHEAD_CM, z * AHEAD_CM)
        place = self._place(aim)
        if isinstance(place, MovingTarget):
            return self._path(place).at(time)
        if isinstance(place, PicturePlace):
            return Point(*self.layout.place(place), PICTURE_CM)
        if place is None:
            raise ValueError(f"{aim} is not definite: bind it first")
        return place

    def sight(self, face: str, aim: Aim, time: float) -> Sight:
        """The line of sight with which a face looks at a definite aim, the flat screen allowed for."""
        target = self.moving(aim)
        if target is not None:
            return self._seen(face, self._path(target).at(time), in_picture=False)
        known = self._still.get((face, aim))
        if known is None:
            if len(self._still) >= KEPT:
                self._still.clear()
            known = self._still[face, aim] = self._sight(face, aim, time)
        return known

    def sightings(self, face: str, aim: Aim) -> Sightings | LiveSightings | None:
        """When a face has the moving target of a definite aim in sight; None for what does not move."""
        target = self.moving(aim)
        if target is None:
            return None
        known = self._sightings.get((face, target.name))
        if known is None or known.path is not self._path(target):
            known = self._sightings[face, target.name] = self._watched(face, self._path(target))
        return known

    def _watched(self, face: str, path: Path | Whereabouts) -> Sightings | LiveSightings:
        if isinstance(path, Whereabouts):
            return LiveSightings(path)
        return Sightings(path, lambda time: self._angles(face, path.at(time)), self.layout.part(face, EYES)[1])

    def following(self, face: str, aim: Aim) -> Callable[[float], Sight]:
        """The line of sight to a definite aim, or to where it was in sight last, as a function of time alone."""
        sightings = self.sightings(face, aim)
        if sightings is None:
            return lambda time: self.sight(face, aim, time)
        at, last = sightings.path.at, sightings.last
        return lambda time: self._seen(face, at(last(time)), in_picture=False)

    def _angles(self, face: str, point: Point) -> tuple[float, float]:
        sight = self._seen(face, point, in_picture=False)
        return sight.yaw, sight.pitch

    def _sight(self, face: str, aim: Aim, time: float) -> Sight:
        if isinstance(aim, Towards):
            return Sight(_number(aim.yaw), _number(aim.pitch), AHEAD_CM)
        return self._seen(face, self.point(face, aim, time), self._in_picture(aim))

    def _seen(self, face: str, point: Point, in_picture: bool) -> Sight:
        """The line of sight to a point in the room, or to one in the picture."""
        eyes = self._eyes.get(face)
        if eyes is None:
            eyes = self._eyes[face] = self.layout.part(face, EYES)
        x, y, z = point.x - eyes[0], point.y - eyes[1], point.z
        yaw, pitch = angles(x, y, z)
        scale = 1.0 if in_picture else screen_fraction(self.film.screen, z)
        return Sight(yaw * scale, pitch * scale, min(FARTHEST_CM, max(NEAREST_CM, hypot(x, y, z))))

    def _path(self, target: MovingTarget) -> Path | Whereabouts:
        known = self._paths.get(target.name)
        if known is None or (isinstance(target, LiveTarget) and not isinstance(known, Whereabouts)):
            known = self._paths[target.name] = self._made(target)
        return known

    def _made(self, target: MovingTarget) -> Path | Whereabouts:
        if isinstance(target, LiveTarget):
            return Whereabouts(target.trail, self.scene, self.now)
        return Path(target.times, target.places, target.lost)

    def _in_picture(self, aim: Aim) -> bool:
        return isinstance(aim, AtFace) or isinstance(self._place(aim), PicturePlace)

    def _place(self, aim: Aim) -> Point | PicturePlace | MovingTarget | None:
        """The place of a definite aim at a target; None for any other aim."""
        if not isinstance(aim, AtTarget):
            return None
        target = self.targets[aim.name]
        if isinstance(target, FixedTarget):
            return target.place
        if isinstance(target, MovingTarget):
            return target
        member = target.members[aim.member - 1] if isinstance(aim.member, int) else None
        return None if isinstance(member, str) else member


def screen_fraction(fraction: float, z: float) -> float:
    """How much of the true angle is drawn for a target `z` cm in front of the screen: `fraction` from 40 cm on,
    smoothly to 1 at the screen ("The flat screen"; first seed, column 12)."""
    if z >= PICTURE_CM:
        return fraction
    near = max(0.0, z / PICTURE_CM)
    return 1.0 + (fraction - 1.0) * near * near * (3.0 - 2.0 * near)


def _number(amount: float | Draw) -> float:
    if isinstance(amount, Draw):
        raise ValueError("a draw that is not drawn")
    return amount
