"""Expressions in time (E1 to E3): smiles posed and spontaneous, and how long a feeling stays. Life still.

A smile is the contraction of zygomaticus (`cheek.lower`); its onset speed is the peak speed of that.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from bars import Floats, Trace
from playing import Studio, script
from table import Measures, Row, row

DEGREES = (20, 40, 60, 80, 100)
APART = 8.0
"""Seconds from one expression to the next."""

SMILE = "cheek.lower.left"
RISE = 1.25
"""The rise from 10 to 90 % times this is the onset (bar E2)."""

SEEN = 0.02
"""A change of the face from its rest that is seen, as a part of its largest."""

FEELINGS = ("happiness", "sadness", "surprise", "fear", "anger", "disgust", "contempt", "smile", "frown")
LASTING = ("500ms", "1s", "2s", "4s", "5s")


def _smiles(studio: Studio, manner: str) -> list[Trace]:
    """Smiles of every degree, from a neutral face, until shortly before the next one."""
    shows = [f"at {APART * (number + 1):.0f}s: show smile {degree}%, {manner}" for number, degree in enumerate(DEGREES)]
    clears = [f"at {APART * (number + 1) + 5:.0f}s: show neutral" for number in range(len(DEGREES))]
    playing = studio.play(script(*shows, *clears, f"wait {APART * (len(DEGREES) + 1):.0f}s"))
    return [playing.trace(APART * (number + 1) - 0.1, APART * (number + 1) + 4.9) for number in range(len(DEGREES))]


def ratios(studio: Studio) -> Iterator[Row]:
    felt, posed = (_smiles(studio, manner) for manner in ("spontaneous", "posed"))
    found = [_onset_speed(one) / _onset_speed(other) for one, other in zip(felt, posed, strict=True)]
    over = f"degrees {', '.join(map(str, DEGREES))} %"
    yield row("E1", "ratio", "onset speed, spontaneous over posed smile", found, over)
    sizes = [one.channels[SMILE].max() / other.channels[SMILE].max() for one, other in zip(felt, posed, strict=True)]
    yield row("E1", "ratio", "size, spontaneous over posed smile", sizes, over)


def _onset_speed(trace: Trace) -> float:
    return float(trace.speed(trace.channels[SMILE])[:2000].max())


def onsets(studio: Studio) -> Iterator[Row]:
    found = [_onset(trace) for trace in _smiles(studio, "spontaneous")]
    yield row("E2", "mean", "onset of a spontaneous smile, mean", [np.mean(found)], f"{len(found)} degrees")


def _onset(trace: Trace) -> float:
    """Seconds from 10 to 90 % of the first height at which the smile slows to 5 % of its peak speed, times `RISE`."""
    values, speed = trace.channels[SMILE], trace.speed(trace.channels[SMILE])
    peak = int(speed[:2000].argmax())
    height = values[peak + int(np.flatnonzero(speed[peak:] <= 0.05 * speed[peak])[0])]
    first, last = (int(np.flatnonzero(values >= part * height)[0]) for part in (0.1, 0.9))
    return float(RISE * (trace.times[last] - trace.times[first]))


def totals(studio: Studio) -> Iterator[Row]:
    """Feelings that last as an author says, from when they are first to when they are last seen."""
    asked = [(feeling, lasting) for feeling in FEELINGS for lasting in LASTING]
    asked += [("smile", f"{lasting}, {manner}") for lasting in LASTING[1:4] for manner in ("posed", "spontaneous")]
    shows = [f"at {APART * number:.0f}s: show {feeling} for {lasting}"
             for number, (feeling, lasting) in enumerate(asked, start=1)]  # fmt: skip
    playing = studio.play(script(*shows, f"wait {APART * (len(asked) + 2):.0f}s"))
    found = [_seen(playing.trace(APART * number - 0.1, APART * (number + 1) - 0.1, 200.0))
             for number in range(1, len(asked) + 1)]  # fmt: skip
    yield row("E3", "any", "an expression in all, `show ... for 500ms` to `5s`", found, f"{len(found)} expressions")


def _seen(trace: Trace) -> float:
    """For how long the face differs from what it was at first, s."""
    moved: Floats = sum((np.abs(values - values[0]) for name, values in trace.channels.items() if _drawn(name)),
                        np.zeros(len(trace.times)))  # fmt: skip
    seen = np.flatnonzero(moved > SEEN * moved.max())
    return float(trace.times[seen[-1]] - trace.times[seen[0]])


def _drawn(name: str) -> bool:
    return name.split(".")[0] in ("brow", "forehead", "cheek", "nose", "lip", "chin", "lid", "mouth")


MEASURES: Measures = {"E1": ratios, "E2": onsets, "E3": totals}
