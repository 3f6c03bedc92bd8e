"""Lines in English to speech by the program flite, with the times of their words and phones."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import replace
from difflib import get_close_matches
from functools import cached_property
from itertools import pairwise

from facescript.ir.acts import Say, Voice
from facescript.speech.espeak.parts import Part, joined, spoken, trimmed
from facescript.speech.flite import program
from facescript.speech.flite.program import Manner
from facescript.speech.lines import Piece, is_letter, pieces, words
from facescript.speech.model import Spoken, VoiceFailure
from facescript.speech.readings import check_readings, ipa_of
from facescript.speech.voices.engine import stamp
from facescript.speech.voices.manner import doubts, with_bursts
from facescript.speech.voices.wording import begun_words, word_times
from facescript.world import World

SLOWEST, FASTEST = 0.4, 2.5
LOWEST, HIGHEST = 0.5, 2.0

STRETCHED = {"kal": 1.1, "kal16": 1.1}
"""Voices that are slower than their model of their own accord, by how much."""

TONELESS = ("rms",)
"""Voices whose pitch cannot be changed."""

ENDS = re.compile(r"(?:(?<=\w\w[.])|(?<=[!?…]))[\"'”’)]*\s+(?=[\"'“‘(]*[A-Z0-9])")
"""Where a sentence may end: not behind an initial."""

TITLES = ("Dr.", "Mr.", "Mrs.", "Ms.", "Prof.", "St.", "Sr.", "Jr.", "vs.", "No.", "Mt.", "Co.")

SIGNS = str.maketrans({"’": "'", "‘": "'", "“": '"', "”": '"', "–": ", ", "—": ", "})


class FliteEngine:
    """flite, called once for each sentence, and once for the words of each."""

    def speak(self, line: Say) -> Spoken:
        manner = self._manner(line.voice)
        check_readings(line)
        parts = [part if isinstance(part, float) else _piece(part, manner) for part in pieces(line)]
        rate = next(part.rate for part in parts if isinstance(part, Part))
        unable = ("range", "stress", "pitch") if manner.voice in TONELESS else ("range", "stress")
        return replace(spoken(joined(parts, rate)), doubts=doubts(line, unable))

    def identity(self, voice: Voice) -> str:
        found = program.program()
        return "" if found is None else stamp(found)

    def voices(self) -> Iterable[tuple[str, str]]:
        return tuple((f'en-us flite "{name}"', "English") for name in self._names)

    @cached_property
    def _names(self) -> tuple[str, ...]:
        return program.voice_names()

    def _manner(self, voice: Voice) -> Manner:
        if voice.language.split("-")[0] != "en":
            raise VoiceFailure(f"flite speaks English, not `{voice.language}`")
        if voice.variant not in self._names:
            near = get_close_matches(voice.variant, self._names, 3, 0.0)
            raise VoiceFailure(f"flite has no voice `{voice.variant}`; it has {', '.join(f'`{one}`' for one in near)}")
        for name, factor, low, high in (
            ("rate", voice.rate, SLOWEST, FASTEST),
            ("pitch", voice.pitch, LOWEST, HIGHEST),
        ):
            if not low <= factor <= high:
                raise VoiceFailure(f"a {name} of {factor:.0%} lies outside what flite speaks, {low:.0%} to {high:.0%}")
        return Manner(voice.variant, STRETCHED.get(voice.variant, 1.0) / voice.rate, voice.pitch)


def open_flite(world: World) -> FliteEngine:
    """The engine; it reads nothing of a project."""
    return FliteEngine()


def _piece(piece: Piece, manner: Manner) -> Part:
    _check_letters(piece)
    parts = [_sentence(sentence, manner) for sentence in _sentences(piece)]
    whole = joined(parts, parts[0].rate)
    sounding = [phone for phone in whole.phones if phone.symbol]
    return trimmed(whole, (sounding[0].start, sounding[-1].end))


def _sentences(piece: Piece) -> Iterator[Piece]:
    """The sentences of a piece that have something to say, each spoken at once."""
    ends = [found.end() for found in ENDS.finditer(piece.text) if not piece.text[: found.start()].endswith(TITLES)]
    for first, last in pairwise([0, *ends, len(piece.text)]):
        if any(map(is_letter, piece.text[first:last])):
            yield Piece(piece.text[first:last], piece.first + first, piece.first + last, piece.marks)


def _sentence(piece: Piece, manner: Manner) -> Part:
    found = words(piece.text)
    sound = program.speak(_said(piece, 0, len(piece.text)), manner)
    apart = program.words_apart([_said(piece, word.first, word.last) for word in found], manner)
    heard = tuple(with_bursts(sound.phones))
    if not any(phone.symbol for phone in heard):
        raise VoiceFailure(f"flite has no sound for `{piece.text.strip()}`", "FS503")
    return Part(sound.pcm, word_times(piece, begun_words(heard, apart), heard), heard, sound.rate)


def _said(piece: Piece, first: int, last: int) -> str:
    """A stretch of the piece as flite takes it: readings in place of what they stand for, in ASCII, in one line."""
    readings = piece.readings()
    text = ""
    for at in range(first, last):
        reading = readings.get(piece.first + at)
        if reading is None:
            text += piece.text[at]
        elif reading.start == piece.first + at:
            text += reading.value
    return " ".join(_ascii(text).split())


def _ascii(text: str) -> str:
    plain = unicodedata.normalize("NFKD", text.translate(SIGNS))
    kept = "".join(" " if unicodedata.category(sign)[0] == "C" else sign for sign in plain)
    return kept.encode("ascii", "ignore").decode()


def _check_letters(piece: Piece) -> None:
    """Raises `VoiceFailure` for what flite would pass over: letters that are not Latin, and IPA."""
    for mark in piece.marks:
        if mark.kind == "reading" and ipa_of(mark) is not None:
            raise VoiceFailure(f"flite takes another spelling, not IPA as in `{mark.value}`", "FS502")
    covered = piece.readings()
    for at, sign in enumerate(piece.text, piece.first):
        if sign.isalpha() and at not in covered and not _ascii(sign):
            raise VoiceFailure(f"flite reads Latin letters only; write the reading of `{sign}`", "FS502")
