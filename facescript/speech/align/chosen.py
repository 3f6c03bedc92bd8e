"""A pause chosen by hand, or the first clear one, to all that are like it (Algorithm 3.1), where sentences may end."""

from __future__ import annotations

from itertools import pairwise

from facescript.speech.align.activity import Stretch, speaking
from facescript.speech.align.features import Floats, spectrum
from facescript.speech.align.reference import HOP
from facescript.speech.align.segments import first_clear, silences, speaking_parts
from facescript.speech.sound.recording import Recording

FIRST = "first"


def chosen_pauses(recording: Recording, pause: Stretch | str) -> tuple[Stretch, ...]:
    """The silences between the speaking parts of a recording, by its `pause` or by its first clear one; none where
    there is no clear one."""
    chosen = pause if isinstance(pause, Stretch) else first_clear(speaking(_bands(recording), HOP))
    if chosen is None:
        return ()
    parts = speaking_parts(silences(recording.samples, recording.rate, chosen), recording.duration)
    return tuple(Stretch(before.end, after.start) for before, after in pairwise(parts))


def _bands(recording: Recording) -> Floats:
    return spectrum(recording.samples, recording.rate, HOP)
