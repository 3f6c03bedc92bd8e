"""Scores made by hand, and what is performed of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.ir.acts import Add, Drop, Gesture, Life, Show, Timing, Verb, Voice
from facescript.ir.play import Face, Film
from facescript.ir.values import Driver, Mix, Term
from facescript.motion.perform import perform
from facescript.performance.channels import NAMES
from facescript.performance.performance import Performance
from facescript.schedule.score import FOREVER, Score, TimedAct, TimedLine, TimedScene
from facescript.speech.model import PhoneTime, Spoken
from facescript.text import Source, Span

HERE = Span(Source("made.face", ""), 0, 0)
STILL = Life("still")
SMILE = {"cheek.lower.left": 0.7, "cheek.lower.right": 0.7, "cheek.upper.left": 0.3, "cheek.upper.right": 0.3}
FROWN = {"brow.lower.left": 0.8, "brow.lower.right": 0.8, "lip.corner.left": 0.5, "lip.corner.right": 0.5}

Floats = NDArray[np.float64]


def term(name: str, drivers: dict[str, float], degree: float = 1.0) -> Term:
    return Term(name, degree, tuple(Driver(*pair) for pair in drivers.items()))


def mix(*terms: Term | dict[str, float]) -> Mix:
    return Mix(tuple(part if isinstance(part, Term) else term("made", part) for part in terms))


def act(verb: Verb, start: float, order: int = 0, *, drops: Sequence[tuple[int, int]] = (), scene: int = 0) -> TimedAct:
    """A show, add, drop or gesture in time, as the scheduler times it; its timing says `over`, `lasting`, `back`."""
    timing = getattr(verb, "timing", Timing())
    over, lasting, back = timing.over or 0.0, timing.lasting, timing.back or 0.0
    settled = start + (over if lasting is None else lasting)
    released = FOREVER if lasting is None or isinstance(verb, Drop) else start + lasting
    end = released + back
    return TimedAct(order, verb, "ada", scene, start, settled, released, end, HERE, drops=tuple(drops))


def show(
    start: float, *terms: Term | dict[str, float], order: int = 0, over: float = 0.5, lasting: float | None = None,
    ease: str | None = None, back: float = 0.4
) -> TimedAct:  # fmt: skip
    return act(Show(mix(*terms), Timing(over, lasting, back, ease)), start, order)


def add(
    start: float, *terms: Term | dict[str, float], order: int = 0, over: float = 0.4, lasting: float | None = None,
    ease: str | None = None, back: float = 0.4
) -> TimedAct:  # fmt: skip
    return act(Add(mix(*terms), Timing(over, lasting, back, ease)), start, order)


def drop(start: float, *dropped: tuple[int, int], order: int = 0, over: float = 0.5) -> TimedAct:
    return act(Drop("made", Timing(over)), start, order, drops=dropped)


def gesture(
    start: float, kind: str, far: dict[str, float], order: int = 0, degree: float = 1.0, lasting: float = 0.7
) -> TimedAct:
    return act(Gesture(kind, degree, mix(far), Timing(lasting=lasting)), start, order)  # type: ignore[arg-type]


def line(start: float, *phones: tuple[str, float], cut: float | None = None) -> TimedLine:
    """A line of phones with their lengths in seconds; "" is silence."""
    times, now = [], 0.0
    for symbol, length in phones:
        times.append(PhoneTime(symbol, now, now + length))
        now += length
    return TimedLine("ada", start, Spoken(b"", 16_000, now, (), tuple(times)), 1.0, HERE, cut=cut)


def score(
    acts: Sequence[TimedAct] = (), duration: float = 4.0, life: Life = STILL, lines: Sequence[TimedLine] = (),
    seed: int = 1, scenes: Sequence[TimedScene] = ()
) -> Score:  # fmt: skip
    face = Face("ada", "woman", Voice(), life, HERE)
    ordered = tuple(sorted(acts, key=lambda each: (each.start, each.order)))
    played = tuple(scenes) or (TimedScene("main", ("ada",), 0.0, duration),)
    return Score(Film(seed=seed, screen=1.0), (face,), (), played, ordered, tuple(lines), (), duration)


def performed(
    *acts: TimedAct, duration: float = 4.0, life: Life = STILL, lines: Sequence[TimedLine] = ()
) -> Performance:
    return perform(score(acts, duration, life, lines))


def channels(performance: Performance, times: Floats) -> dict[str, Floats]:
    """Every channel by name at `times`."""
    return dict(zip(NAMES, performance.sample(times).T, strict=True))


def grid(duration: float, rate: float = 1000.0) -> Floats:
    return np.arange(0.0, duration, 1.0 / rate)
