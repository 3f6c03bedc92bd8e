"""A Mandarin piece to syllables, sound, and the time of every character."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from functools import lru_cache

from facescript.ir.acts import Stretch, Voice
from facescript.speech.espeak import alphabetic
from facescript.speech.espeak.client import Espeak, Sound, Utterance
from facescript.speech.espeak.manner import Manner, Voices
from facescript.speech.espeak.parts import RATE, Part, Take, Trim, joined, phones, trimmed, unheard
from facescript.speech.lines import Piece, is_han, is_letter
from facescript.speech.mandarin.numerals import chinese
from facescript.speech.mandarin.syllables import numbered, timed
from facescript.speech.model import PhoneTime, VoiceFailure, WordTime

FOREIGN = "en-us"
"""The language of Latin letters inside Mandarin."""

RESPELT = {"jiong": "jong", "qiong": "qong", "xiong": "xong", "wong": "weng", "ê": "ei", "hm": "heng", "hng": "heng"}
RESPELT |= {"n": "en", "m": "mu", "ng": "eng", "r": "er"}
"""Syllables that the voice `cmn-latn-pinyin` would spell out in English, as its nearest."""

MARKS = {
    **dict.fromkeys("，、,—–", ", "),
    **dict.fromkeys("。.．", ". "),
    **dict.fromkeys("？?", "? "),
    **dict.fromkeys("！!", "! "),
    **dict.fromkeys("；;", "; "),
    **dict.fromkeys("：:", ": "),
    **dict.fromkeys("…", ", "),
}
"""What punctuation becomes in the text that is sent."""

SILENCE = 0.1
"""A longer gap between syllables is a silence of its own, in seconds."""

NUMBER = re.compile(r"(\d[\d,]*(?:\.\d+)?)([%％]?)")


@dataclass(frozen=True, slots=True)
class Unit:
    """Characters `first` to `last` of the piece: their syllables, or "" and a mark of punctuation, or foreign words."""

    first: int
    last: int
    syllables: tuple[str, ...] = ()
    mark: str = ""
    foreign: str = ""
    stressed: bool = False


def speak(espeak: Espeak, piece: Piece, line: str, voices: Voices, voice: Voice, take: Take = unheard) -> Part:
    """The piece spoken; `line` is the whole text, the context in which characters are read; `take` gets the sound
    meanwhile. Raises `VoiceFailure`."""
    parts: list[Part | float] = []
    for run in _runs(units(piece, line)):
        if run[0].foreign:
            within = Piece(run[0].foreign, piece.first + run[0].first, piece.first + run[0].last, ())
            manner = voices.manner(replace(voice, language=FOREIGN))
            parts.append(alphabetic.speak(espeak, within, manner, take))
        else:
            parts.append(_speak_run(espeak, piece, run, voices.manner(voice), take))
    return joined(parts)


def units(piece: Piece, line: str) -> tuple[Unit, ...]:
    """The piece cut into characters with their syllables, numbers, punctuation and foreign words."""
    read = _readings(line)[piece.first : piece.last]
    found: list[Unit] = []
    written = piece.readings()
    at = 0
    while at < len(piece.text):
        unit = (
            _written(piece, at, written.get(piece.first + at))
            or _number(piece, at)
            or _foreign(piece, at)
            or _character(piece, at, read[at])
        )
        found.append(unit)
        at = unit.last
    return tuple(found)


@lru_cache(maxsize=256)
def _readings(line: str) -> tuple[str, ...]:
    """The syllable of each character of a line in its context; a character that has none stands for itself."""
    from pypinyin import Style, lazy_pinyin  # 0.2 s to import: only Mandarin lines pay it

    read: list[str] = []
    for found in lazy_pinyin(line, Style.TONE3, v_to_u=False, neutral_tone_with_five=True, tone_sandhi=True):
        as_it_is = line.startswith(found, len(read))
        read += list(found) if as_it_is else [found]
    return tuple(read)


def _written(piece: Piece, at: int, mark: Stretch | None) -> Unit | None:
    """The next character of a stretch with the written reading `mark`, or all of it where it has no characters."""
    if mark is None:
        return None
    text = piece.text[mark.start - piece.first : mark.end - piece.first]
    syllables = tuple(numbered(syllable) for syllable in mark.value.split())
    places = [index for index, sign in enumerate(text, mark.start - piece.first) if is_letter(sign)]
    if len(syllables) == len(places):
        return _unit(piece, at, at + 1, (syllables[places.index(at)],)) if at in places else None
    if any(map(is_han, text)) or not syllables:
        raise VoiceFailure(_count_of(mark, text, len(syllables), len(places)), "FS502")
    return _unit(piece, at, mark.end - piece.first, syllables)


def _count_of(mark: Stretch, text: str, syllables: int, characters: int) -> str:
    return f"`{mark.value}` has {syllables} syllables and `{text}` has {characters} characters"


def _number(piece: Piece, at: int) -> Unit | None:
    match = NUMBER.match(piece.text, at)
    if not match:
        return None
    year = len(match[1]) == 4 and match[1].isdigit() and piece.text[match.end() : match.end() + 1] == "年"
    read = ("百分之" if match[2] else "") + chinese(match[1], year)
    return _unit(piece, at, match.end(), tuple(_syllable(sound) for sound in _readings(read)))


def _foreign(piece: Piece, at: int) -> Unit | None:
    """A stretch of letters that are not Chinese, with the spaces inside it."""
    end = at
    for index in range(at, len(piece.text)):
        sign = piece.text[index]
        if is_han(sign) or sign.isdecimal() or sign in MARKS:
            break
        if is_letter(sign):
            end = index + 1
        elif end == at:
            break
    return Unit(at, end, foreign=piece.text[at:end]) if end > at else None


def _character(piece: Piece, at: int, read: str) -> Unit:
    if is_han(piece.text[at]) and read != piece.text[at]:
        return _unit(piece, at, at + 1, (_syllable(read),))
    if is_han(piece.text[at]):
        raise VoiceFailure(f"no reading of `{piece.text[at]}` is known; write one, as in `[read zhang3]长[/]`", "FS502")
    return Unit(at, at + 1, mark=MARKS.get(piece.text[at], " "))


def _syllable(read: str) -> str:
    """The dictionary's syllable as this module writes it: the dictionary has r5 for 儿 and bare sounds too."""
    base = "er" if read[:-1] == "r" else read[:-1]
    return numbered(base + read[-1])


