"""Sessions of several voices, each with phrases of a script and with what is none, to how reliably they are heard.

A session is what a microphone takes up: a voice at a rate, in pink noise, says every phrase and every foil once, with a
second between them. What the ear tells is counted as it is told live, by the clock of the sound and the time that the
recogniser takes.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from row import Row

from facescript.ir.acts import Say, Voice
from facescript.live.hearing.activity import RATE
from facescript.live.hearing.ear import Ear
from facescript.live.hearing.listening import LEAST
from facescript.live.hearing.phrases import phrases, sounds_of
from facescript.live.hearing.sphinx import Sphinx
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.sound.resample import resampled

PHRASES = ("no", "thank you", "start", "goodbye", "play the film", "where is the lift")

FOILS = (
    """
yes|hello|what time is it|I know that|now|not today|go on|show me|nobody is here|the bus is late|stop it|dark|star
good morning|play the game|where is the gift|lift it up|I like this picture|can you see me|it is raining again|note
we were here last year|I would like a coffee please|how much does it cost|wait for me|open the door
""".strip()
    .replace("\n", "|")
    .split("|")
)
"""What else is said; some of it sounds nearly like a phrase."""

VOICES = (
    ("en-us", "", 1.0),
    ("en-us", "f2", 1.0),
    ("en-us", "m3", 0.85),
    ("en-us", "female", 1.2),
    ("en-gb", "", 0.9),
    ("en-gb", "f4", 1.1),
    ("en-gb-scotland", "m7", 1.0),
    ("en-gb-x-rp", "m1", 1.15),
)

NOISES = (None, 20, 10, 5)
"""Decibels of speech over noise; None is a quiet room, 45."""

BLOCK = 512

SETTLES = RATE
"""Samples of noise before the first word, and between two."""

Samples = NDArray[np.int16]


@dataclass
class Score:
    """What was heard of a session: of how many phrases how many, which as another; of foils and noise; delays, s."""

    said: int = 0
    heard: int = 0
    wrong: int = 0
    false: int = 0
    foils: int = 0
    seconds: float = 0.0
    delays: list[float] = field(default_factory=list)
    worked: float = 0.0

    def add(self, other: Score) -> None:
        for name in ("said", "heard", "wrong", "false", "foils", "seconds", "delays", "worked"):
            setattr(self, name, getattr(self, name) + getattr(other, name))


def rows() -> Iterator[Row]:
    known = phrases(PHRASES)
    sphinx = Sphinx(known, lambda word: sounds_of(word, process_voice()))
    for noise in NOISES:
        whole = Score()
        for number, voice in enumerate(VOICES):
            whole.add(session(sphinx, voice, noise, number))
        where = "quiet" if noise is None else f"noise at {noise} dB"
        yield Row(f"phrases heard, {where}", "", _heard(whole), None)
        yield Row(f"false alarms, {where}", "", _false(whole), None)
        delays = np.percentile(whole.delays or [0.0], (50, 95)) * 1000
        took = f"median {delays[0]:.0f} ms, p95 {delays[1]:.0f} ms"
        yield Row(f"end of the word to the event, {where}", "", took, None)
        yield Row(f"processor time, {where}", "", f"{whole.worked / whole.seconds:.0%} of a core", None)


def _heard(score: Score) -> str:
    return f"{score.heard} of {score.said} ({score.heard / score.said:.0%}), {score.wrong} as another phrase"


def _false(score: Score) -> str:
    rate = score.false / score.seconds * 3600
    return f"{score.false} of {score.foils} other utterances, {rate:.0f} an hour of constant talk"


def session(sphinx: Sphinx, voice: tuple[str, str, float], noise: int | None, seed: int) -> Score:
    """One voice, all phrases and foils, in an order of its own."""
    dice = np.random.default_rng(seed)
    texts = [*PHRASES, *FOILS]
    dice.shuffle(texts)
    sound, ends = _sound(texts, voice, noise, dice)
    score = Score(len(PHRASES), foils=len(FOILS), seconds=len(sound) / RATE)
    ear = Ear(sphinx, LEAST)
    told: list[tuple[float, str]] = []
    began = time.process_time()
    for first in range(0, len(sound), BLOCK):
        before = time.process_time()
        found = list(ear.listen(sound[first : first + BLOCK]))
        now = (first + BLOCK) / RATE + time.process_time() - before
        told += [(now, one.text) for one in found]
    score.worked = time.process_time() - began
    for (at, text), (end, said) in _paired(told, ends):
        if said not in PHRASES:
            score.false += 1
        elif text != said:
            score.wrong += 1
        else:
            score.heard += 1
            score.delays.append(at - end)
    return score


def _paired(
    told: list[tuple[float, str]], ends: list[tuple[float, str]]
) -> Iterator[tuple[tuple[float, str], tuple[float, str]]]:
    """Each event with what was said last before it."""
    for one in told:
        yield one, [end for end in ends if end[0] <= one[0] + 0.2][-1]


def _sound(
    texts: list[str], voice: tuple[str, str, float], noise: int | None, dice: np.random.Generator
) -> tuple[Samples, list[tuple[float, str]]]:
    """The session's sound, and when each text in it ends, s."""
    pieces, ends, at = [np.zeros(SETTLES)], [], SETTLES
    for text in texts:
        said = _said(text, voice)
        pieces += [said, np.zeros(SETTLES)]
        ends.append(((at + len(said)) / RATE, text))
        at += len(said) + SETTLES
    whole = np.concatenate(pieces)
    loud = np.sqrt(np.mean(np.square(whole[whole != 0.0])))
    level = loud * 10.0 ** (-(45 if noise is None else noise) / 20.0)
    return np.clip(np.round(whole + level * _pink(len(whole), dice)), -32768, 32767).astype(np.int16), ends


def _said(text: str, voice: tuple[str, str, float]) -> NDArray[np.float64]:
    """A text from its first to its last sound, without the silence behind it."""
    spoken = process_voice().speak(Say(text, Voice(voice[0], voice[1], voice[2])))
    samples = np.frombuffer(spoken.pcm, "<i2")
    loud = np.flatnonzero(np.abs(samples.astype(np.int32)) > 100)
    samples = samples[loud[0] : loud[-1] + 1]
    made = resampled(samples, spoken.rate, RATE, 0, round(len(samples) * RATE / spoken.rate))
    return made.astype(np.float64)


def _pink(count: int, dice: np.random.Generator) -> NDArray[np.float64]:
    """Noise of equal power in each octave, of power 1."""
    spectrum = np.fft.rfft(dice.standard_normal(count))
    hertz = np.arange(len(spectrum)) * RATE / count
    made = np.fft.irfft(spectrum / np.sqrt(hertz + 20.0), count)
    pink: NDArray[np.float64] = made / made.std()
    return pink
