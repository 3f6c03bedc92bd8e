"""A handle that is dragged to the edits that may do it, and to what each has to bring about."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal

from facescript.preview.dragging.allowed import Said
from facescript.preview.dragging.amounts import Change, Stuck, number
from facescript.preview.dragging.degrees import degree
from facescript.preview.dragging.effect import NEAR, Wish
from facescript.preview.dragging.lengths import end_of, is_open, lasting, modifier_of, stops
from facescript.preview.dragging.standing import Level, row
from facescript.preview.dragging.starts import Starts, Way, waiting
from facescript.schedule.score import TimedAct
from facescript.syntax import tree

Handle = Literal["start", "end", "body", "degree"]

STEP = 0.005
"""Seconds by which a rounded time may be wrong."""


WAITS = "what stands behind it would wait for its end: write `for` and a `together:` in the text."


@dataclass(frozen=True, slots=True)
class Try:
    """An edit: `changes` are asked for so many seconds more than was dragged, and raise `Stuck`; and what it is for."""

    changes: Callable[[float], list[Change]]
    wish: Wish


@dataclass(frozen=True, slots=True)
class Tries:
    """The edits for one act; `began` is when it starts, seconds from its scene's start."""

    said: Said
    act: TimedAct
    began: float

    def of(self, handle: Handle, by: float, release: float | None) -> Iterator[Try]:
        """In the order in which they are tried. Raises `Stuck`."""
        if handle == "degree":
            return self._degree(by)
        if handle == "end":
            return self._opened(by, release) if is_open(self.act) else self._lasting(by)
        if handle == "start" and self.has_length():
            return self._shortened(by)
        return self._moved(by)

    def starts(self) -> Iterator[Way]:
        """The ways to move its start. Raises `Stuck`."""
        if self.said.standing is None:
            raise Stuck("it starts on the word behind its bracket: move that in the text.")
        return Starts(self.said.script, self.said.standing, self.began).ways()

    def has_length(self) -> bool:
        return bool(modifier_of(self.act.verb)) and not is_open(self.act)

    def may_end(self) -> bool:
        """Whether its end may be dragged, as far as its line alone says."""
        if is_open(self.act):
            return self.said.standing is not None and (self._wait_behind() is not None or self._is_last())
        try:
            lasting(self.said, self.act, self._length() + 1.0)
        except Stuck:
            return False
        return True

    def _length(self) -> float:
        return end_of(self.act) - self.act.start

    def _wish(self, start: float, end: float | None, still: bool = False) -> Wish:
        return Wish(self.act, start, end, max(NEAR, STEP * stops(self.act)), still)

    # -------------------------------------------------------------------------------------------- one number

    def _degree(self, value: float) -> Iterator[Try]:
        found = degree(self.said)
        yield Try(lambda _: [found.changed(value)], self._wish(self.act.start, None))

    def _moved(self, by: float) -> Iterator[Try]:
        end = None if is_open(self.act) else end_of(self.act) + by
        for way in self.starts():
            yield Try(self._edit(way, by), self._wish(self.act.start + by, end))

    def _lasting(self, by: float) -> Iterator[Try]:
        def changes(more: float) -> list[Change]:
            return [lasting(self.said, self.act, self._length() + by + more)]

        yield Try(changes, self._wish(self.act.start, end_of(self.act) + by))

    def _edit(self, way: Way, by: float, *others: Change) -> Callable[[float], list[Change]]:
        return lambda more: [way.edit(by + more), *others]

    # -------------------------------------------------------------------------------------------- two

    def _shortened(self, by: float) -> Iterator[Try]:
        """The start moves, the end stays."""
        shorter = lasting(self.said, self.act, self._length() - by)
        for way in self.starts():
            yield Try(self._edit(way, by, shorter), self._wish(self.act.start + by, end_of(self.act)))

    def _opened(self, by: float, release: float | None) -> Iterator[Try]:
        """What lasted until something took its place lets go; a `wait` behind it gives up what it lasts longer now."""
        if release is None:
            raise Stuck("it lasts until something takes its place.")
        end = release + by
        made, wish = lasting(self.said, self.act, end - self.act.start), self._wish(self.act.start, end, still=True)
        wait = self._wait_behind()
        if wait is not None:
            yield self._waited(made, wait, end, wish)
        elif self._is_last():
            yield Try(lambda _: [made], wish)
        else:
            raise Stuck(WAITS)

    def _waited(self, made: Change, wait: tree.Act, end: float, wish: Wish) -> Try:
        script = self.said.script
        found = number(wait.phrases[0].words[1:], script, "the `wait` behind it")
        left = found.value - (end - self.act.settled)
        if left < -STEP:
            raise Stuck(WAITS)
        gone = left <= STEP and found.first is None
        rest = Change(*row(script.source, wait), "") if gone else found.changed(max(left, 0.0))
        return Try(lambda _: [made, rest], wish)

    def _levels(self) -> Iterator[Level]:
        """The levels at which what follows an act follows it alone."""
        for level in self.said.standing.levels if self.said.standing is not None else ():
            yield level
            if not isinstance(level.block, tree.Cast) or len(level.block.body) > 1:
                return

    def _wait_behind(self) -> tree.Act | None:
        """The bare `wait` that directly follows an act."""
        wait = waiting(next((level.after for level in self._levels() if level.after is not None), None))
        return wait if wait is not None and len(wait.phrases[0].words) == 2 else None

    def _is_last(self) -> bool:
        """Whether nothing waits for the act to have settled."""
        for level in self.said.standing.levels if self.said.standing is not None else ():
            if level.after is not None:
                return False
            if not isinstance(level.block, tree.Cast | tree.Group):
                return True
        return True
