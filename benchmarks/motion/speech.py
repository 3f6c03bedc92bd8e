"""The mouth and its sound (L1 to L3). Sound is judged by itself; the voice's events only say where to look.

A lead is + where the mouth is first. A mouth begins to open, or to move, where its speed exceeds 5 % of that movement's
peak. A burst is heard where loudness has risen by 5 % from the closure's to the syllable's greatest, the vowel after an
m, which murmurs, by 30 %.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import film
import numpy as np
from bars import ONSET_SHARE, Trace
from events import stretches
from playing import Playing, Studio, script
from sound import heard, loudness, samples
from table import Measures, Row, row

from facescript.schedule.score import TimedLine
from facescript.speech.model import PhoneTime

SYLLABLES = ("pah", "bah", "tah", "dah", "mah", "bee", "moo", "too")
MANNERS = ("", ", rate 80%", ", rate 120%", ", pitch 120%")
VOWELS = set("aɑæɐʌeɛiɪoɔuʊəɜ")

STOP_HEARD, NASAL_HEARD = 0.05, 0.3
"""The share of the rise of loudness from which a syllable is heard."""

OPENED = 0.1
"""How far the mouth opens in a syllable at least, MNS0."""

APART = 0.15
"""How far apart the mouth's and the sound's event may be to belong together, s."""


def chains(studio: Studio) -> Iterator[Row]:
    """The median of every syllable in every manner."""
    lines = {name: [list(_chained(studio, name, manner)) for manner in MANNERS] for name in SYLLABLES}
    found = [float(np.median(leads)) for each in lines.values() for leads in each if leads]
    count = sum(len(leads) for each in lines.values() for leads in each)
    over = f"medians of {', '.join(SYLLABLES)} in chains, four manners, {count} syllables"
    yield row("L2", "chained CV", "mouth before sound, inside an utterance", found, over)


def _chained(studio: Studio, syllable: str, manner: str) -> Iterator[float]:
    """The leads of the syllables of a line, ms."""
    playing = studio.play(script("wait 1s", f'say "I say {" ".join([syllable] * 4)} again."{manner}', "wait 1s"))
    line = playing.score.lines[0]
    moves = np.array(_openings(playing.trace(line.start, line.end))) - line.start
    for consonant, vowel in pairwise(line.spoken.phones):
        if consonant.symbol != syllable[0] or vowel.symbol[:1] not in VOWELS:
            continue
        lead = _sounds(line, consonant, vowel) - moves
        nearest = float(lead[np.abs(lead).argmin()])
        if abs(nearest) <= APART:
            yield 1000.0 * nearest


def _sounds(line: TimedLine, consonant: PhoneTime, vowel: PhoneTime) -> float:
    """When a syllable is heard, s from the line's start."""
    rate = line.spoken.rate
    loud = loudness(samples(line.spoken), rate, 0.01)
    first, last = round((consonant.start - 0.04) * rate), round(vowel.end * rate)
    loudest = first + int(loud[first:last].argmax())
    if consonant.symbol == "m":
        closed = round((consonant.start + 0.01) * rate)
        murmur, share = float(np.median(loud[closed : closed + round(0.025 * rate)])), NASAL_HEARD
    else:
        closed = first + int(loud[first:loudest].argmin())
        murmur, share = float(loud[closed]), STOP_HEARD
    rises = loud[closed:] >= murmur + share * (loud[loudest] - murmur)
    return float((closed + np.flatnonzero(rises)[0]) / rate)


def _openings(trace: Trace) -> list[float]:
    """When each opening of the mouth begins, s."""
    opened = trace.channels["mouth.open"]
    speed = trace.speed(opened)
    return [
        float(trace.times[first + np.flatnonzero(speed[first:last] >= ONSET_SHARE * speed[first:last].max())[0]])
        for first, last in stretches(speed > 0.01)
        if opened[last - 1] - opened[first] >= OPENED
    ]


STARTS = {
    "rounded": (
        "Who are you?",
        "You may go.",
        "We are here.",
        "Two boats.",
        "Old men.",
        "One day.",
        "Woods are green.",
    ),
    "labial": (
        "Paul went home.",
        "Boats are slow.",
        "My house.",
        "Four men.",
        "Very good.",
        "Peter ran.",
        "Man alive.",
    ),
}
"""Lines that begin with a rounded or a labial sound."""


def starts(studio: Studio) -> Iterator[Row]:
    for kind, texts in STARTS.items():
        found = [_first_lead(studio.play(script("wait 1s", f'say "{text}"', "wait 1s"))) for text in texts]
        over = f"{len(found)} lines"
        yield row("L2", "utterance start, rounded or labial", f"mouth before sound, {kind} start", found, over)


def _first_lead(playing: Playing) -> float:
    """From the first movement of the mouth to the first sound, ms."""
    line = playing.score.lines[0]
    trace = playing.trace(line.start - 0.5, line.start + 0.4)
    mouth = np.stack([values for name, values in trace.channels.items() if name.startswith("mouth.")])
    speed = np.abs(np.gradient(mouth, trace.times, axis=1)).sum(axis=0)
    first = stretches(speed > 0.02)[0]
    peak = speed[slice(*first)].max()
    begun = trace.times[first[0] + np.flatnonzero(speed[slice(*first)] >= ONSET_SHARE * peak)[0]]
    return 1000.0 * (line.start + heard(line.spoken)[0] - float(begun))


RATES = (46, 60, 80, 100, 130, 160, 200, 257)
SHOWN = (
    "neutral",
    "smile",
    "happiness",
    "surprise",
    "excitement",
    "AU26",
    "AU27 70%",
    "fear",
    "disgust",
    "AU25 + AU12",
)
CLOSING = "Maybe Bob's puppy jumped upon a big empty pram, but mum and papa combed my pony."

BEFORE = 0.06
"""Seconds before its burst in which a p or b is shut."""


def closures(studio: Studio) -> Iterator[Row]:
    lines = [f'show {shown}\nwait 600ms\nsay "{CLOSING}", rate {rate}%' for shown in SHOWN for rate in RATES]
    playing = studio.play(script(*lines, "wait 1s"))
    gaps = [gap for line in playing.score.lines for gap in _gaps(playing, line)]
    over = f"{len(gaps)} closures, rates {RATES[0]} to {RATES[-1]} %, {len(SHOWN)} expressions"
    yield row("L3", "any", "least gap of the lips in p, b, m, of the line's widest", gaps, over)


def _gaps(playing: Playing, line: TimedLine) -> Iterator[float]:
    trace = playing.trace(line.start - 0.1, line.end)
    opened = trace.channels["mouth.open"]
    for phone in line.spoken.phones:
        if phone.symbol in ("p", "b", "m"):
            start, end = line.start + phone.start - BEFORE, line.start + max(phone.start + 0.015, phone.end)
            shut = (trace.times >= start) & (trace.times <= end)
            yield float(opened[shut].min() / opened.max())


def offsets(studio: Studio) -> Iterator[Row]:
    """A film of a speaking mouth, decoded again to pictures and sound."""
    found = [film.offset(studio, fps) for fps in (25, 30)]
    over = "films of 25 and 30 frames a second, decoded; frames count at their time stamps"
    yield row("L1", "audio early", "sound before the picture's mouth", [max(0.0, -late) for late in found], over)
    yield row("L1", "audio late", "sound after the picture's mouth", [max(0.0, late) for late in found], over)


def leads(studio: Studio) -> Iterator[Row]:
    yield from chains(studio)
    yield from starts(studio)


MEASURES: Measures = {"L1": offsets, "L2": leads, "L3": closures}
