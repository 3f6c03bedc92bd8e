"""IPA to its base letters, and to the phoneme names that espeak-ng takes in `[[...]]`."""

from __future__ import annotations

import unicodedata

from facescript.speech.model import VoiceFailure

STRESS = "ˈˌ"
LENGTH = "ːˑ"
TIES = "͜͡"

NAMES = {
    "ˈ": "'",
    "ˌ": ",",
    "ː": ":",
    "ə": "@",
    "ɚ": "3",
    "ɝ": "3:",
    "ɜ": "3",
    "ɐ": "a#",
    "æ": "a",
    "ɑ": "A",
    "ɒ": "0",
    "ɔ": "O",
    "ʌ": "V",
    "ɛ": "E",
    "ɪ": "I",
    "ʊ": "U",
    "ø": "Y",
    "œ": "W",
    "ʏ": "y",
    "ɨ": 'i"',
    "ʉ": 'u"',
    "ɯ": "u-",
    "ɤ": "o-",
    "β": "B",
    "θ": "T",
    "ð": "D",
    "ʃ": "S",
    "ʒ": "Z",
    "ŋ": "N",
    "ɲ": "n^",
    "ʎ": "l^",
    "ɹ": "r",
    "ɾ": "*",
    "ʁ": "r",
    "ɡ": "g",
    "ç": "C",
    "ɣ": "Q",
    "χ": "X",
    "ʔ": "?",
    "ɬ": "l#",
    "ɫ": "l",
    "ɕ": "S;",
    "ʑ": "Z;",
    "̃": "~",
}
"""espeak-ng's names of the IPA letters that it does not call by themselves (its documentation, "phonemes")."""

PLAIN = frozenset("abdefhijklmnopqrstuvwxyz")


def letters(symbol: str) -> tuple[str, ...]:
    """The base letters of an IPA symbol without stress, length, ties and marks: `ˈoʊ` is o and ʊ."""
    return tuple(sign for sign in unicodedata.normalize("NFD", symbol) if _is_base(sign))


def _is_base(sign: str) -> bool:
    return sign not in STRESS + LENGTH and unicodedata.category(sign) in ("Ll", "Lo", "Lu")


def _signs(ipa: str) -> list[str]:
    """The letters and marks of IPA apart from each other; ç is a letter of its own, əʊ one sound of English."""
    apart = unicodedata.normalize("NFD", ipa).replace("c\u0327", "ç")
    signs = list(apart)
    for at in range(len(signs) - 1):
        if signs[at] + signs[at + 1] == "əʊ":
            signs[at : at + 2] = ["o", "ʊ"]
    return signs


def mnemonics(ipa: str) -> str:
    """espeak-ng's names for IPA written between slashes. Raises `VoiceFailure` (FS502) at a sign that has none."""
    names = []
    for sign in _signs(ipa):
        if sign in TIES or sign == "." or sign.isspace():
            continue
        if sign not in NAMES and sign not in PLAIN:
            raise VoiceFailure(f"`{sign}` in `/{ipa}/` is no IPA sign that a voice knows", "FS502")
        names.append(NAMES.get(sign, sign))
    if not letters(ipa):
        raise VoiceFailure(f"`/{ipa}/` has no sound in it", "FS502")
    return "".join(names)
