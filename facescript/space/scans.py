"""A scan of a crowd to what it visits, in which order."""

from __future__ import annotations

from collections.abc import Sequence

from facescript.ir.acts import Scan
from facescript.ir.play import Face
from facescript.ir.random import chance
from facescript.ir.values import Aim
from facescript.space.room import Room


def scan_stops(
    room: Room,
    face: Face,
    scan: Scan,
    start: float,
    seed: int,
    people: Sequence[str] = (),
    place: Sequence[object] = (),
) -> tuple[Aim, ...]:
    """The aims of a scan in the order it visits them; `start` is of the scene's clock, `people` as in `Room.bind`.

    `place` tells one scan from another where the order is drawn `at random`.
    """
    aims = room.members(scan.crowd, people) or ()
    if scan.order == "nearest first":
        return room.nearest_first(face.name, aims, start)
    if scan.order == "at random":
        draws = [chance(seed, "scan", face.name, *place, number) for number in range(len(aims))]
        return tuple(aim for _, aim in sorted(zip(draws, aims, strict=True), key=lambda pair: pair[0]))
    return aims
