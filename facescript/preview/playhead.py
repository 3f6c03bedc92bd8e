"""A moment of a film to the same moment of the film that it became: the same statement, as far into it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from facescript.schedule.score import Score
from facescript.text import Source


@dataclass(frozen=True, slots=True)
class Stretch:
    """An act in time, and the offset of its statement in the script; `pass_` counts the acts of one statement."""

    start: float
    end: float
    place: int
    pass_: int


def stretches(score: Score, source: Source) -> list[Stretch]:
    """The acts that the script itself states, by their starts."""
    counted: dict[int, int] = {}
    found = []
    for act in score.acts:
        if act.span.source is source:
            place = act.span.start
            counted[place] = counted.get(place, -1) + 1
            found.append(Stretch(act.start, max(act.start, min(act.settled, score.duration)), place, counted[place]))
    return found


def moved(
    time: float, before: Sequence[Stretch], after: Iterable[Stretch], carry: Callable[[int], int | None]
) -> float:
    """The moment `time` among the stretches `before`, among those `after`; `carry` says where a place is now. Where
    no statement that was under way is there any more, the moment stays as it is."""
    now = {(each.place, each.pass_): each for each in after}
    for each in sorted((each for each in before if each.start <= time), key=lambda each: -each.start):
        place = carry(each.place)
        other = None if place is None else now.get((place, each.pass_))
        if other is None:
            continue
        into = time - each.start
        if time <= each.end:
            into = min(into, max(other.end - other.start, 0.0))
        return other.start + into
    return time
