"""Mandarin written by its sound, in pinyin or zhuyin, to syllables such as `zhang3`."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from itertools import accumulate

from facescript.speech.mandarin.syllables import TONES, WITHOUT_INITIAL, numbered
from facescript.speech.model import VoiceFailure

BY_INITIAL = """
b: a o ai ei ao an en ang eng i ie iao ian in ing u
p: a o ai ei ao ou an en ang eng i ie iao ian in ing u
m: a o e ai ei ao ou an en ang eng i ie iao iu ian in ing u
f: a o ei ou an en ang eng u
d: a e ai ei ao ou an en ang eng ong i ia ie iao iu ian ing u uo ui uan un
t: a e ai ei ao ou an ang eng ong i ie iao ian ing u uo ui uan un
n: a e ai ei ao ou an en ang eng ong i ie iao iu ian in iang ing u uo uan v ve ue
l: a o e ai ei ao ou an ang eng ong i ia ie iao iu ian in iang ing u uo uan un v ve ue
g: a e ai ei ao ou an en ang eng ong u ua uo uai ui uan un uang
k: a e ai ei ao ou an en ang eng ong u ua uo uai ui uan un uang
h: a e ai ei ao ou an en ang eng ong u ua uo uai ui uan un uang
j: i ia ie iao iu ian in iang ing iong u ue uan un
q: i ia ie iao iu ian in iang ing iong u ue uan un
x: i ia ie iao iu ian in iang ing iong u ue uan un
zh: i a e ai ei ao ou an en ang eng ong u ua uo uai ui uan un uang
ch: i a e ai ao ou an en ang eng ong u ua uo uai ui uan un uang
sh: i a e ai ei ao ou an en ang eng u ua uo uai ui uan un uang
r: i e ao ou an en ang eng ong u ua uo ui uan un
z: i a e ai ei ao ou an en ang eng ong u uo ui uan un
c: i a e ai ao ou an en ang eng ong u uo ui uan un
s: i a e ai ao ou an en ang eng ong u uo ui uan un
"""
"""The finals that each initial goes with: what is not here is no word of Mandarin."""

BARE = {"a", "o", "e", "ai", "ei", "ao", "ou", "an", "en", "ang", "eng", *WITHOUT_INITIAL} - {"hm", "ng", "hng"}
"""Syllables without an initial."""

KNOWN = BARE | {
    initial + final
    for initial, finals in (row.split(": ") for row in BY_INITIAL.strip().splitlines())
    for final in finals.split()
}

PARTICLES = frozenset("a ba de ge la le li ma me men ne shang tou ya zhe zi".split())
"""Words that have no tone, beside others that have."""

CLUSTER = re.compile(".[\u0300-\u036f]*")
NUMBERED = re.compile("([a-z]+)([0-5])")
VOWELS = "aeiouv"
LONGEST = 6
"""Letters of the longest syllable."""

Cuts = tuple[tuple[int, int, str], ...]
"""First and last character of each syllable, and the syllable."""

ZHUYIN = re.compile("(˙?)([ㄅ-ㄙ]?)([ㄧㄨㄩ]?)([ㄚ-ㄦ]?)([ˉˊˇˋ˙]?)")
MARKS = {"ˉ": "1", "ˊ": "2", "ˇ": "3", "ˋ": "4", "˙": "5", "": "1"}
SOUNDS = dict(
    zip(
        "ㄅㄆㄇㄈㄉㄊㄋㄌㄍㄎㄏㄐㄑㄒㄓㄔㄕㄖㄗㄘㄙ",
        "b p m f d t n l g k h j q x zh ch sh r z c s".split(),
        strict=True,
    )
)
ENDS = dict(zip("ㄚㄛㄜㄝㄞㄟㄠㄡㄢㄣㄤㄥㄦ", "a o e ê ai ei ao ou an en ang eng er".split(), strict=True))
MIDDLES = {
    "ㄧ": {"": "i", "ê": "ie", "ou": "iu", "en": "in", "eng": "ing"},
    "ㄨ": {"": "u", "ei": "ui", "en": "un", "eng": "ong"},
    "ㄩ": {"": "v", "ê": "ve", "en": "vn", "eng": "iong", "an": "van"},
}
SIBILANTS = ("zh", "ch", "sh", "r", "z", "c", "s")
"""Initials that need no final: ㄕ is shi."""

ALONE = {"i": "yi", "in": "yin", "ing": "ying", "iu": "you", "u": "wu", "ui": "wei", "un": "wen", "ong": "weng"}
ALONE |= {"v": "yu", "ve": "yue", "vn": "yun", "van": "yuan", "iong": "yong"}
"""How a final is written that has no initial before it, where it is not y or w for its i or u."""


def syllables_of(written: str) -> tuple[str, ...]:
    """The syllables of a reading that an author wrote, in pinyin or zhuyin. Raises `VoiceFailure` (FS502)."""
    return tuple(syllable for word in written.split() for syllable in _of_word(word))


def _of_word(word: str) -> tuple[str, ...]:
    if is_zhuyin(word[0]):
        return tuple(syllable for _, _, syllable in zhuyin(word))
    found = pinyin(word) or ()
    return tuple(syllable for _, _, syllable in found) if len(found) > 1 else (numbered(word),)


def is_zhuyin(sign: str) -> bool:
    """Whether a character is of zhuyin: a sound, or the dot of no tone, which may stand first."""
    return "ㄅ" <= sign <= "ㄩ" or sign == "˙"


def zhuyin(text: str) -> Iterator[tuple[int, int, str]]:
    """The syllables of a text in zhuyin: first character, last, syllable. Raises `VoiceFailure` (FS502)."""
    at = 0
    while at < len(text):
        match = ZHUYIN.match(text, at)
        base = _latin(match) if match else ""
        if match is None or base not in KNOWN:
            raise VoiceFailure(f"`{text[at:]}` is no syllable of zhuyin", "FS502")
        yield at, match.end(), base + (MARKS["˙"] if match[1] else MARKS[match[5]])
        at = match.end()


def _latin(match: re.Match[str]) -> str:
    """The letters of a syllable in zhuyin, ü written v."""
    initial, middle, end = SOUNDS.get(match[2], ""), match[3], ENDS.get(match[4], "")
    final = MIDDLES[middle].get(end, {"ㄧ": "i", "ㄨ": "u", "ㄩ": "v"}[middle] + end) if middle else end
    if not initial:
        return ALONE.get(final) or ({"ㄧ": "y", "ㄨ": "w"}[middle] + final[1:] if middle else final)
    if initial in ("j", "q", "x") and final.startswith("v"):
        final = "u" + final[1:]
    return initial + (final or ("i" if initial in SIBILANTS else ""))


def pinyin(word: str) -> Cuts | None:
    """The syllables of a Latin word that is pinyin with its tones: first character, last, syllable; None for any other.

    With marks (`péngyou`) what bears none has no tone; with numbers (`peng2you5`) each syllable bears one. A word in
    capitals is none, so that A4 stays paper.
    """
    signs = CLUSTER.findall(word.lower())
    letters, tones = _bare(signs)
    if any(map(str.isdigit, letters)):
        found = None if tones or word.upper() == word else _by_numbers(letters)
    else:
        found = _by_marks(letters, tones, 0) if tones else None
    if found is None:
        return None
    places = list(accumulate(map(len, signs), initial=0))
    return tuple((places[first], places[last], numbered(syllable)) for first, last, syllable in found)


def _bare(signs: Sequence[str]) -> tuple[str, dict[int, str]]:
    """A letter a sign without its marks, ü written v, and the tone of each sign that bears one."""
    letters = ""
    tones: dict[int, str] = {}
    for place, sign in enumerate(signs):
        apart = unicodedata.normalize("NFD", sign)
        tones.update((place, tone) for mark, tone in TONES.items() if mark in apart)
        base = "".join(mark for mark in apart if mark not in TONES)
        letters += {"u\u0308": "v", "’": "'"}.get(base, base if len(base) == 1 else "?")
    return letters, tones


def _by_numbers(letters: str) -> Cuts | None:
    found: list[tuple[int, int, str]] = []
    for match in NUMBERED.finditer(letters):
        if match.start() != (found[-1][1] if found else 0) or match[1] not in KNOWN:
            return None
        found.append((match.start(), match.end(), match[1] + match[2].replace("0", "5")))
    return tuple(found) if found and found[-1][1] == len(letters) else None


def _by_marks(letters: str, tones: Mapping[int, str], at: int) -> Cuts | None:
    """The longest syllables first; one that begins with a vowel inside a word has an apostrophe before it."""
    if at == len(letters):
        return ()
    if at and letters[at] == "'":
        at += 1
    elif at and letters[at] in VOWELS:
        return None
    for end in range(min(at + LONGEST, len(letters)), at, -1):
        borne = [tones[place] for place in range(at, end) if place in tones]
        if letters[at:end] in KNOWN and len(borne) < 2:
            rest = _by_marks(letters, tones, end)
            if rest is not None:
                return ((at, end, letters[at:end] + (borne[0] if borne else "5")), *rest)
    return None
