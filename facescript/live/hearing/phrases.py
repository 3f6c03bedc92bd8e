"""The phrases that a script waits for to what a recogniser of English is to listen for: words, and how they sound."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from facescript.ir.acts import Say, Voice
from facescript.ir.play import Play
from facescript.ir.wording import words
from facescript.speech.align.sphinx import names
from facescript.speech.model import VoiceBox

ENGLISH = Voice("en-us")

MOST = 200
"""Phrases that are listened for at once."""

LONGEST = 12
"""Words of a phrase."""


@dataclass(frozen=True, slots=True)
class Phrase:
    """What an event is to say, and the words of it, in small letters."""

    text: str
    words: tuple[str, ...]


def awaited(play: Play) -> tuple[str, ...]:
    """The texts of all `when heard "..."`, each once, in the order written."""
    return tuple(dict.fromkeys(one.event.text for one in play.reactions if one.event.kind == "heard"))


def is_english(play: Play) -> bool:
    """Whether some face of a play speaks English, so that its phrases may be."""
    return any(face.voice.language.lower().split("-")[0] == "en" for face in play.faces)


def phrases(texts: Iterable[str]) -> list[Phrase]:
    """The texts that can be listened for: of Latin letters, and no longer than a breath."""
    found = [Phrase(text, tuple(bare.lower() for bare, _, _ in words(text))) for text in texts]
    return [one for one in found if one.words and len(one.words) <= LONGEST and "".join(one.words).isascii()][:MOST]


def sounds_of(word: str, voice: VoiceBox) -> tuple[str, ...]:
    """How a voice says a word that no dictionary has, as names of sounds (ARPAbet). Raises `VoiceFailure`."""
    phones = voice.speak(Say(word, ENGLISH)).phones
    return tuple(name for phone in phones for name in names(phone.symbol))
