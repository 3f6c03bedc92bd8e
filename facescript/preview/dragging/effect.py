"""An edit to what it does, the score before and after it against what was wished; and edits to one stretch of text."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from facescript.preview.dragging.amounts import Change, Stuck
from facescript.preview.dragging.lengths import end_of
from facescript.schedule.score import Score, TimedAct
from facescript.syntax.formatter import format_source
from facescript.syntax.layout import WIDEST
from facescript.text import Source

NEAR = 0.02
"""Seconds from the asked time that are near enough."""

LOOSE = 0.06
"""Seconds by which what follows may move otherwise than what it follows: a look takes as long as eyes have to go."""


@dataclass(frozen=True, slots=True)
class Wish:
    """When an act is to start and to end (None: whenever), how many seconds off are `near` enough, and whether what
    follows must stay too (`still`)."""

    act: TimedAct
    start: float
    end: float | None
    near: float = NEAR
    still: bool = False


@dataclass(frozen=True, slots=True)
class Effect:
    """What became of a score."""

    before: Score
    after: Score | None
    wish: Wish

    def must_be_solved(self) -> None:
        """Raises `Stuck` where the script is no longer whole, or plays other acts than before."""
        if self.after is None:
            raise Stuck("then the script would have an error: its times cannot be so.")
        if len(self.after.acts) != len(self.before.acts):
            raise Stuck("then something else in the script would begin to be played, or cease to.")

    def missing(self) -> float | None:
        """By how many seconds the act is not where it should be; None where it is near enough."""
        now = self._now()
        missing = self.wish.start - now.start
        if abs(missing) <= self.wish.near and self.wish.end is not None:
            missing = self.wish.end - end_of(now)
        return None if abs(missing) <= self.wish.near else missing

    def told(self) -> str:
        now = self._now()
        return f"it would be played from {now.start:.2f} s to {end_of(now):.2f} s, whatever its line says."

    def others_must_stay(self) -> None:
        """Raises `Stuck` where something moves that does not follow the act, or moves otherwise than it.

        What was written to start when the act has settled, or on a mark of it, moves with it.
        """
        assert self.after is not None
        act, now = self.wish.act, self._now()
        shifts = (now.start - act.start, now.settled - act.settled)
        low, high = min(0.0, *shifts) - NEAR, max(0.0, *shifts) + NEAR
        first = min(act.start, now.start) - NEAR
        moved = {one.order: one for one in self.after.acts}
        for one in self.before.acts:
            other = moved[one.order]
            by = other.start - one.start
            if one.order == act.order or abs(by) <= NEAR:
                continue
            if self.wish.still:
                raise Stuck("what stands behind it would be played at another time: write a `together:` in the text.")
            if one.start < first or not low - LOOSE <= by <= high + LOOSE:
                line = one.span.source.position(one.span.start)[0]
                raise Stuck(
                    f"then `{one.span.text.splitlines()[0]}` (line {line}) would move too, which does not follow it."
                )

    def _now(self) -> TimedAct:
        assert self.after is not None
        return next(one for one in self.after.acts if one.order == self.wish.act.order)


# ------------------------------------------------------------------------------------------------ text


def applied(text: str, changes: Iterable[Change]) -> str:
    """A text with changes made, none of which touches another."""
    for change in sorted(changes, key=lambda change: change.start, reverse=True):
        text = text[: change.start] + change.text + text[change.end :]
    return text


def tidied(text: str, changes: list[Change], after: str) -> Change:
    """Changes as one; where the script had the layout, it has it still: comments beside lines stay below each other."""
    start, end = min(change.start for change in changes), max(change.end for change in changes)
    grown = len(after) - len(text)
    first, last = after.rfind("\n", 0, start) + 1, after.find("\n", end + grown)
    around = after[after.rfind("\n", 0, max(first - 1, 0)) + 1 : after.find("\n", last + 1) if last >= 0 else None]
    if "#" in around or any(len(line) > WIDEST for line in around.split("\n")):
        laid = format_source(Source("", after))
        if laid != after and format_source(Source("", text)) == text:
            return _difference(text, laid)
    return Change(start, end, after[start : end + grown])


def _difference(text: str, after: str) -> Change:
    """The one stretch in which two texts differ."""
    head = 0
    while head < min(len(text), len(after)) and text[head] == after[head]:
        head += 1
    tail = 0
    while tail < min(len(text), len(after)) - head and text[-1 - tail] == after[-1 - tail]:
        tail += 1
    return Change(head, len(text) - tail, after[head : len(after) - tail])
