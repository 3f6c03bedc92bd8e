"""A show, an add or a gesture to the shortest time that the head and the eyes need for it.

No row of 1000 a second is 0.32 deg of head or 0.75 deg of gaze from the one before, and no step of speed is 10 deg/s of
head or 100 deg/s of eye: so a change that would be faster takes as long as it needs, but for one `over 0ms`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import sqrt

from facescript.diagnostics.wording import tell
from facescript.ir.acts import Add, Do, Gesture, Show, Verb
from facescript.ir.values import Amount, Draw, Mix
from facescript.schedule.deeds import Deed
from facescript.schedule.defaults import seconds
from facescript.schedule.faults import Faults
from facescript.schedule.voices import CLOSE
from facescript.space.main_sequence import EYE_CEILING, HEAD_HURRIED

HEAD = ("head.yaw", "head.pitch", "head.roll")
EYES = tuple(f"eye.{side}.{axis}" for side in ("left", "right") for axis in ("yaw", "pitch"))

HEAD_STROKE, EYE_STROKE = 10_000.0, 100_000.0
"""The greatest acceleration of head and eyes, deg/s^2."""

STEEPEST = 2.47
"""Peak speed over mean speed of the steepest curve, `in-out`."""

STROKE = 1.81
"""The greatest acceleration of any curve (that of `in` and `out`), over the square of `STEEPEST`."""

PACES = {"nod": 5.6, "shake": 13.6, "tilt": 5.4, "blink": 6.8, "wink": 6.8}
"""Peak speed of each gesture (`motion/gesture.py`), in far poses a length of it."""

BRIEFEST = 0.15
"""Seconds of the shortest blink and wink (0.1 to 0.4 s, `motion.md` 5): the eye turns with it, and two may overlap."""


def least_change(verb: Show | Add) -> float:
    """Seconds that its sum takes to come in or to go at least."""
    return _least(verb.mix, 1.0, STEEPEST)


def least_gesture(gesture: Gesture) -> float:
    """Seconds that a gesture lasts at least."""
    least = _least(gesture.mix, seconds(gesture.degree), PACES[gesture.kind])
    return max(least, BRIEFEST) if gesture.kind in ("blink", "wink") else least


def _least(mix: Mix, degree: float, pace: float) -> float:
    """Seconds for a sum, `pace` times as steep as a straight line."""
    far: dict[str, float] = {}
    for term in mix.terms:
        for driver in term.drivers:
            turned = degree * seconds(term.degree) * seconds(driver.value)
            far[driver.name] = far.get(driver.name, 0.0) + turned
    head, eye = (max(abs(far.get(name, 0.0)) for name in names) for names in (HEAD, EYES))
    turns = ((head, HEAD_HURRIED, HEAD_STROKE), (eye, EYE_CEILING, EYE_STROKE))
    return pace * max(max(angle / speed, sqrt(STROKE * angle / stroke)) for angle, speed, stroke in turns)


def unhurried(verb: Verb) -> Verb:
    """A concrete verb whose lengths are what the head and the eyes need; what jumps (`over 0ms`) still does."""
    if isinstance(verb, Gesture):
        length = seconds(verb.timing.lasting)
        length = max(length, least_gesture(verb)) if length else 0.0
        return replace(verb, timing=replace(verb.timing, lasting=length))
    if not isinstance(verb, (Show, Add)) or not (least := least_change(verb)):
        return verb
    timing, over = verb.timing, seconds(verb.timing.over)
    lasting = timing.lasting if timing.lasting is None or not over else max(seconds(timing.lasting), least)
    back = max(seconds(timing.back), least) if seconds(timing.back) else 0.0
    return replace(verb, timing=replace(timing, over=max(over, least) if over else 0.0, lasting=lasting, back=back))


def hurried(deeds: Iterable[Deed], faults: Faults) -> None:
    """Report what is written to be faster than heads and eyes can be, and how long it takes (FS608)."""
    for deed in deeds:
        if isinstance(deed.verb, (Show, Add, Gesture)):
            needs = _raised(deed)
            if needs:
                faults.add("FS608", deed.step.node.span, needs=tell(needs))


def _raised(deed: Deed) -> float:
    """The longest of a deed's lengths that was written shorter, s; 0 where none was."""
    node = deed.step.node
    assert isinstance(node, Do) and isinstance(node.verb, (Show, Add, Gesture))
    assert isinstance(deed.verb, (Show, Add, Gesture))
    made, written = deed.verb.timing, node.verb.timing
    pairs = [(getattr(made, name), getattr(written, name)) for name in ("over", "lasting", "back")]
    return max((now for now, was in pairs if was is not None and now > _longest(was) + CLOSE), default=0.0)


def _longest(amount: Amount) -> float:
    return amount.high if isinstance(amount, Draw) else amount
