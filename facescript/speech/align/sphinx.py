"""English words and phones in stretches of a recording to when each begins, by PocketSphinx where it is installed."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from facescript.speech.model import PhoneTime, WordTime
from facescript.speech.sound.recording import Samples
from facescript.speech.sound.resample import resampled

PROGRAM = Path(__file__).with_name("sphinx_program.py")

RATE, FRAME = 16_000, 0.01
"""Samples and seconds as its model has them."""

LATE = 0.5
"""Frames by which a phone begins after the middle of its first frame, as its number counts."""

PATIENCE = 60.0
"""Seconds that it may take, and as long as the recording."""

DOUBLE = {"eɪ": "EY", "aɪ": "AY", "ɔɪ": "OY", "aʊ": "AW", "oʊ": "OW", "əʊ": "OW", "tʃ": "CH", "dʒ": "JH"}

NAMES = """
i IY  ɪ IH  ᵻ IH  ɨ IH  e EH  ɛ EH  æ AE  a AA  ɑ AA  ɒ AA  ɔ AO  o AO  ʊ UH  u UW  ʌ AH  ə AH  ɐ AH  ɜ ER  ɚ ER  ɝ ER
p P  b B  t T  d D  ɾ D  ʔ T  k K  ɡ G  g G  f F  v V  θ TH  ð DH  s S  z Z  ʃ SH  ʒ ZH  h HH  x HH  m M  n N  ŋ NG
l L  ɫ L  ɹ R  r R  w W  ʍ W  j Y
"""
SINGLE = dict(zip(NAMES.split()[::2], NAMES.split()[1::2], strict=True))

Starts = list[float | None]


@dataclass(frozen=True, slots=True)
class Utterance:
    """A stretch of a recording that begins at second `start`, and the words and phones in it, at about their time."""

    samples: Samples
    rate: int
    start: float
    words: Sequence[WordTime]
    phones: Sequence[PhoneTime]


def starts(utterances: Sequence[Utterance]) -> list[Starts | None]:
    """When each phone of each utterance begins, in seconds of the recording; None for a phone that it does not know,
    and for an utterance in which it finds no way, as in one of twenty."""
    groups = [_groups(each) for each in utterances]
    spelt = [[names(phone.symbol) for phone in each.phones] for each in utterances]
    asked = [
        [[name for number in group for name in spelling[number]] for group in found]
        for found, spelling in zip(groups, spelt, strict=True)
    ]
    answers = _asked([_sound(each) for each in utterances], asked)
    return [
        None if answer is None else _spread(each, group, spelling, answer)
        for each, group, spelling, answer in zip(utterances, groups, spelt, answers, strict=True)
    ]


def names(symbol: str) -> list[str]:
    """A sound's names in ARPAbet: `ɑːɹ` is AA R."""
    found: list[str] = []
    at = 0
    while at < len(symbol):
        if symbol[at : at + 2] in DOUBLE:
            found.append(DOUBLE[symbol[at : at + 2]])
            at += 1
        elif symbol[at] in SINGLE:
            found.append(SINGLE[symbol[at]])
        at += 1
    return found


def _groups(each: Utterance) -> list[list[int]]:
    """The numbers of the phones of each word that has one it knows."""
    return [group for group in _by_word(each) if any(names(each.phones[number].symbol) for number in group)]


def _by_word(each: Utterance) -> Iterator[list[int]]:
    moments = sorted({word.start for word in each.words})
    for start, end in pairwise([-np.inf, *moments[1:], np.inf]):
        yield [number for number, phone in enumerate(each.phones) if start <= phone.start < end and phone.symbol]


def _sound(each: Utterance) -> bytes:
    made = resampled(each.samples, each.rate, RATE, 0, round(len(each.samples) * RATE / each.rate))
    return np.clip(np.round(made), -32_768, 32_767).astype("<i2").tobytes()


def _asked(sounds: Sequence[bytes], words: Sequence[list[list[str]]]) -> list[list[list[int]] | None]:
    """The program's answers; None for what it did not come to."""
    head = json.dumps(
        [{"bytes": len(sound), "words": each} for sound, each in zip(sounds, words, strict=True)]
    ).encode()
    patience = PATIENCE + sum(map(len, sounds)) / 2 / RATE
    data = len(head).to_bytes(4, "big") + head + b"".join(sounds)
    try:
        done = subprocess.run([sys.executable, "-P", str(PROGRAM)], input=data, capture_output=True, timeout=patience)
        lines = done.stdout.splitlines()
    except (OSError, subprocess.TimeoutExpired):
        lines = []
    answers = [json.loads(line) for line in lines[: len(sounds)]]
    return answers + [None] * (len(sounds) - len(answers))


def _spread(each: Utterance, groups: list[list[int]], spelt: list[list[str]], answer: list[list[int]]) -> Starts:
    """The first frame of each phone as seconds."""
    begun: Starts = [None] * len(each.phones)
    for group, frames in zip(groups, answer, strict=True):
        heard = iter(frames)
        for number in group:
            own = [each.start + (next(heard) + LATE) * FRAME for _ in spelt[number]]
            begun[number] = own[0] if own else None
    return begun
