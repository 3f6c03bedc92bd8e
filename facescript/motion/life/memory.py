"""What a face's life did up to a moment to what it takes to go on from there, so that nothing is worked out again.

Every draw of a life is a hash, so a behaviour that goes on needs no more than where it is: its last movement, and since
when it waits for the next. A film needs none of this; a run does, in which a scene may last for days.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from math import inf
from typing import Any

from facescript.ir.acts import SetLife
from facescript.motion.dice import Dice, Event
from facescript.motion.life.occasions import Earlier, Occasions, Turn, shift_name, text_of
from facescript.motion.life.stretches import Stretches
from facescript.schedule.score import TimedAct, TimedLine

Key = tuple[object, ...]
"""What a behaviour is known by: the place of its dice, and its name."""


MOST = 1024
"""Names of which it is remembered how often each was there."""


@dataclass(slots=True)
class _Renewing:
    """The events of a renewal process, since when it had waited at first, and when none of them could begin."""

    rest: float
    closed: Stretches
    found: list[Event] = field(default_factory=list)

    def at(self, time: float) -> tuple[tuple[Event, ...], float] | None:
        """Its last two events before a time, and since when it waits for the next."""
        past = tuple(event for event in self.found if event.start < time)[-2:]
        rest = past[-1].end if past else self.rest
        return past, max(rest, self.closed.last_end(time))


@dataclass(slots=True, eq=False)
class Memory:
    """One face's in a scene: nothing it does before `since` (s) is asked for, and `earlier` is what it did up to then.
    While a life is worked out its behaviours find their states there, and note what they come to."""

    since: float = -inf
    earlier: Earlier = field(default_factory=Earlier)
    _states: dict[Key, Any] = field(default_factory=dict)
    _noted: dict[Key, list[tuple[float, Any]]] = field(default_factory=dict)
    _renewing: dict[Key, _Renewing] = field(default_factory=dict)
    _occasions: Occasions | None = None

    def state(self, dice: Dice, behaviour: str) -> Any:
        """That of a behaviour at `since`; None where it had not begun."""
        return self._states.get((dice.place, behaviour))

    def note(self, dice: Dice, behaviour: str, time: float, state: Any) -> None:
        """The state of a behaviour from a time on; times rise."""
        self._noted.setdefault((dice.place, behaviour), []).append((time, state))

    def renewing(self, dice: Dice, behaviour: str, rest: float, closed: Stretches) -> list[Event]:
        """Where a renewal process notes its events; it waits since `rest`."""
        key = dice.place, behaviour
        self._renewing[key] = _Renewing(rest, closed)
        return self._renewing[key].found

    def begin(self, occasions: Occasions) -> None:
        """Its life is worked out anew."""
        self._noted, self._renewing, self._occasions = {}, {}, occasions

    def pass_to(self, time: float, lines: Iterable[TimedLine], acts: Iterable[TimedAct], first: float) -> Memory:
        """What is remembered at a later time, of the life as it was worked out last. The `lines` and `acts` are told of
        no more; the first line that still is starts at `first` s."""
        states: dict[Key, Any] = {}
        for key, rows in self._noted.items():
            past = [state for noted, state in rows if noted < time]
            states[key] = past[-1] if past else self._states.get(key)
        for key, process in self._renewing.items():
            states[key] = process.at(time)
        turn = self._occasions.turn_before(first) if self._occasions else None
        return Memory(time, _later(self.earlier, lines, acts, turn), states)


def _later(earlier: Earlier, lines: Iterable[TimedLine], acts: Iterable[TimedAct], turn: Turn | None) -> Earlier:
    acts = list(acts)
    lived = (act.verb.life.name for act in acts if isinstance(act.verb, SetLife))
    return Earlier(
        _counted(earlier.said, map(text_of, lines)),
        _counted(earlier.shifted, (shift_name(act) for act in acts if act.plan)),
        _counted(earlier.lived, lived),
        turn,
    )


def _counted(before: Counter[str], names: Iterable[str]) -> Counter[str]:
    """Counts with those of further names; the oldest names go where there are too many."""
    counts = Counter(before)
    for name in names:
        counts[name] = counts.pop(name, 0) + 1
        while len(counts) > MOST:
            del counts[next(iter(counts))]
    return counts
