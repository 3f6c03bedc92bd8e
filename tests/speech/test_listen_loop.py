"""English by pocketsphinx's loop: names to IPA, closures to what is before them, and long sound in stretches."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from facescript.speech.listen import loop
from facescript.speech.listen.loop import bursting, labelled
from facescript.speech.model import PhoneTime
from facescript.speech.sound.recording import Recording


def test_names_become_ipa_up_to_the_end_of_the_sound() -> None:
    found = labelled([("SIL", 0.2), ("HH", 0.25), ("+NSN+", 0.4), ("ER", 0.6), ("T", 0.8)], 0.7, 10.0)
    assert [phone.symbol for phone in found] == ["", "h", "", "ɝ", "t"]
    assert (found[0].start, found[1].start, found[-1].end) == (10.0, 10.2, 10.7)
    assert labelled([], 0.5) == [PhoneTime("", 0.0, 0.5)]


def test_a_stop_begins_at_its_burst() -> None:
    found = list(bursting([PhoneTime("a", 0.0, 0.2), PhoneTime("p", 0.2, 0.29), PhoneTime("o", 0.29, 0.5)]))
    assert [round(phone.start, 3) for phone in found] == [0.0, 0.26, 0.29]
    assert all(one.end == other.start for one, other in pairwise(found))


def test_long_sound_is_heard_in_stretches_without_a_gap(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pocketsphinx", reason="the extra `english` is not installed")
    monkeypatch.setattr(loop, "LONGEST", 1.0)
    monkeypatch.setattr(loop, "SHORTEST", 0.5)
    sound = np.random.default_rng(1).integers(-3000, 3000, 20_000).astype("<i2")
    found = loop.looped(Recording(sound, 8_000))
    assert (found[0].start, found[-1].end) == (0.0, pytest.approx(2.5, abs=0.01))
    assert all(one.end == pytest.approx(other.start) for one, other in pairwise(found))
