"""Speech, pauses and sentences: Algorithm 3.1 to its letter, and what fits a text best."""

from __future__ import annotations

import numpy as np
import pytest
from saying import line

from facescript.speech.align.activity import Stretch, speaking
from facescript.speech.align.chosen import FIRST, chosen_pauses
from facescript.speech.align.features import spectrum
from facescript.speech.align.segments import first_clear, fitting, silences, speaking_parts
from facescript.speech.align.sentences import part_of, sentences
from facescript.speech.sound.recording import Recording

RATE = 1000


def sound(*stretches: tuple[float, int]) -> np.ndarray:  # type: ignore[type-arg]
    """Seconds and loudest sample of each stretch, one after another; the sign turns with each sample."""
    parts = [np.resize([level, -level], round(seconds * RATE)) for seconds, level in stretches]
    return np.concatenate(parts).astype(np.int16)


def test_silences_are_at_least_95_percent_as_long_and_145_percent_as_loud() -> None:
    samples = sound((1, 900), (0.4, 100), (1, 900), (0.381, 144), (1, 900), (0.379, 10), (1, 900), (0.5, 146), (1, 900))
    found = silences(samples, RATE, Stretch(1.0, 1.4))
    assert found == (Stretch(1.0, 1.4), Stretch(2.4, 2.781))


def test_silences_begin_with_the_chosen_one() -> None:
    samples = sound((0.6, 0), (1, 900), (0.4, 0), (1, 900), (0.4, 0))
    found = silences(samples, RATE, Stretch(1.6, 2.0))
    assert found == (Stretch(1.6, 2.0), Stretch(3.0, 3.4))
    assert speaking_parts(found, 3.4) == (Stretch(0.0, 1.6), Stretch(2.0, 3.0))


def test_the_first_clear_pause_is_no_breath() -> None:
    spoken = [Stretch(0.0, 1.0), Stretch(1.2, 2.0), Stretch(2.6, 3.0), Stretch(4.0, 5.0)]
    found = first_clear(spoken)
    assert found is not None and (found.start, found.end) == pytest.approx((2.03, 2.57))
    assert first_clear(spoken[:2]) is None


def test_the_best_row_of_pauses_is_taken() -> None:
    pauses = [Stretch(1.0, 1.2), Stretch(2.0, 2.8), Stretch(3.0, 3.2), Stretch(9.0, 9.9)]
    assert fitting([2.9, 3.1], pauses) == (pauses[1], pauses[2])
    assert fitting([1.1, 6.0, 9.5], pauses) == (pauses[0], None, pauses[3])
    assert fitting([1.0], []) == (None,)
    assert fitting([], pauses) == ()


def voiced(*stretches: tuple[float, float]) -> Recording:
    """Seconds of a buzz and seconds of faint noise after it, again and again."""
    rate, parts = 16_000, []
    noise = np.random.default_rng(2)
    for buzz, quiet in stretches:
        at = np.arange(round(buzz * rate)) / rate
        parts.append(sum(np.sin(2 * np.pi * 120 * number * at) for number in range(1, 25)) * 800)
        parts.append(np.zeros(round(quiet * rate)))
    whole = np.concatenate(parts)
    return Recording((whole + noise.normal(0, 20, len(whole))).astype(np.int16), rate)


def test_speech_is_found_in_noise() -> None:
    recording = voiced((0.0, 0.5), (1.0, 0.3), (0.7, 1.0))
    found = speaking(spectrum(recording.samples, recording.rate, 0.01), 0.01)
    assert [each.start for each in found] == pytest.approx([0.5, 1.8], abs=0.04)
    assert [each.end for each in found] == pytest.approx([1.5, 2.5], abs=0.04)


def test_the_pauses_like_the_first_are_found() -> None:
    recording = voiced((1.0, 0.5), (0.8, 0.12), (0.6, 0.6), (1.0, 0.5))
    assert len(chosen_pauses(recording, FIRST)) == 2
    assert len(chosen_pauses(recording, Stretch(1.05, 1.45))) == 2
    assert chosen_pauses(voiced((1.0, 0.0)), FIRST) == ()


def test_sentences_leave_nothing_out() -> None:
    text = 'She said "No." Then 3.5 miles... 😀 去吧！好。 ' + "word, " * 60
    spans = sentences(line(text))
    assert "".join(text[first:last] for first, last in spans) == text
    assert [text[first:last].strip() for first, last in spans[:4]] == [
        'She said "No."',
        "Then 3.5 miles...",
        "😀 去吧！",
        "好。",
    ]
    assert max(last - first for first, last in spans) < 300


def test_a_part_has_its_own_marks() -> None:
    from facescript.ir.acts import Stretch as Mark

    whole = line(
        "One two. Three four.", "en-us", Mark("stress", 9, 14), Mark("breath", 3, 3), Mark("reading", 0, 3, "wan")
    )
    part = part_of(whole, 9, 20)
    assert (part.text, part.stretches) == ("Three four.", (Mark("stress", 0, 5),))
    assert sentences(whole) == ((0, 3), (3, 8), (8, 20))
