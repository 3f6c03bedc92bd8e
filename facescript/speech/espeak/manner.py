"""Voice names as an author writes them to the voice that espeak-ng speaks with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from itertools import pairwise
from typing import Any

from facescript.ir.acts import Voice
from facescript.speech.model import VoiceFailure

MANDARIN = ("cmn", "zh", "zh-cn", "zh-tw", "cmn-latn-pinyin")
"""Languages whose characters are spoken syllable by syllable."""

VARIANTS = {"female": "f3", "male": "m3"}
"""The variants that `female` and `male` stand for."""

WORDS_A_MINUTE = 175
SLOWEST, FASTEST = 80, 450
"""What espeak-ng speaks at 100 %, and its limits, in words a minute."""

PITCHES = ((0, 0.67), (10, 0.72), (25, 0.8), (40, 0.905), (50, 1.0), (60, 1.095), (75, 1.265), (90, 1.49), (100, 1.64))
"""espeak-ng's pitch and how many times the usual the voice's fundamental is then: medians of four voices, measured."""


WIDEST = 2.0
"""How many times the usual the voice's melody swings at espeak-ng's range of 100; at 0 it is one tone."""


@dataclass(frozen=True, slots=True)
class Manner:
    """How the synthesiser is to speak: its voice's identifier (with `+variant`), words a minute, pitch and range
    0..100."""

    voice: str
    rate: int
    pitch: int
    range: int


@dataclass(frozen=True, slots=True)
class Voices:
    """The voices of the synthesiser. `languages` maps a code in lower case to a voice's identifier, `titles` a code
    to its full name, `variants` a variant's name in lower case to the synthesiser's."""

    languages: Mapping[str, str]
    titles: Mapping[str, str]
    variants: Mapping[str, str]

    def manner(self, voice: Voice) -> Manner:
        """How to speak as `voice` says. Raises `VoiceFailure` where there is no such voice, rate or pitch."""
        code = "cmn-latn-pinyin" if voice.language.lower() in MANDARIN else voice.language
        identifier = _found(code, self.languages, "language")
        if voice.variant:
            name = VARIANTS.get(voice.variant.lower(), voice.variant)
            identifier += "+" + _found(name, self.variants, "variant")
        return Manner(identifier, rate(voice.rate), pitch(voice.pitch), swing(voice.range))


def check_manner(voice: Voice) -> None:
    """Raises `VoiceFailure` where the synthesiser does not speak at the voice's rate, pitch or range."""
    rate(voice.rate)
    pitch(voice.pitch)
    swing(voice.range)


def rate(factor: float) -> int:
    """Words a minute at `factor` times the usual speed."""
    words = round(WORDS_A_MINUTE * factor)
    if not SLOWEST <= words <= FASTEST:
        low, high = (f"{100 * limit / WORDS_A_MINUTE:.0f}%" for limit in (SLOWEST, FASTEST))
        raise VoiceFailure(f"a rate of {factor:.0%} lies outside what it speaks, {low} to {high}")
    return words


def pitch(factor: float) -> int:
    """espeak-ng's pitch, 0..100, for `factor` times the usual."""
    low, high = PITCHES[0][1], PITCHES[-1][1]
    if not low <= factor <= high:
        raise VoiceFailure(f"a pitch of {factor:.0%} lies outside what it speaks, {low:.0%} to {high:.0%}")
    for (below, least), (above, most) in pairwise(PITCHES):
        if factor <= most:
            return round(below + (above - below) * (factor - least) / (most - least))
    return PITCHES[-1][0]


def swing(factor: float) -> int:
    """espeak-ng's range, 0..100, for `factor` times the usual rise and fall of the voice."""
    if not 0 <= factor <= WIDEST:
        raise VoiceFailure(f"a range of {factor:.0%} lies outside what it speaks, 0% to {WIDEST:.0%}")
    return round(100 * factor / WIDEST)


def voices(listing: Mapping[str, Any]) -> Voices:
    """The voices of a worker's answer; a code that several voices bear goes to the one that gives it first place."""
    ranked: dict[str, tuple[int, str]] = {}
    titles: dict[str, str] = {}
    for title, identifier, languages in listing["voices"]:
        if languages:
            titles[languages[0][1]] = title.strip()
        for priority, code in languages:
            first = priority if code != languages[0][1] else 0
            ranked[code.lower()] = min(ranked.get(code.lower(), (256, "")), (first, identifier))
    variants: dict[str, str] = {}
    for name, identifier, _ in listing["variants"]:
        file = identifier.rpartition("/")[2]
        variants |= {name.lower(): file, file.lower(): file}
    return Voices({code: identifier for code, (_, identifier) in ranked.items()}, titles, variants)


def _found(name: str, known: Mapping[str, str], kind: str) -> str:
    """The synthesiser's name for a language or a variant."""
    if name.lower() in known:
        return known[name.lower()]
    near = get_close_matches(name.lower(), known, 3, 0.5)
    near += [code for code in known if code.split("-")[0] == name.lower().split("-")[0] and code not in near]
    hint = f"; near it are {', '.join(f'`{code}`' for code in near[:4])}" if near else ""
    raise VoiceFailure(f"it has no {kind} `{name}`{hint}")
