"""Turns a life into brow raises, there and back: in speech on accents, else now and then."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from facescript.motion.dice import Event, Waits
from facescript.motion.life.model import Accented, Living, Moved, accents, going_on, moved, pulses, remember, said
from facescript.motion.life.occasions import speech
from facescript.motion.life.stretches import Stretches
from facescript.performance.easing import through

LEAST = 0.5
"""Seconds from a raise to the next at least, on average: no knob makes a flutter of them."""

VARIATION = 0.6
"""Coefficient of variation of the others' intervals, as for blinks."""

APART = 0.4
"""Seconds that brows rest at least between two raises of the others (ours)."""

FAINTEST, STRONGEST = 0.2, 0.5
"""How far the frontalis contracts (ours: the thesis gives no sizes)."""

PEAK = 0.35
"""The share of a raise's length after which it is highest."""

LEAD = 0.06
"""Seconds by which the peak of a raise comes before that of the accent (Flecha-Garcia 2010; bar L4: 0 to 0.2)."""

RAISE = through((0.0, 0.0), (PEAK, 1.0), (0.6, 0.9), (1.0, 0.0))


@dataclass(frozen=True, slots=True)
class Raise:
    """One raise: seconds from the film's start, how high it goes, and how strong what calls for it is."""

    start: float
    end: float
    height: float
    strength: float


def brows(life: Living) -> Iterable[Moved]:
    """AU1 and AU2 of both sides, at the rate of the knob `brows` (1/min)."""
    station = life.station
    rate = life.knobs.get("brows", station.brow_rate if life.announcing else 0.0)
    if rate <= 0.0:
        return
    found = tuple(_announced(life, rate) if life.announcing else _of_talk(life, rate))
    marks = (Event(index, item.start, item.end) for index, item in enumerate(found))
    curve = pulses(marks, [item.height for item in found].__getitem__, RAISE)
    yield moved(curve, **{f"brow_{part}_{side}": 1.0 for part in ("inner", "outer") for side in ("left", "right")})


def _announced(life: Living, rate: float) -> Iterator[Raise]:
    """Raises at the thesis's intervals, whatever is said."""
    gaps = life.station.brow_gaps
    scale = 2.0 * _wait(life, rate) / sum(gaps)
    return _by_chance(life, lambda index: scale * life.dice.between(*gaps, "brows", index, "gap"))


def _of_talk(life: Living, rate: float) -> Iterator[Raise]:
    """Raises on accents while the face speaks, else by chance, both as often as `rate` says."""
    spoken: list[Raise] = []
    closed: list[tuple[float, float]] = []
    for name, line in said(life):
        remember(life, "brows", name, spoken)
        heard = accents(life, name, line)
        stretches = tuple(speech(line)) if heard else ()
        closed += stretches
        often = sum(end - start + _mean(life) for start, end in stretches) / _wait(life, rate, APART)
        for item in _on_accents(life, heard, often):
            if spoken and item.start < spoken[-1].end + APART:
                item = max(spoken.pop(), item, key=lambda one: one.strength)
            spoken.append(item)
    closed += [(item.start - APART, item.end + APART) for item in spoken]
    busy = Stretches(closed)
    idle = _by_chance(life, lambda index: life.dice.log_normal(_wait(life, rate), VARIATION, "brows", index, "gap"))
    yield from sorted(
        (*spoken, *(item for item in idle if busy.next(item.start)[0] >= item.end)), key=lambda item: item.start
    )


def _mean(life: Living) -> float:
    """The mean length of a raise, s."""
    return sum(life.station.brow_lengths) / 2.0


def _wait(life: Living, rate: float, apart: float = 0.0) -> float:
    """Mean seconds from the end of a raise to the start of the next, less those that are kept anyway."""
    return max(60.0 / rate - _mean(life) - apart, LEAST)


def _by_chance(life: Living, gap: Waits) -> Iterator[Raise]:
    dice, lengths = life.dice, life.station.brow_lengths
    for event in going_on(life, "brows", gap, lambda k: dice.between(*lengths, "brows", k, "length")):
        height = dice.between(FAINTEST, STRONGEST, "brows", event.index, "height")
        yield Raise(event.start, event.end, height, 0.0)


def _on_accents(life: Living, heard: Sequence[Accented], often: float) -> Iterator[Raise]:
    """About `often` raises on the accents of one line, rather on strong ones; each is drawn by itself."""
    total = sum(accent.strength**2 for accent in heard)
    for accent in heard:
        name, dice = f"brows {accent.line}", life.dice
        if dice.chance(name, accent.index, "happens") * total < often * accent.strength**2:
            length = dice.between(*life.station.brow_lengths, name, accent.index, "length")
            start = accent.time - LEAD - PEAK * length
            share = (accent.strength + dice.chance(name, accent.index, "height")) / 2.0
            height = FAINTEST + (STRONGEST - FAINTEST) * share
            if start >= life.start:
                yield Raise(start, start + length, height, accent.strength)
