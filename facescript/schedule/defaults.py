"""A verb as an author wrote it to the verb that is played: draws drawn by the seed, lengths filled in."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import fields, is_dataclass, replace
from functools import cache
from typing import Any, TypeVar, cast

from facescript.ir.acts import Add, Drop, Gesture, Glance, Perform, Say, Show, Timing, Verb
from facescript.ir.random import between
from facescript.ir.values import Amount, Draw
from facescript.text import Span

OVER = {"Show": 0.5, "Add": 0.4, "Drop": 0.5}
"""Seconds of a change. A spontaneous smile's onset takes 0.40 to 0.75 s (motion.md 6.1); a drop is as slow."""

BACK = 0.4
"""Seconds a show or an add takes to let go: offsets are a little faster than slow onsets."""

MANNERS = {"posed": (0.6, 0.6), "spontaneous": (1.0, 1.4)}
"""Seconds in which a show or an add of a manner comes and lets go. With `NATURAL` curves a spontaneous one takes 0.53 s
by bar E2's measure (a spontaneous smile's onset: 0.40 to 0.75 s), a posed one 0.32 s. Offsets are slower where they are
spontaneous (motion.md 6.1; the study of 2006 found them longer where they were posed, that of 2018 is followed)."""

NATURAL = "out"
"""The curve of a manner: a quick attack that eases into the apex, and a release that is slower at its end."""

LASTING = {"nod": 0.7, "shake": 0.9, "tilt": 0.9, "blink": 0.3, "wink": 0.4}
"""Lengths of gestures, s. A blink takes 0.2 to 0.4 s in all (motion.md 5); a nod of an announcer 0.34 to 0.94 s."""

JOINED = 0.2
"""Seconds in which a recorded face comes in, and lets go."""

GLANCE = 0.5
"""A glance is "half a second" (language.md, the table of what settles when)."""

PLAIN = {float, int, bool, str, type(None)}
"""What holds no draw."""

Place = Callable[[], tuple[Hashable, ...]]
"""Where a draw stands in the script; asked only where there is something to draw."""

Whole = TypeVar("Whole")


class Concrete:
    """Makes verbs concrete for one seed. A verb without draws is made once, however often it is played."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self._same: dict[int, Verb] = {}

    def verb(self, verb: Verb, place: Place) -> Verb:
        """The verb with plain numbers and the lengths that the table of verbs gives it."""
        known = self._same.get(id(verb))
        if known is not None:
            return known
        if isinstance(verb, Say) or not has_draw(verb):
            made = self._same[id(verb)] = filled(verb)
            return made
        return filled(self.drawn(verb, place))

    def amount(self, amount: Amount, place: Place, what: str) -> float:
        """A number, drawn by the seed where it is a draw; `what` tells the draws of one statement apart."""
        if isinstance(amount, Draw):
            return between(amount.low, amount.high, self.seed, *place(), what)
        return amount

    def drawn(self, whole: Whole, place: Place, what: str = "") -> Whole:
        """A value of the play with every draw in it drawn."""
        if isinstance(whole, Draw):
            return cast(Whole, self.amount(whole, place, what))
        if isinstance(whole, tuple):
            parts = (self.drawn(part, place, f"{what}.{index}") for index, part in enumerate(whole))
            return cast(Whole, tuple(parts))
        if not is_dataclass(whole) or isinstance(whole, (type, Span)):
            return whole
        names = _fields(type(whole))
        changed = {name: self.drawn(getattr(whole, name), place, f"{what}.{name}") for name in names}
        return cast(Whole, replace(whole, **changed))


def has_draw(value: object) -> bool:
    """Whether a value of the play holds a draw."""
    kind: Any = type(value)
    if kind is Draw:
        return True
    if kind is tuple:
        parts: Iterable[object] = cast(tuple[object, ...], value)
    else:
        parts = [getattr(value, name) for name in _fields(kind)]
    return any(type(part) not in PLAIN and has_draw(part) for part in parts)


def filled(verb: Verb) -> Verb:
    """The verb with the lengths that an author left to the table."""
    if isinstance(verb, (Show, Add)):
        manner = verb.timing.manner
        over, back = MANNERS.get(manner, (OVER[type(verb).__name__], BACK))
        return replace(verb, timing=_timing(verb.timing, over=over, back=back, ease=NATURAL if manner else None))
    if isinstance(verb, Drop):
        return replace(verb, timing=_timing(verb.timing, over=OVER["Drop"]))
    if isinstance(verb, Gesture):
        return replace(verb, timing=_timing(verb.timing, lasting=LASTING[verb.kind]))
    if isinstance(verb, Glance):
        return replace(verb, timing=_timing(verb.timing, lasting=GLANCE))
    if isinstance(verb, Perform):
        whole = verb.take.duration / seconds(verb.speed)
        lasting = whole if verb.timing.lasting is None else min(whole, seconds(verb.timing.lasting))
        return replace(verb, timing=Timing(JOINED, lasting, JOINED))
    return verb


def _timing(
    timing: Timing,
    over: float | None = None,
    lasting: float | None = None,
    back: float | None = None,
    ease: str | None = None,
) -> Timing:
    return Timing(
        over if timing.over is None else timing.over,
        lasting if timing.lasting is None else timing.lasting,
        back if timing.back is None else timing.back,
        timing.ease or ease,
        timing.manner,
    )


def seconds(amount: Amount | None) -> float:
    """The seconds of a length that is drawn and filled in."""
    assert isinstance(amount, (int, float))
    return float(amount)


@cache
def _fields(kind: type[Any]) -> tuple[str, ...]:
    """The names of what a value of the play consists of; nothing for a place in the text."""
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) and kind is not Span else ()
