"""Sounds of any language to the mouth's basic shapes, with their values for the channels that speech drives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.mouth.ipa import LENGTH, letters

PARTS = ("open", "wide", "round", "upper", "lower", "jaw", "teeth", "tongue")
"""The mouth's channels, in their order and units."""

Values = tuple[float, float, float, float, float, float, float, float]
"""One shape's value of each of `PARTS`."""

LOWER_LIP = 0.4
"""Height of the lower lip in MNS0 (mouth to nose): the thesis measures shape f in lip heights."""

JAW_DOWN = 1.2
"""MNS0 by which the lower lip sinks with a jaw that is down: the jaw moves with the lower lip (section 5.2.2). Shape a,
the widest, takes 0.8 of it, and a loud one half as much again."""


def _shape(up: float, dn: float, wide: float, rounded: float, teeth: float, tongue: float) -> Values:
    return (max(up + dn, 0.0), wide, rounded, up, dn, max(dn, 0.0) / JAW_DOWN, teeth, tongue)


SHAPES: MappingProxyType[str, Values] = MappingProxyType(
    {
        "m": _shape(0, 0, 0, 0, 0, 0),
        "f": _shape(0, -0.5 * LOWER_LIP, 0, 0, 0.6, 0),
        "h'": _shape(0.25, 0.3, 0, 0, 0.5, 0.8),
        "h": _shape(0.25, 0.5, -1 / 12, 0, 0.2, 0.1),
        "r": _shape(0.25, 0.25, -0.15, 0.6, 0.6, 0.5),
        "z": _shape(0.15, 0.15, 0, 0, 1, 0.6),
        "a": _shape(0.3, 0.8, -1 / 8, 0, 0.3, 0),
        "e": _shape(0, 0.5, 1 / 12, 0, 0.6, 0.2),
        "i": _shape(0, 1 / 6, 1 / 12, 0, 0.7, 0.4),
        "o": _shape(0.25, 0.65, -0.2, 0.8, 0.1, 0),
        "u": _shape(0.3, 0.3, -0.2, 1, 0, 0),
        "n": _shape(0.3, 0.4, 0, 0, 0.5, 0.8),
        "th": _shape(0.15, 0.25, 0, 0, 0.4, 1),
        "rest": _shape(0, 0, 0, 0, 0, 0),
    }
)
"""The twelve shapes of section 5.2.2 (a with its corners in by MW0/8, section 5.2.1): up and dn in MNS0, the corners
in MW0. What it does not give is ours: rounding, teeth, tongue, and `th`, the tongue between the teeth."""


@dataclass(frozen=True, slots=True)
class Viseme:
    """A sound as a shape of the mouth at a degree: `kind` is "stop", "sound" (a consonant that lasts) or "vowel"; the
    shape has `values` of its own where it is an author's."""

    shape: str
    kind: str
    degree: float = 1.0
    values: Values | None = None


def _class(signs: str, shape: str, kind: str, degree: float = 1.0) -> dict[str, Viseme]:
    return dict.fromkeys(signs.split(), Viseme(shape, kind, degree))


VISEMES: MappingProxyType[str, Viseme] = MappingProxyType(
    _class("p b ɓ ʘ", "m", "stop")
    | _class("m", "m", "sound")
    | _class("f v ɱ ʋ ⱱ", "f", "sound")
    | _class("ɸ β ʙ", "u", "sound", 0.4)
    | _class("t d ɗ ʈ ɖ ǀ ǃ ǁ ǂ ɾ ɽ", "h'", "stop", 0.7)
    | _class("n l ɳ ɭ ɫ ɬ ɮ ɲ ʎ ɺ", "h'", "sound", 0.85)
    | _class("r ɕ ʑ ç ʝ ʨ ʥ", "h'", "sound", 0.7)
    | _class("c ɟ ʄ", "h'", "stop", 0.7)
    | _class("k g ɡ ɠ q ɢ ʛ ʔ ʡ", "h", "stop", 0.6)
    | _class("x X ɣ ŋ h ɦ χ ʁ ʀ ħ ʕ ʜ ʢ ɴ ɰ ʟ", "h", "sound", 0.6)
    | _class("ʃ ʒ S Z ʧ ʤ ɹ ɻ ʂ ʐ ɧ", "r", "sound")
    | _class("s z ʦ ʣ", "z", "sound")
    | _class("θ ð", "th", "sound")
    | _class("w ʍ ɥ", "u", "sound")
    | _class("j", "i", "sound")
    | _class("a ɑ A ɶ", "a", "vowel")
    | _class("æ ɐ ʌ", "a", "vowel", 0.75)
    | _class("e ɛ", "e", "vowel")
    | _class("i ɪ ɨ ᵻ", "i", "vowel")
    | _class("ɯ", "i", "vowel", 0.7)
    | _class("o ɔ ɒ", "o", "vowel")
    | _class("ø œ ɵ ɞ", "o", "vowel", 0.85)
    | _class("u ʊ y ʏ ʉ ᵿ", "u", "vowel")
    | _class("ɤ ɜ ɝ ɚ", "h", "vowel", 0.9)
    | _class("ə ɘ", "h", "vowel", 0.6)
)

UNKNOWN_VOWEL, UNKNOWN_CONSONANT = Viseme("h", "vowel", 0.8), Viseme("h'", "sound", 0.6)
"""What an unknown sign becomes: a long or stressed one is a vowel."""


@dataclass(frozen=True, slots=True)
class Table:
    """The table, with what an author says of single sounds before it: `own` by symbols as a voice gives them."""

    own: Mapping[str, tuple[Viseme, ...]] = field(default_factory=dict)

    def visemes(self, symbol: str, stressed: bool = False) -> tuple[Viseme, ...]:
        """The shapes of one phone in order; a diphthong has two, an affricate that of its end. Never fails: an unknown
        sign has the middle shape of its class."""
        if symbol.startswith(PREFIX):
            name = symbol.removeprefix(PREFIX)
            return (Viseme(name if name in SHAPES else "h", "vowel"),)
        if symbol in self.own:
            return self.own[symbol]
        unknown = UNKNOWN_VOWEL if stressed or any(sign in symbol for sign in LENGTH) else UNKNOWN_CONSONANT
        found = [each for letter in letters(symbol) for each in self._of(letter, unknown)]
        return tuple(viseme for at, viseme in enumerate(found) if not _covered(viseme, found[at + 1 :]))

    def unknown(self, symbol: str) -> str:
        """The letters of a symbol that neither the table nor the author knows."""
        if symbol.startswith(PREFIX) or symbol in self.own:
            return ""
        return "".join(letter for letter in letters(symbol) if letter not in self.own and letter not in VISEMES)

    def _of(self, letter: str, unknown: Viseme) -> tuple[Viseme, ...]:
        return self.own.get(letter) or (VISEMES.get(letter, unknown),)


PLAIN = Table()
"""The table as it is, without anything of an author."""


def visemes(symbol: str, stressed: bool = False) -> tuple[Viseme, ...]:
    """The shapes of one phone by the table as it is."""
    return PLAIN.visemes(symbol, stressed)


def _covered(viseme: Viseme, after: list[Viseme]) -> bool:
    """Whether a consonant leaves no shape of its own: one with open lips at the head of an affricate."""
    return viseme.shape in ("h'", "h") and viseme.kind == "stop" and any(next_.kind == "sound" for next_ in after[:1])
