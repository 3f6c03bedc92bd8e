"""How the announcer's movements are distributed, as a reader of the .csv finds it, against the thesis's statistics.

Everything is measured from an hour's channels at 1000 Hz. Between movements they are at rest exactly, so that each
onset and end is known to a millisecond.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from performing import Floats, line, score

from facescript.ir.acts import Life
from facescript.motion.perform import perform
from facescript.performance.channels import NAMES
from facescript.performance.limits import gaze_on_lid
from facescript.schedule.score import TimedLine

HOUR = 3600.0
RATE = 1000.0
PHRASES = 2.6, 1.4, 3.4, 1.2, 4.4, 1.6
"""Seconds of speech before each pause, again and again; each pause is of 0.4 s. Some leave no room for a nod."""

Law = Callable[[Floats], Floats]
"""A distribution: how likely each value is not to be exceeded."""


def uniform(low: float, high: float) -> Law:
    return lambda values: np.clip((values - low) / (high - low), 0.0, 1.0)


def gamma_of_two(scale: float) -> Law:
    return lambda values: 1.0 - np.exp(-values / scale) * (1.0 + values / scale)


LAWS: dict[str, Law] = {
    "blink interval": gamma_of_two(1.48),
    "brow interval": uniform(0.90, 12.54),
    "brow length": uniform(0.51, 0.99),
    "tilt interval": uniform(0.0, 6.64),
    "tilt length": uniform(0.4, 1.0),
    "turn interval": uniform(0.08, 7.92),
    "turn length": uniform(0.4, 0.92),
    "nod length": uniform(0.34, 0.94),
    "nod to pause": uniform(0.07, 0.35),
    "lift length": uniform(0.34, 0.70),
}
"""The thesis's statistics of announcers (chapter 4, adopted intervals)."""


def announcer_p_values(seed: int, rate: float = RATE) -> dict[str, float]:
    """The p of each of `LAWS` for an hour of an announcer who speaks, with more than 400 pauses; `rate` is rows a
    second."""
    found = measured(Life("announcer"), seed, HOUR, rate)
    return {name: kolmogorov_smirnov(values, LAWS[name]) for name, values in found.items()}


def kolmogorov_smirnov(values: Floats, law: Law) -> float:
    """How likely values of `law` are to lie further from it than these (Stephens 1970)."""
    count = len(values)
    expected = law(np.sort(values))
    furthest = max((np.arange(1, count + 1) / count - expected).max(), (expected - np.arange(count) / count).max())
    scaled = (np.sqrt(count) + 0.12 + 0.11 / np.sqrt(count)) * furthest
    terms = np.arange(1, 101)
    return float(np.clip(2.0 * ((-1.0) ** (terms - 1) * np.exp(-2.0 * (terms * scaled) ** 2)).sum(), 0.0, 1.0))


def measured(
    life: Life, seed: int, duration: float = HOUR, rate: float = RATE, phrases: Sequence[float] = PHRASES
) -> dict[str, Floats]:
    """The intervals and lengths (s) of each kind of movement of a `life` that speaks, by the names of `LAWS`."""
    spoken = speech(duration, phrases)
    found = {name: [] for name in ("lid", "brow", "head.roll", "head.yaw", "down", "up")}
    performance = perform(score((), duration, life, [spoken], seed))
    for drawn in minutes(performance.sample, duration, rate):
        lid = 1.0 - (1.0 - drawn["lid.left"]) / gaze_on_lid(drawn["eye.left.pitch"])
        found["lid"].append(np.abs(lid[1:]) > 1e-9)
        found["brow"].append(drawn["brow.inner.left"][1:] > 1e-9)
        found["head.roll"].append(np.diff(drawn["head.roll"]) != 0.0)
        found["head.yaw"].append(np.diff(drawn["head.yaw"]) != 0.0)
        found["down"].append(np.diff(drawn["head.pitch"]) < 0.0)
        found["up"].append(np.diff(drawn["head.pitch"]) > 0.0)
    each = {name: stretches(np.concatenate(parts), rate) for name, parts in found.items()}
    for name in ("head.roll", "head.yaw", "down", "up"):
        each[name] += np.array([0.5, -0.5]) / rate  # a movement shows in the steps it begins and ends in, too
    pauses = pauses_of(spoken)
    nearest = pauses[np.searchsorted(pauses, each["down"][:, 1])] if len(each["down"]) else np.zeros(0)
    return {
        "blink interval": gaps(each["lid"]),
        "brow interval": gaps(each["brow"]),
        "brow length": lengths(each["brow"]),
        "tilt interval": gaps(each["head.roll"]),
        "tilt length": lengths(each["head.roll"]),
        "turn interval": gaps(each["head.yaw"]),
        "turn length": lengths(each["head.yaw"]),
        "nod length": lengths(each["down"]),
        "nod to pause": nearest - each["down"][:, 1],
        "lift length": lengths(each["up"]),
    }


def minutes(sample: Callable[[Floats], Floats], duration: float, rate: float) -> Iterator[dict[str, Floats]]:
    """Channels by name, a minute at a time; each begins with the last row of the one before."""
    for start in np.arange(0.0, duration, 60.0):
        rows = np.arange(round(start * rate), round(min(start + 60.0, duration) * rate) + 1)
        yield dict(zip(NAMES, sample(rows / rate).T, strict=True))


def speech(duration: float, phrases: Sequence[float]) -> TimedLine:
    """One line from the first second on, with pauses."""
    phones, now, number = [], 0.0, 0
    while now < duration - 10.0:
        phrase = phrases[number % len(phrases)]
        phones += [("m", 0.1), ("a", 0.1)] * round(phrase / 0.2) + [("", 0.4)]
        now += 0.2 * round(phrase / 0.2) + 0.4
        number += 1
    return line(1.0, *phones)


def pauses_of(spoken: TimedLine) -> Floats:
    """When its pauses begin, s."""
    return np.array([spoken.start + phone.start for phone in spoken.spoken.phones if not phone.symbol])


def stretches(moving: Floats, rate: float) -> Floats:
    """Start and end (s) of every stretch in which something is so, but those that the trace cuts: array[stretch, 2]."""
    edges = np.flatnonzero(np.diff(moving.astype(np.int8))) + 1
    if moving[0]:
        edges = edges[1:]
    return edges[: len(edges) // 2 * 2].reshape(-1, 2) / rate


def gaps(found: Floats) -> Floats:
    """From the end of each to the start of the next."""
    return found[1:, 0] - found[:-1, 1]


def lengths(found: Floats) -> Floats:
    return found[:, 1] - found[:, 0]
