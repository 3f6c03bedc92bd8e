"""Written readings of a line to whether they can be readings at all, before any voice is asked."""

from __future__ import annotations

from facescript.ir.acts import Say, Stretch
from facescript.speech.espeak.manner import MANDARIN
from facescript.speech.lines import is_letter
from facescript.speech.mandarin.phonetic import syllables_of
from facescript.speech.model import VoiceFailure
from facescript.speech.mouth.ipa import mnemonics


def ipa_of(mark: Stretch) -> str | None:
    """The IPA of a reading written `/.../`; None for a reading in letters."""
    return mark.value[1:-1] if len(mark.value) > 1 and mark.value[0] == mark.value[-1] == "/" else None


def check_readings(line: Say) -> None:
    """Raises `VoiceFailure` (FS502) at a reading that cannot be one in the line's language."""
    mandarin = line.voice.language.lower() in MANDARIN
    for mark in line.stretches:
        if mark.kind != "reading":
            continue
        if mandarin:
            syllables_of(mark.value)
        elif (ipa := ipa_of(mark)) is not None:
            mnemonics(ipa)
        elif not any(map(is_letter, mark.value)):
            raise VoiceFailure(f"`{mark.value}` has no letter in it", "FS502")
