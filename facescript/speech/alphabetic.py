"""A piece in a language whose letters the synthesiser reads, to sound and the times of its words."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field

from facescript.ir.acts import Stretch
from facescript.speech.espeak import Espeak, Sound, Utterance
from facescript.speech.ipa import letters, mnemonics
from facescript.speech.lines import CLAUSE_ENDS, Piece, Word, is_han, is_letter, words
from facescript.speech.model import PhoneTime, VoiceFailure, WordTime
from facescript.speech.parts import RATE, Part, phones, trimmed
from facescript.speech.voices import Manner

EMPHASIS = "<emphasis level='strong'> ", " </emphasis>"
"""A space inside: espeak-ng reads a tag that touches `]]` aloud."""


@dataclass(slots=True)
class Sent:
    """The text that is sent: `places` holds the character of the piece behind each of its characters."""

    text: list[str] = field(default_factory=list)
    places: list[int] = field(default_factory=list)

    def add(self, text: str, place: int) -> None:
        self.text.append(text)
        self.places += [place] * len(text)


def speak(espeak: Espeak, piece: Piece, manner: Manner) -> Part:
    """The piece spoken. Raises `VoiceFailure`."""
    ssml = any(mark.kind == "stress" for mark in piece.marks)
    readings = tuple(mark for mark in piece.marks if mark.kind == "reading")
    _check_kanji(piece, manner, readings)
    sent = _sent(piece, ssml)
    sounds = any(_is_ipa(mark) for mark in readings)
    text = "".join(sent.text)
    sound = espeak.speak(Utterance(text, manner.voice, manner.rate, manner.pitch, ssml, sounds))
    heard = phones(sound)
    for mark in readings:
        if _is_ipa(mark):
            _check_said(sound, sent, piece, mark, manner)
    sounding = [phone for phone in heard if phone.symbol]
    if not sounding:
        raise VoiceFailure(f"the voice `{manner.voice}` has no sound for `{piece.text.strip()}`", "FS503")
    part = Part(sound.pcm, _word_times(piece, sent, sound, heard), heard)
    return trimmed(part, (sounding[0].start, sounding[-1].end))


def _sent(piece: Piece, ssml: bool) -> Sent:
    sent = Sent()
    for at, sign in enumerate(piece.text):
        for mark in piece.marks:
            if mark.kind == "stress" and mark.start == piece.first + at:
                sent.add(EMPHASIS[0], at)
        _add(sent, piece, at, sign, ssml)
        for mark in piece.marks:
            if mark.kind == "stress" and mark.end == piece.first + at + 1:
                sent.add(EMPHASIS[1], at)
    if piece.text.rstrip()[-1:] not in tuple(CLAUSE_ENDS) and piece.text.strip():
        sent.add(",", len(piece.text) - 1)  # a piece that a pause cuts off goes on: the voice must not fall
    return sent


def _add(sent: Sent, piece: Piece, at: int, sign: str, ssml: bool) -> None:
    """One character of the piece, or the reading that begins at it."""
    for mark in piece.marks:
        if mark.kind == "reading" and mark.start <= piece.first + at < mark.end:
            if mark.start == piece.first + at:
                spelt = f"[[{mnemonics(_ipa(mark))}]]" if _is_ipa(mark) else mark.value
                sent.add(_escaped(spelt) if ssml and not _is_ipa(mark) else spelt, at)
            return
    plain = {"[": "(", "]": ")", "\n": " "}.get(sign, sign)
    sent.add(_escaped(plain) if ssml else plain, at)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")


def _is_ipa(mark: Stretch) -> bool:
    return len(mark.value) > 1 and mark.value.startswith("/") and mark.value.endswith("/")


def _ipa(mark: Stretch) -> str:
    return mark.value[1:-1]


def _check_kanji(piece: Piece, manner: Manner, readings: tuple[Stretch, ...]) -> None:
    """Japanese characters without a reading are read out as "Chinese letter"."""
    if not manner.voice.split("+")[0].endswith("/ja"):
        return
    for at, sign in enumerate(piece.text, piece.first):
        if is_han(sign) and not any(mark.start <= at < mark.end for mark in readings):
            reason = f"the Japanese voice reads kana only; write the reading of `{sign}`, as in `[read かんじ]漢字[/]`"
            raise VoiceFailure(reason, "FS502")


def _check_said(sound: Sound, sent: Sent, piece: Piece, mark: Stretch, manner: Manner) -> None:
    """The voice skips a sound that it does not have: fewer are heard than were written."""
    span = range(mark.start - piece.first, mark.end - piece.first)
    said = "".join(
        event.symbol
        for event in sound.events
        if event.kind == "phone" and _place(sent, event.place) in span and not event.symbol.startswith("(")
    )
    if len(letters(said)) < len(letters(_ipa(mark))):
        raise VoiceFailure(f"of `{mark.value}` the voice `{manner.voice}` says only `/{said}/`", "FS502")


def _place(sent: Sent, index: int) -> int:
    return sent.places[min(index, len(sent.places) - 1)]


def _word_times(piece: Piece, sent: Sent, sound: Sound, heard: tuple[PhoneTime, ...]) -> tuple[WordTime, ...]:
    """A word begins with the first event in it; words that the voice runs together share its time by their length."""
    found = words(piece.text)
    begun = _begun(found, sent, sound)
    total = heard[-1].end
    times: list[WordTime] = []
    for (index, start), (following, limit) in zip(begun, [*begun[1:], (len(found), total)], strict=True):
        end = max((p.end for p in heard if p.symbol and start <= p.start < limit), default=limit)
        times += _shared(piece, found[index:following], start, min(end, limit))
    return tuple(times)


def _begun(found: tuple[Word, ...], sent: Sent, sound: Sound) -> list[tuple[int, float]]:
    """The words at which an event stands, by number, with the second at which they begin; always the first."""
    ends = [word.last for word in found]
    begun: list[tuple[int, float]] = []
    for event in sound.events:
        if event.kind == "word":
            index = bisect_right(ends, _place(sent, event.place))
            if index < len(found) and (not begun or index > begun[-1][0]):
                begun.append((index if begun else 0, event.sample / RATE))
    return begun or [(0, 0.0)]


def _shared(piece: Piece, group: tuple[Word, ...], start: float, end: float) -> list[WordTime]:
    letters_in = [sum(map(is_letter, piece.text[word.first : word.last])) for word in group]
    share, at, times = (end - start) / sum(letters_in), start, []
    for word, count in zip(group, letters_in, strict=True):
        text = piece.text[word.first : word.last]
        times.append(WordTime(text, piece.first + word.first, piece.first + word.last, at, at + share * count))
        at += share * count
    return times
