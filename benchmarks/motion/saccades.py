"""Saccades (S1 to S8). The head is still: `eyes only`, screen none.

Onset and end for S1, S4 and S6 are where speed first and last exceeds 2 % of its peak, as S1 asks; S7 has the rule of
all other bars, 5 %. Position is the mean of both eyes along the saccade's way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import hypot

import numpy as np
from bars import Movement, Trace, movement
from playing import Place, Shift, Studio, eye_height, on_way, place_words, script, shifts, speed_of, towards_words
from table import Measures, Row, bars, row, row_between

ONSET_SHARE = 0.02
"""The share of the peak speed at which a saccade begins and ends (bar S1)."""

SIZES = (5, 7, 10, 12, 15, 17, 20, 25, 30, 40)
WAYS = tuple(range(0, 360, 45))

REACH = (45.0, 28.0, 47.0)
"""How far eyes turn sideways, up and down, deg (bar S8); shifts that end beyond `EASY` of it are left out."""

EASY = 0.9

RATE = 2000.0

SACCADE = 30.0
"""Gaze faster than this is a saccade, deg/s."""

SLOWED = 0.5
"""Saccades at this speed last as long as larger ones, and should have their shape (bar S6)."""


def places(size: float, way: float) -> Iterator[tuple[Place, Place]]:
    """Up to five shifts of a size in a direction: from ahead, to ahead, across it, and across two places aside."""
    far, middle = on_way(size, way), (0.0, 0.0)
    half = far[0] / 2, far[1] / 2
    yield middle, far
    yield (-far[0], -far[1]), middle
    for x, y in ((0.0, 0.0), (8.0, 5.0), (-8.0, -5.0)):
        yield (x - half[0], y - half[1]), (x + half[0], y + half[1])


def reached(place: Place) -> bool:
    side, up, down = REACH
    return hypot(place[0] / side, place[1] / (up if place[1] > 0 else down)) <= EASY


def grid(size: float) -> list[tuple[Place, Place]]:
    return [pair for way in WAYS for pair in places(size, way) if all(map(reached, pair))]


def saccade(shift: Shift) -> Movement:
    return movement(shift.trace, shift.trace.eye("yaw"), ONSET_SHARE)


Saccades = dict[int, list[tuple[Shift, Movement]]]


def _saccades(studio: Studio) -> Saccades:
    """The saccades of every size."""
    found = {}
    for size in SIZES:
        made = shifts(studio, grid(size), "eyes only", 0.4, RATE)
        found[size] = [(shift, saccade(shift)) for shift in made]
    return found


def _over(found: Sequence[object]) -> str:
    return f"{len(found)} shifts: eight directions, up to five places"


def durations(studio: Studio) -> Iterator[Row]:
    found = studio.once(_saccades)
    lasts = {size: [each.lasts_ms for _, each in found[size]] for size in SIZES if size <= 30}
    for case in bars()["S1"].cases:
        yield row("S1", case, f"duration, {case} deg; 2 % of peak", lasts[int(case)], _over(lasts[int(case)]))
    between = {size: each for size, each in lasts.items() if str(size) not in bars()["S1"].cases}
    yield row_between("S1", "duration, other sizes", between, f"{sum(map(len, between.values()))} shifts")
    quality = [each.peak_over_mean for size in SIZES if size <= 30 for _, each in found[size]]
    yield row("S4", "5..30", "peak over mean speed, 5 to 30 deg", quality, _over(quality))


def peaks(studio: Studio) -> Iterator[Row]:
    for bar, axis, name in (("S2", 0.0, "horizontal"), ("S3", 90.0, "vertical")):
        found = {
            size: [each.peak for shift, each in made if abs(abs(shift.way) - 90.0) == abs(axis - 90.0)]
            for size, made in studio.once(_saccades).items()
        }
        cases = bars()[bar].cases
        for case in cases:
            yield row(bar, case, f"peak speed, {name}, {case} deg", found[int(case)], f"{len(found[int(case)])} shifts")
        most = max(map(float, cases))
        others = {size: each for size, each in found.items() if str(size) not in cases and size <= most}
        count = sum(map(len, others.values()))
        yield row_between(bar, f"peak speed, {name}, other sizes", others, f"{count} shifts")
    yield from _saturation(studio.once(_saccades))


def _saturation(found: Saccades) -> Iterator[Row]:
    """S5: every way in which 40 deg can be reached, beside the mean of 20 deg in that way."""
    usual = {way: np.mean([each.peak for shift, each in found[20] if round(shift.way) % 360 == way]) for way in WAYS}
    ratios = [each.peak / usual[round(shift.way) % 360] for shift, each in found[40]]
    yield row("S5", "40/20", "peak speed at 40 deg over that at 20", ratios, f"{len(ratios)} shifts of 40 deg")


def shapes(studio: Studio) -> Iterator[Row]:
    found = studio.once(_saccades)
    for case in ("5", "30"):
        parts = [each.peak_part for _, each in found[int(case)]]
        yield row("S6", case, f"when speed peaks, of the duration, {case} deg", parts, _over(parts))
    slow = shifts(studio, [pair for size in (5, 10, 15) for pair in grid(size)], f"eyes only, speed {SLOWED:.0%}", 0.6)
    every = [each for size in SIZES for _, each in found[size]] + [saccade(shift) for shift in slow]
    ordered = sorted(every, key=lambda each: each.lasts_ms)
    parts = np.array_split([each.peak_part for each in ordered], 12)
    groups = [float(part.mean()) for part in parts]
    falls = all(later <= part + 0.01 for part, later in pairwise(groups))
    over = f"{len(every)} saccades, {len(slow)} of them at `speed {SLOWED:.0%}`, in twelve groups by duration"
    yield row(
        "S6", "monotone non-increasing", "the longer it lasts the sooner, slow ones too (1 is yes)", [falls], over
    )


SEEDS = range(5)
JUMPS = 40
"""Jumps of a followed target, for each seed."""


def latencies(studio: Studio) -> Iterator[Row]:
    """A target that is followed jumps, at times and to places that nobody can foresee."""
    found = [late for seed in SEEDS for late in _jumps(studio, np.random.default_rng(seed))]
    over = f"{len(found)} jumps of 4 to 40 deg at random times, {len(SEEDS)} seeds; 5 % of peak"
    yield row("S7", "mean", "latency to a jump, mean", [np.mean(found)], over)
    yield row("S7", "each of 95%", "latency to a jump, middle 95 %", np.percentile(found, [2.5, 97.5]), over)


def _jumps(studio: Studio, dice: np.random.Generator) -> Iterator[float]:
    times, places = [1.0], [(0.0, 0.0)]
    while len(places) <= JUMPS:
        there = float(dice.uniform(-22, 22)), float(dice.uniform(-12, 12))
        if 4.0 <= hypot(there[0] - places[-1][0], there[1] - places[-1][1]) <= 40.0:
            places.append(there)
            times.append(times[-1] + float(dice.uniform(1.0, 2.5)))
    words = [place_words(place, 300.0, studio.once(eye_height)) for place in places]
    keys = [f"    0s {words[0]}"]
    for time, before, after in zip(times, words, words[1:], strict=False):
        keys += [f"    {time:.4f}s {before}", f"    {time + 0.001:.4f}s {after}"]
    playing = studio.play(script("look at jumper", f"wait {times[-1]:.3f}s", "target jumper moves", *keys))
    for time in times[:-1]:
        yield 1000.0 * (_first_onset(playing.trace(time, time + 0.6)) - time)


def _first_onset(trace: Trace) -> float:
    """When the first saccade begins: 5 % of its peak speed."""
    speed = speed_of(trace, "gaze")
    fast = int(np.flatnonzero(speed > SACCADE)[0])
    still = np.flatnonzero(speed[: fast + 1] <= 0.05 * speed[fast : fast + 60].max())
    return float(trace.times[still[-1] + 1])


def reach(studio: Studio) -> Iterator[Row]:
    """Looks beyond all reach with a lively head; the rows of S8 are made from all traces of the run (`extremes`)."""
    far = [on_way(size, way) for size in (40.0, 85.0) for way in range(0, 360, 30)]
    words = [towards_words((yaw, float(np.clip(pitch, -70.0, 55.0)))) for yaw, pitch in far]
    for manner in ("", ", eyes only", ", head then eyes", ", head 10%"):
        lines = [f"at {index + 1}s: look {place}{manner}" for index, place in enumerate(words)]
        turns = [
            f"at {index + 1.2:.1f}s: add head.yaw {30 * (-1) ** index}deg for 300ms" for index in range(len(words))
        ]
        playing = studio.play(script(*lines, *turns, f"wait {len(words) + 3}s", life="conversation"))
        playing.trace(0.0, playing.duration)
    return iter(())


def extremes(furthest: dict[str, float]) -> list[Row]:
    """S8, from the furthest that any eye turned in all traces."""
    return [
        row("S8", side, f"eye in head, furthest {name}", [furthest[side]], "all traces of this run")
        for side, name in (("yaw", "aside"), ("up", "up"), ("down", "down"))
    ]


MEASURES: Measures = {"S1 S4": durations, "S2 S3 S5": peaks, "S6": shapes, "S7": latencies, "S8": reach}
