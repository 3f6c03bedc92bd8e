"""Turns a life that reads into fixations along lines of text."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.motion.life.fixations import TARGET, Fixation, Offset, fixation, jump_time
from facescript.motion.life.model import Living
from facescript.motion.life.stretches import Stretches

STAY = 0.235, 0.09 / 0.235
"""Mean seconds of a fixation and their coefficient of variation (220 to 250 ms, deviation 80 to 100; `motion.md` 1)."""

BRIEFEST = 0.06
"""Seconds of the shortest fixation (below 50 ms is extreme)."""

STEP = 1.6, 2.4
"""Deg from one fixation to the next in a line."""

WIDTH, ROWS, HEIGHT = 0.85, 5, 0.4
"""How far a line goes to each side, as a part of the reach; the lines of a page; how high the first is, as a part."""

LEAD = 0.3
"""Seconds before a gaze shift and such in which no fixation begins: the eyes are back on the target halfway."""


def reads(life: Living) -> bool:
    """Whether the eyes read: the preset `reading` and what grows from it."""
    return life.preset == "reading"


def reading(life: Living, reach: float, busy: Stretches) -> Iterator[Fixation]:
    """The eyes go along the lines of a text about the target, within `reach` deg, but where they are `busy`.

    The text faces its reader, so a line begins at the face's own left: the viewer's right, where yaw is positive. What
    is read when does not depend on what the script does meanwhile.
    """
    here = TARGET
    free = iter(busy.between(life.start, life.end))
    begins, ends = next(free, (life.end, life.end))
    for onset, place in _page(life, reach):
        while onset >= ends - LEAD:
            if here != TARGET:
                here = TARGET
                yield fixation(ends - LEAD / 2.0, here)
            if ends >= life.end:
                return
            begins, ends = next(free, (life.end, life.end))
        if onset >= begins:
            here = place
            yield fixation(onset, here)


def _page(life: Living, reach: float) -> Iterator[tuple[float, Offset]]:
    """When each fixation's saccade sets off and where it goes, for ever."""
    dice, edge, memory = life.dice, WIDTH * reach, life.memory
    first = life.start, 0, 0, TARGET, edge
    time, row, number, here, yaw = (memory.state(dice, "page") if memory else None) or first
    while True:
        if memory is not None:
            memory.note(dice, "page", time, (time, row, number, here, yaw))
        there = yaw, reach * HEIGHT * (1.0 - 2.0 * row / (ROWS - 1))
        yield time, there
        time += jump_time(here, there) + max(BRIEFEST, dice.log_normal(*STAY, "reading", number, "stay"))
        here, yaw, number = there, yaw - dice.between(*STEP, "reading", number, "step"), number + 1
        if yaw < -edge:
            yaw, row = edge, (row + 1) % ROWS
