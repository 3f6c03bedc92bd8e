"""Turns a life into where the eyes are beside the target that the script gives them, and the head that goes along."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence

from facescript.motion.dice import Event
from facescript.motion.life.away import Away, looks_away
from facescript.motion.life.fixations import TARGET, Fixation, fixation, jump_time, line_of_sight
from facescript.motion.life.model import Living, Moved, moved, steps
from facescript.motion.life.reading import reading, reads
from facescript.motion.life.saccades import microsaccades
from facescript.motion.life.stretches import Stretches
from facescript.space.main_sequence import head_time

FURTHEST = 30.0
"""Deg that the eyes turn away at most with `avert 100%`."""

HEAD_LAG = 0.1
"""Seconds the head follows the eyes."""

AROUND = 0.05
"""Seconds before and after a saccade away in which there is no microsaccade."""


def eyes(life: Living) -> Iterable[Moved]:
    """The line of sight leaves the target as far as the knob `avert` says (1: 30 deg); there and on the target it makes
    the small movements of the knob `saccades`."""
    reach = FURTHEST * min(1.0, life.knob("avert"))
    away: Sequence[Away] = ()
    closed = [*life.occasions.moving.within(life.start, life.end)]
    fixations: Sequence[Fixation] = ()
    resumed: list[float] = []
    if reach > 0.0 and reads(life):
        busy = Stretches(life.occasions.busy.within(life.start, life.end))
        fixations = tuple(reading(life, reach, busy))
        free = tuple(busy.between(life.start, life.end))
        closed += free
        resumed = list(_resumed(life, (start for start, _ in free)))
    elif reach > 0.0:
        away = tuple(looks_away(life, reach))
        fixations = tuple(item for look in away for item in look.fixations)
        longest = jump_time((0.0, 0.0), (2.0 * reach, 0.0))
        closed += [(item.onset - AROUND, item.onset + longest + AROUND) for item in fixations]
    yield from _sight(fixations)
    yield from _sight(tuple(_ended(microsaccades(life, Stretches(closed)), resumed)))
    yield from _along(away)


def _resumed(life: Living, starts: Iterable[float]) -> Iterator[float]:
    """When reading goes on; in a run also the last time before what is asked for."""
    memory = life.memory
    known = memory.state(life.dice, "reading") if memory else None
    if known is not None:
        yield known
    for start in starts:
        if start < life.since:
            continue
        if memory is not None:
            memory.note(life.dice, "reading", start, start)
        yield start


def _ended(found: Iterable[Fixation], moments: Sequence[float]) -> Iterator[Fixation]:
    """Fixations about the target, brought back to it at each of the moments (where reading goes on)."""
    for item in found:
        index = bisect_right(moments, item.onset)
        if index == len(moments) or moments[index] >= item.end:
            yield item
            continue
        end = moments[index]
        share = (end - item.onset) / (item.end - item.onset)
        left = tuple(there + share * (away - there) for there, away in zip(item.landed, item.left, strict=True))
        yield Fixation(item.onset, item.landed, (left[0], left[1]), end)
        yield fixation(end, TARGET)


def _sight(found: Sequence[Fixation]) -> Iterator[Moved]:
    if found:
        yaw, pitch = line_of_sight(found)
        yield moved(yaw, gaze_yaw=1.0)
        yield moved(pitch, gaze_pitch=1.0)


def _along(away: Sequence[Away]) -> Iterator[Moved]:
    """The head goes a part of the way to the first place of a look away, and back."""
    turns = tuple(_turns(away))
    for axis, name in enumerate(("head_yaw", "head_pitch")):
        poses = [pose for look in away for pose in (look.head[axis], 0.0)]
        yield moved(steps(turns, poses.__getitem__), **{name: 1.0})


def _turns(away: Sequence[Away]) -> Iterator[Event]:
    """There and back; no turn begins before the one before is done."""
    clear = 0.0
    for number, look in enumerate(away):
        lasts = head_time(abs(complex(*look.head)))
        for part, onset in enumerate((look.start, look.end)):
            begun = max(clear, onset + HEAD_LAG)
            clear = begun + lasts
            yield Event(2 * number + part, begun, clear)
