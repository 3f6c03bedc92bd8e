"""An act, one of its handles and how far it is dragged, to the smallest edit of the script that does it, or to why not.

What an edit does is not foreseen but seen: the script is compiled with it, and only one that moves the act as it was
asked, and nothing that should stay, is given.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from facescript.compile import Compiled
from facescript.preview.dragging.allowed import Allowed
from facescript.preview.dragging.amounts import Change, Stuck
from facescript.preview.dragging.degrees import degree
from facescript.preview.dragging.effect import Effect, applied, tidied
from facescript.preview.dragging.lengths import SHORTEST, end_of
from facescript.preview.dragging.tries import Handle, Tries, Try
from facescript.schedule.score import TimedAct

LATEST = 4 * 3600.0
"""Seconds up to which an act may be dragged: so long is a film."""

ROUNDS = 4
"""How often an edit is made anew with what was missing to the asked time: a `wait` takes a pause's place, a look takes
as long as eyes have to go."""

BASE = {"%": "1", "m": "cm"}
"""What values are in, by the unit that they are written in."""

Again = Callable[[str], Compiled]
"""Another text of the script, compiled. It must leave what was compiled before as it is."""

Range = dict[str, float | str]


@dataclass(frozen=True, slots=True)
class Refused:
    """A drag that cannot be an edit: what was dragged, and a sentence that says why not."""

    what: str
    why: str


class Drags:
    """The acts of a script that has a score, as they may be dragged."""

    def __init__(self, compiled: Compiled) -> None:
        assert compiled.score is not None
        self._compiled, self._score = compiled, compiled.score

    @cached_property
    def _allowed(self) -> Allowed:
        return Allowed(self._compiled.script, self._score)

    def handles(self, act: TimedAct) -> dict[str, Range]:
        """The handles of an act that may be dragged, each with the `least` and `most` that it may come to.

        Those are seconds from the film's start; of `degree` they are in its `unit`, which is 1, `deg` or `cm`, and
        `now` is what it is. A drag may be refused all the same, by what else would move.
        """
        try:
            tries = self._tries(act)
        except Stuck:
            return {}
        ends = tries.may_end()
        found = self._starts(tries, ends)
        if ends:
            found["end"] = {"least": act.start + SHORTEST, "most": LATEST}
        try:
            strong = degree(tries.said)
        except Stuck:
            return found
        unit = BASE.get(strong.unit, strong.unit)
        return {**found, "degree": {"least": strong.least, "most": strong.most, "now": strong.now, "unit": unit}}

    def drag(
        self, act: TimedAct, handle: Handle, by: float, again: Again, release: float | None = None
    ) -> Change | Refused:
        """The edit that moves a handle by so many seconds; of `degree`, that makes it `by`.

        `release` is until when an act is seen that lasts until something takes its place, for its `end`. A change that
        is too small to be written is one of nothing.
        """
        why = ""
        try:
            for attempt in self._tries(act).of(handle, by, release):
                try:
                    return self._made(attempt, again)
                except Stuck as stuck:
                    why = why or str(stuck)
        except Stuck as stuck:
            why = why or str(stuck)
        line, _ = act.span.source.position(act.span.start)
        return Refused(f"`{act.span.text.splitlines()[0].rstrip()}` (line {line})", why)

    def _tries(self, act: TimedAct) -> Tries:
        """Raises `Stuck` where the statement of an act may not be changed."""
        return Tries(self._allowed.said(act), act, act.start - self._score.scenes[act.scene].start)

    def _starts(self, tries: Tries, ends: bool) -> dict[str, Range]:
        """The handles that move an act's start; `ends` is whether its end may be dragged."""
        act = tries.act
        try:
            forward = min(way.least for way in tries.starts())
        except Stuck:
            return {}
        least = max(self._score.scenes[act.scene].start, act.start + forward)
        found: dict[str, Range] = {"body": {"least": least, "most": LATEST}}
        if not tries.has_length():
            return {"start": {"least": least, "most": LATEST}, **found}
        return {"start": {"least": least, "most": end_of(act) - SHORTEST}, **found} if ends else found

    def _made(self, attempt: Try, again: Again) -> Change:
        """The edit, once it brings about what is wished. Raises `Stuck`."""
        text, more = self._compiled.source.text, 0.0
        told: Stuck | None = None
        for _ in range(ROUNDS):
            try:
                changes = attempt.changes(more)
            except Stuck as stuck:
                raise told or stuck from None
            after = applied(text, changes)
            effect = Effect(self._score, again(after).score, attempt.wish)
            effect.must_be_solved()
            missing = effect.missing()
            if missing is None:
                effect.others_must_stay()
                return tidied(text, changes, after)
            more, told = more + missing, Stuck(effect.told())
        assert told is not None
        raise told
