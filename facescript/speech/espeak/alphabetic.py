"""A piece in a language whose letters the synthesiser reads, to sound and the times of its words."""

from __future__ import annotations

import unicodedata
from bisect import bisect_right
from dataclasses import asdict, dataclass, field

from facescript.ir.acts import Stretch
from facescript.speech.espeak.client import Espeak, Sound, Utterance
from facescript.speech.espeak.manner import Manner
from facescript.speech.espeak.parts import RATE, Part, Take, Trim, phones, trimmed, unheard
from facescript.speech.lines import CLAUSE_ENDS, Piece, Word, is_han, words
from facescript.speech.model import VoiceFailure
from facescript.speech.mouth.ipa import letters, mnemonics
from facescript.speech.readings import ipa_of
from facescript.speech.voices.wording import word_times

EMPHASIS = "<emphasis level='strong'> ", " </emphasis>"
"""A space inside: espeak-ng reads a tag that touches `]]` aloud."""


CLOSERS = " \n\"'”’»)]}」』"
"""What may stand behind the sign that ends a clause."""


@dataclass(slots=True)
class Sent:
    """The text that is sent: `places` holds the character of the piece behind each of its characters."""

    text: list[str] = field(default_factory=list)
    places: list[int] = field(default_factory=list)

    def add(self, text: str, place: int) -> None:
        self.text.append(text)
        self.places += [place] * len(text)


def speak(espeak: Espeak, piece: Piece, manner: Manner, take: Take = unheard) -> Part:
    """The piece spoken; `take` gets its sound meanwhile. Raises `VoiceFailure`."""
    ssml = any(mark.kind == "stress" for mark in piece.marks)
    spelt = {mark: ipa_of(mark) for mark in piece.marks if mark.kind == "reading"}
    sounds = {mark: ipa for mark, ipa in spelt.items() if ipa is not None}
    _check_kanji(piece, manner)
    sent = _sent(piece, ssml)
    text, trim = "".join(sent.text), Trim(take)
    sound = espeak.speak(Utterance(text, **asdict(manner), ssml=ssml, phonemes=bool(sounds)), trim)
    heard = phones(sound)
    for mark, ipa in sounds.items():
        _check_said(sound, sent, piece, mark, ipa)
    sounding = [phone for phone in heard if phone.symbol]
    if not sounding:
        raise VoiceFailure(f"this voice has no sound for `{piece.text.strip()}`", "FS503")
    part = Part(sound.pcm, word_times(piece, _begun(words(piece.text), sent, sound), heard), heard)
    part = trimmed(part, (sounding[0].start, sounding[-1].end))
    trim.finish(part)
    return part


def _sent(piece: Piece, ssml: bool) -> Sent:
    sent = Sent()
    readings = piece.readings()
    opened = {mark.start - piece.first for mark in piece.marks if mark.kind == "stress"}
    closed = {mark.end - piece.first - 1 for mark in piece.marks if mark.kind == "stress"}
    for at, sign in enumerate(piece.text):
        if at in opened:
            sent.add(EMPHASIS[0], at)
        reading = readings.get(piece.first + at)
        if reading is None:
            sent.add(_plain(sign, ssml), at)
        elif reading.start == piece.first + at:
            sent.add(_read(reading, ssml), at)
        if at in closed:
            sent.add(EMPHASIS[1], at)
    if piece.text.rstrip(CLOSERS)[-1:] not in tuple(CLAUSE_ENDS):
        sent.add(",", len(piece.text) - 1)  # a piece that a pause cuts off goes on: the voice must not fall
    return sent


def _plain(sign: str, ssml: bool) -> str:
    """A character as the voice takes it: `[[` would begin phonemes, a control character would end the text."""
    plain = " " if unicodedata.category(sign) == "Cc" else {"[": "(", "]": ")"}.get(sign, sign)
    return _escaped(plain) if ssml else plain


def _read(reading: Stretch, ssml: bool) -> str:
    """A reading as the voice takes it: phonemes for IPA, else another spelling."""
    ipa = ipa_of(reading)
    if ipa is not None:
        return f"[[{mnemonics(ipa)}]]"
    return "".join(_plain(sign, ssml) for sign in reading.value)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")


def _check_kanji(piece: Piece, manner: Manner) -> None:
    """Japanese characters without a reading are read out as "Chinese letter"."""
    if not manner.voice.split("+")[0].endswith("/ja"):
        return
    readings = piece.readings()
    for at, sign in enumerate(piece.text, piece.first):
        if is_han(sign) and at not in readings:
            reason = f"the Japanese voice reads kana only; write the reading of `{sign}`, as in `[read かんじ]漢字[/]`"
            raise VoiceFailure(reason, "FS502")


def _check_said(sound: Sound, sent: Sent, piece: Piece, mark: Stretch, ipa: str) -> None:
    """The voice skips a sound that it does not have: fewer are heard than were written."""
    span = range(mark.start - piece.first, mark.end - piece.first)
    said = "".join(
        event.symbol
        for event in sound.events
        if event.kind == "phone" and _place(sent, event.place) in span and not event.symbol.startswith("(")
    )
    if len(letters(said)) < len(letters(ipa)):
        raise VoiceFailure(f"of `{mark.value}` this voice says only `/{said}/`", "FS502")


def _place(sent: Sent, index: int) -> int:
    return sent.places[min(index, len(sent.places) - 1)]


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
