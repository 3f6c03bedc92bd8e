"""A recording without text to a spoken line: its sound, and the phones that are heard in it."""

from __future__ import annotations

from facescript.speech.listen.listened import listened
from facescript.speech.listen.loop import installed, looped
from facescript.speech.model import Doubt, Spoken
from facescript.speech.sound.recording import Recording

UNHEARD = Doubt("FS521", "there is only silence or noise in it")


def alone(recording: Recording, language: str) -> Spoken:
    """The line: English by pocketsphinx where that is installed, all else by the mouth's own ear.

    It has no words; where nothing is heard in it, that is a doubt and the mouth stays at rest. Whether somebody speaks
    the ear says for pocketsphinx too, which hears phones in silence.
    """
    phones = listened(recording)
    heard = any(phone.symbol for phone in phones)
    if heard and language.lower().split("-")[0] == "en" and installed():
        phones = looped(recording)
    doubts = recording.doubts if heard else (*recording.doubts, UNHEARD)
    return Spoken(recording.pcm, recording.rate, recording.duration, (), phones, doubts=doubts)
