"""What the tests of speech share: a line to say, and its words and phones as a text to read."""

from __future__ import annotations

from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.model import Spoken


def line(text: str, language: str = "en-us", *marks: Stretch, variant: str = "", rate: float = 1.0) -> Say:
    return Say(text, Voice(language, variant, rate), tuple(marks))


def over(text: str, part: str, kind: str, value: str = "") -> Stretch:
    """A mark over the first `part` of a text."""
    start = text.index(part)
    return Stretch(kind, start, start + len(part), value)  # type: ignore[arg-type]


def words_of(spoken: Spoken) -> str:
    return " ".join(word.text for word in spoken.words)


def phones_of(spoken: Spoken) -> str:
    return " ".join(("ˈ" if phone.stress else "") + (phone.symbol or "_") for phone in spoken.phones)