def _unit(piece: Piece, first: int, last: int, syllables: tuple[str, ...]) -> Unit:
    place = piece.first + first
    stressed = any(mark.kind == "stress" and mark.start <= place < mark.end for mark in piece.marks)
    return Unit(first, last, syllables, stressed=stressed)


def _runs(found: Sequence[Unit]) -> Iterator[list[Unit]]:
    """Units that are spoken at once: Mandarin together, each foreign stretch alone; marks alone fall away."""
    run: list[Unit] = []
    for unit in found:
        if unit.foreign:
            if any(earlier.syllables for earlier in run):
                yield run
            yield [unit]
            run = []
        else:
            run.append(unit)
    if any(unit.syllables for unit in run):
        yield run


def _speak_run(espeak: Espeak, piece: Piece, run: Sequence[Unit], manner: Manner, take: Take) -> Part:
    text, places = "", []
    ssml = any(unit.stressed for unit in run)
    for unit, before, after in zip(run, [None, *run], [*run[1:], None], strict=False):
        if unit.stressed and not (before and before.stressed):
            text += alphabetic.EMPHASIS[0]
        for syllable in unit.syllables:
            places.append(len(text))
            text += RESPELT.get(syllable[:-1], syllable[:-1]) + syllable[-1] + " "
        text = text.rstrip() + unit.mark if unit.mark.strip() else text
        if unit.stressed and not (after and after.stressed):
            text += alphabetic.EMPHASIS[1]
    text = text.rstrip()
    trim = Trim(take)
    said = text if text[-1] in ".?!,;:" else text + ","
    part = _timed(piece, run, places, espeak.speak(Utterance(said, **asdict(manner), ssml=ssml), trim))
    trim.finish(part)
    return part


def _timed(piece: Piece, run: Sequence[Unit], places: list[int], sound: Sound) -> Part:
    heard = [phone for phone in phones(sound) if phone.symbol]
    starts = _starts(places, sound)
    if len(starts) < len(places) or not heard:
        raise VoiceFailure(f"it spoke {len(starts)} of the {len(places)} syllables of `{piece.text.strip()}`")
    limits = [*starts[1:], heard[-1].end]
    words: list[WordTime] = []
    mouth: list[PhoneTime] = []
    spans = iter(zip(starts, limits, strict=True))
    for unit in run:
        times = []
        for syllable in unit.syllables:
            start, limit = next(spans)
            within = [phone for phone in heard if start <= phone.start < limit]
            times.append((start, within[-1].end if within else limit))
            if mouth and start - mouth[-1].end > SILENCE:
                mouth.append(PhoneTime("", mouth[-1].end, start))
            mouth += timed(syllable, *times[-1], _release(syllable, within, start))
        if times:
            text = piece.text[unit.first : unit.last]
            words.append(WordTime(text, piece.first + unit.first, piece.first + unit.last, times[0][0], times[-1][1]))
    return trimmed(Part(sound.pcm, tuple(words), tuple(mouth)), (heard[0].start, heard[-1].end))


def _starts(places: list[int], sound: Sound) -> list[float]:
    """When each syllable begins: the word event at its place."""
    wanted = set(places)
    begun: dict[int, float] = {}
    for event in sound.events:
        if event.kind == "word" and event.place in wanted:
            begun.setdefault(event.place, event.sample / RATE)
    return [begun[place] for place in places if place in begun]


def _release(syllable: str, within: Sequence[PhoneTime], start: float) -> float:
    """When the lips part: at the burst of b and p, at the end of the sound of m and f."""
    if not within:
        return start
    return within[0].start if syllable[0] in "bp" else within[0].end
