"""A Mandarin piece to syllables, sound, and the time of every character."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace

from facescript.ir.acts import Voice
from facescript.speech.espeak import alphabetic
from facescript.speech.espeak.client import Espeak, Sound, Utterance
from facescript.speech.espeak.manner import Manner, Voices
from facescript.speech.espeak.parts import RATE, Part, Take, Trim, joined, phones, trimmed, unheard
from facescript.speech.lines import Piece
from facescript.speech.mandarin.syllables import timed
from facescript.speech.mandarin.units import Unit, units
from facescript.speech.model import PhoneTime, VoiceFailure, WordTime

RESPELT = {"jiong": "jong", "qiong": "qong", "xiong": "xong", "wong": "weng", "ê": "ei", "hm": "heng", "hng": "heng"}
RESPELT |= {"n": "en", "m": "mu", "ng": "eng", "r": "er"}
"""Syllables that the voice `cmn-latn-pinyin` would spell out in English, as its nearest."""

BREAKS = tuple(",.?!;:")
"""Behind these another mark of punctuation adds nothing."""

SILENCE = 0.1
"""A longer gap between syllables is a silence of its own, in seconds."""


def speak(espeak: Espeak, piece: Piece, line: str, voices: Voices, voice: Voice, take: Take = unheard) -> Part:
    """The piece spoken; `line` is the whole text, the context in which characters are read; `take` gets the sound
    meanwhile. Raises `VoiceFailure`."""
    parts: list[Part | float] = []
    for run in _runs(units(piece, line)):
        if run[0].foreign:
            within = Piece(run[0].foreign, piece.first + run[0].first, piece.first + run[0].last, ())
            manner = voices.manner(replace(voice, language=run[0].language))
            parts.append(alphabetic.speak(espeak, within, manner, take))
        else:
            parts.append(_speak_run(espeak, piece, run, voices.manner(voice), take))
    return joined(parts)


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
        if unit.mark.strip() and text.rstrip()[-1:] not in BREAKS:
            text = text.rstrip() + unit.mark
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
    begins = [phone.start for phone in heard]
    words: list[WordTime] = []
    mouth: list[PhoneTime] = []
    spans = iter(zip(starts, limits, strict=True))
    for unit in run:
        times = []
        for syllable in unit.syllables:
            start, limit = next(spans)
            within = heard[bisect_left(begins, start) : bisect_left(begins, limit)]
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
