"""The size of a gaze shift to its timing: how long eyes and head take, how they speed up, when the head follows.

The laws are those of motion.md: section 1 "Recommended generator" for the eyes, section 2 for the head. Degrees and
seconds; durations are for `speed` 100 %.
"""

from __future__ import annotations

from functools import lru_cache
from math import exp, lgamma, log

PEAK_OVER_MEAN = 1.65
"""Q of a saccade: its peak velocity over its mean velocity (bar S4)."""

SATURATION = 530.0
"""The fastest an eye turns unhurried, deg/s: speed hardly grows with the largest saccades (bar S5)."""

HEAD_CEILING = 185.0
"""The fastest a head turns unhurried, deg/s (bar H6)."""

HURRY = 2.0
"""How many times as fast as usual eyes and head can be made to move."""

EYE_CEILING, HEAD_HURRIED = 550.0, 250.0
"""The fastest an eye and a head turn when they are hurried, deg/s. People's largest saccades come to 700; ours leave
room for what is added, so that no row of 1000 a second is 0.75 deg of gaze or 0.32 of head from the one before."""

CONVERGE_SHARE, DIVERGE_SHARE = 0.5, 0.7
"""The part of a change of vergence done inside a saccade of 20 deg or more (bar V2)."""

VERGENCE_TIME = 0.5
"""How long the rest of a change of vergence takes, s (section 4: pure vergence takes 0.4 to 1 s)."""


def saccade_time(amplitude: float) -> float:
    """Duration of a saccade of `amplitude` deg: 2.7 ms a degree and 25 ms (bar S1), and above 60 deg as long as the
    `SATURATION` of its speed makes it."""
    return max((2.7 * amplitude + 25.0) / 1000.0, PEAK_OVER_MEAN * amplitude / SATURATION)


def least_saccade_time(amplitude: float) -> float:
    """The shortest a saccade of `amplitude` deg can be made: half its duration, and not faster than `EYE_CEILING`."""
    return max(saccade_time(amplitude) / HURRY, PEAK_OVER_MEAN * amplitude / EYE_CEILING)


def peak_fraction(duration: float) -> float:
    """When in a saccade's course it is fastest, as a part of its `duration`; it depends on that alone (bar S6).

    It falls to 0.30 at 42 deg (0.25 to 0.3 at 40 to 50, `motion.md` 1): earlier, the largest would set off with a jolt.
    """
    return min(0.5, max(0.30, 0.47 - 0.004 * (duration * 1000.0 - 25.0) / 2.7))


@lru_cache(maxsize=4096)
def velocity_shape(duration: float) -> tuple[float, float]:
    """The exponents (a, b) of the velocity profile x^(a-1) (1-x)^(b-1) of a saccade of `duration`.

    They are the beta density with its mode at `peak_fraction` and its peak `PEAK_OVER_MEAN` (table of section 1).
    """
    mode = peak_fraction(duration)
    low, high = 0.1, 20.0
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if _peak(mode, middle) < PEAK_OVER_MEAN else (low, middle)
    return 1.0 + mode * low, 1.0 + (1.0 - mode) * low


def _peak(mode: float, weight: float) -> float:
    """The greatest value of the beta density whose mode is `mode` and whose a + b is 2 + `weight`."""
    a, b = 1.0 + mode * weight, 1.0 + (1.0 - mode) * weight
    return exp(lgamma(a + b) - lgamma(a) - lgamma(b) + (a - 1) * log(mode) + (b - 1) * log(1 - mode))


def head_lag(amplitude: float) -> float:
    """How long after the eyes the head sets off, for a gaze shift of `amplitude` deg (bar H1)."""
    return min(140.0, max(0.0, 139.0 - 89.0 / 30.0 * (amplitude - 10.0))) / 1000.0


def head_time(turn: float) -> float:
    """Duration of a minimum-jerk head movement of `turn` deg, never faster than `HEAD_CEILING` (bar H6)."""
    return max((300.0 + 4.5 * turn) / 1000.0, 1.875 * turn / HEAD_CEILING)


def least_head_time(turn: float) -> float:
    """The shortest a head movement of `turn` deg can be made: half its duration, not faster than `HEAD_HURRIED`."""
    return max(head_time(turn) / HURRY, 1.875 * turn / HEAD_HURRIED)


def minimum_jerk(part: float) -> float:
    """How far a minimum-jerk movement is after `part` 0..1 of its time."""
    x = min(1.0, max(0.0, part))
    return x * x * x * (10.0 - 15.0 * x + 6.0 * x * x)


def vergence_share(amplitude: float, converging: bool) -> float:
    """The part of a change of vergence done inside a saccade of `amplitude` deg, none in none (bar V2)."""
    return (CONVERGE_SHARE if converging else DIVERGE_SHARE) * min(1.0, amplitude / 20.0)


SERIES = 30
"""Terms of the power series of the beta distribution; at 1/2 the rest is below 1e-11."""


@lru_cache(maxsize=4096)
def position_series(duration: float) -> tuple[tuple[float, float, tuple[float, ...]], ...]:
    """The course of a saccade of `duration` as two power series, for its first half and, run backwards, its second.

    Each is (a, 1/B, c): after a part x <= 1/2 the eye has gone x^a/B * (c[0] + c[1] x + ...) of its way, which is the
    distribution of the beta density of `velocity_shape`.
    """
    a, b = velocity_shape(duration)
    scale = exp(lgamma(a + b) - lgamma(a) - lgamma(b))
    return (a, scale, _series(a, b)), (b, scale, _series(b, a))


def _series(a: float, b: float) -> tuple[float, ...]:
    terms, factor = [], 1.0
    for n in range(SERIES):
        terms.append(factor / (a + n))
        factor *= (n + 1 - b) / (n + 1)
    return tuple(terms)


def saccade_part(part: float, duration: float) -> float:
    """How far a saccade of `duration` s is after `part` 0..1 of it."""
    x = min(1.0, max(0.0, part))
    first, second = position_series(duration)
    return _half(x, first) if x <= 0.5 else 1.0 - _half(1.0 - x, second)


def _half(x: float, half: tuple[float, float, tuple[float, ...]]) -> float:
    power, scale, terms = half
    total = 0.0
    for term in reversed(terms):
        total = total * x + term
    return float(scale * total * x**power)
