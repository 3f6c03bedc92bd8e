"""Brows and head with the voice (L4, L5). Accents and pitch are found in the sound alone, by a tracker of its own."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from bars import Floats
from events import stretches
from hours import SENTENCES, Hour, Talk, talk
from playing import Playing, Studio
from sound import loudness, pitch, samples
from table import Measures, Row, row

from facescript.schedule.score import TimedLine

RAISED = 0.05
"""Contraction of the frontalis from which a brow is raised."""

NEAR = 0.5
"""How far from a raise's peak its accent may be, s."""


def raises(studio: Studio) -> Iterator[Row]:
    """Each raise of a speaker's brows beside the nearest accented syllable."""
    found = studio.once(talk)
    leads = [1000.0 * lead for hour in found.hours.values() for lead in _leads(found, hour)]
    middle = "..".join(f"{value:.0f}" for value in np.percentile(leads, [25, 75]))
    over = f"{len(leads)} raises in an hour of two faces; middle half {middle} ms"
    yield row("L4", "median", "brow's peak before the accented syllable's, median", [np.median(leads)], over)


def _leads(found: Talk, hour: Hour) -> Iterator[float]:
    accents = np.array([time for line in found.turns if line.face == hour.face for time in _accents(line)])
    brow = hour.trace.channels["brow.inner.left"]
    for first, last in stretches(brow > RAISED):
        raised = brow[first:last]
        peak = hour.trace.times[first + int(np.flatnonzero(raised >= 0.99 * raised.max())[0])]
        lead = accents - peak
        nearest = float(lead[np.abs(lead).argmin()])
        if abs(nearest) <= NEAR:
            yield nearest


def _accents(line: TimedLine) -> list[float]:
    """The peaks of the accented syllables of a line, s of the film: of its stressed vowels the half that stands out
    most by loudness and pitch together; a peak is where the vowel is loudest."""
    loud = loudness(samples(line.spoken), line.spoken.rate, 0.03)
    times, hertz = pitch(line.spoken)
    vowels = [phone for phone in line.spoken.phones if phone.stress]
    peaks, marks = [], []
    for phone in vowels:
        first, last = round(phone.start * line.spoken.rate), round(phone.end * line.spoken.rate)
        at = first + int(loud[first:last].argmax())
        within = hertz[(times >= phone.start) & (times <= phone.end)]
        highest = np.nanmax(within) if np.isfinite(within).any() else np.nanmean(hertz)
        peaks.append(line.start + at / line.spoken.rate)
        marks.append((float(loud[at]), float(highest)))
    standing = sum(_standard(np.array(column)) for column in zip(*marks, strict=True)) if marks else np.zeros(0)
    return [peak for peak, mark in zip(peaks, standing, strict=True) if mark >= np.median(standing)]


def _standard(values: Floats) -> Floats:
    return (values - values.mean()) / max(float(values.std()), 1e-9)


ASTRAY = 1.8
"""Pitch further from the middle of its line, as a factor, is a slip of the tracker: one frame outweighs a line."""

UTTERANCES = 36
OTHERS = 5
"""Utterances, and with how many others' heads each is tried for what chance gives."""


def correlations(studio: Studio) -> Iterator[Row]:
    """Multiple R of pitch on the head's yaw, pitch and roll over whole utterances, what chance gives taken off.

    Slow curves are alike by chance: pitch beside the head of another utterance has an R too. The share of variance
    that is explained is counted from there: R^2 = (own - chance) / (1 - chance).
    """
    says = [f'say "{" ".join(_sentence(3 * number + part) for part in range(3))}"' for number in range(UTTERANCES)]
    lines = "\nwait 700ms\n".join(says)
    playing = studio.play(f"film screen none, seed 7\nface ada = woman\n    life conversation\n{lines}\nwait 9s\n")
    spoken = playing.score.lines
    own = float(np.mean([_explained(playing, line, line) for line in spoken]))
    others = [(line, spoken[(at + step) % len(spoken)]) for at, line in enumerate(spoken) for step in range(1, OTHERS)]
    chance = float(np.mean([_explained(playing, line, other) for line, other in others]))
    found = np.sqrt(max(0.0, own - chance) / (1.0 - chance))
    over = f"{len(spoken)} utterances, life conversation; {own**0.5:.2f} as it is, {chance**0.5:.2f} by chance"
    yield row("L5", "mean", "multiple R of pitch on head rotation, chance taken off", [found], over)


def _sentence(number: int) -> str:
    return SENTENCES[number * 5 % len(SENTENCES)].replace(" |", "")


def _explained(playing: Playing, line: TimedLine, moved: TimedLine) -> float:
    """The share of the variance of a line's pitch that the head explains, as it is while this line or another is said:
    the square of multiple R."""
    times, hertz = pitch(line.spoken)
    heard = np.abs(np.log(hertz / np.nanmedian(hertz))) < np.log(ASTRAY)
    trace = playing.trace(moved.start, moved.start + times[-1] + 0.02)
    head = [np.interp(moved.start + times[heard], trace.times, trace.head(axis)) for axis in ("yaw", "pitch", "roll")]
    known = np.stack([*head, np.ones(heard.sum())], axis=1)
    wanted = hertz[heard]
    fitted = known @ np.linalg.lstsq(known, wanted, rcond=None)[0]
    unknown = float(((wanted - fitted) ** 2).sum() / ((wanted - wanted.mean()) ** 2).sum())
    return max(0.0, 1.0 - unknown)


MEASURES: Measures = {"L4": raises, "L5": correlations}
