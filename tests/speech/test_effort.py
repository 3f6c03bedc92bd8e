"""How far the jaw goes with the voice: loud and soft lines, words, whispers, the volume; and what stress does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from facescript.speech.model import PhoneTime, Spoken
from facescript.speech.mouth.effort import EVEN, Effort, normal_level
from facescript.speech.mouth.mouthing import mouth_shapes

RATE = 22_050
SYMBOLS = "a t a t a t a t".split()


def voice(*levels: float, whispered: bool = False, symbols: list[str] = SYMBOLS) -> Spoken:
    """Syllables of 0.2 s, each so many dB louder than 0.1 of full scale: at 120 Hz, or of noise."""
    times = np.arange(round(0.2 * RATE * len(levels))) / RATE
    wave = sum(np.sin(2.0 * np.pi * 120.0 * part * times) / part for part in (1, 2, 3, 4))
    if whispered:
        wave = np.random.default_rng(1).normal(0.0, 0.5, len(times))
    gain = np.repeat(10.0 ** (np.array(levels) / 20.0), round(0.2 * RATE))[: len(times)]
    pcm = (np.clip(0.05 * wave * gain, -1, 1) * 32767).astype("<i2").tobytes()
    length = 0.2 * len(levels) / len(symbols)
    phones = [PhoneTime(symbol, at * length, (at + 1) * length) for at, symbol in enumerate(symbols)]
    return Spoken(pcm, RATE, 0.2 * len(levels), (), tuple(phones))


USUAL = voice(0, 0, 0, 0)


def jaws(spoken: Spoken, normal: float | None = None, volume: float = 1.0) -> list[float]:
    """How far the jaw goes in each vowel, beside its usual way."""
    effort = Effort(spoken, normal_level([USUAL]) if normal is None else normal, volume)
    even = {shape.on: shape.values[5] for shape in mouth_shapes(spoken.phones)}
    return [each.effort for each in mouth_shapes(spoken.phones, effort) if each.vowel and each.on in even]


def test_the_usual_voice_opens_the_jaw_as_usual() -> None:
    assert jaws(USUAL) == pytest.approx([1.0] * 4, abs=0.02)
    assert EVEN.line == 1.0 and EVEN.stress(USUAL.phones[0]) == 0.0


def test_a_loud_line_opens_the_jaw_and_a_soft_one_does_not() -> None:
    soft, loud = jaws(voice(-14, -14, -14, -14)), jaws(voice(14, 14, 14, 14))
    assert max(soft) < 0.8 and min(loud) > 1.25 and max(loud) <= 1.5
    assert jaws(voice(2, 2, 2, 2)) == pytest.approx([1.0] * 4, abs=0.02), "so much speakers differ from line to line"


def test_the_volume_of_a_line_is_its_effort() -> None:
    half, double, none = (jaws(USUAL, volume=volume) for volume in (0.5, 2.0, 0.0))
    assert max(none) < 0.7 < max(half) < 0.85 and min(double) > 1.15


def test_a_whisper_does_not_open_the_jaw() -> None:
    whispered = voice(0, 0, 0, 0, whispered=True)
    assert max(jaws(whispered, normal_level([whispered]))) < 0.75


def test_a_word_that_is_louder_opens_further() -> None:
    first, second, third, last = jaws(voice(0, 0, 10, 0))
    assert third > 1.1 > max(first, second, last)


def test_lips_go_on_as_they_were() -> None:
    """What the jaw does moves the lower lip and the gap; corners, rounding and the upper lip stay."""
    shapes = [mouth_shapes(USUAL.phones, Effort(USUAL, normal_level([USUAL]), volume)) for volume in (0.25, 4.0)]
    for soft, loud in zip(*shapes, strict=True):
        assert soft.values[1:4] == loud.values[1:4]
        assert soft.values[0] < loud.values[0] and soft.values[4] < loud.values[4] and soft.values[5] < loud.values[5]


def test_mandarin_shapes_are_the_thesis_s_within_a_line() -> None:
    spoken = voice(0, 8, -8, 0, symbols="zh:a zh:i zh:a zh:u".split())
    effort = Effort(spoken, normal_level([spoken]))
    assert {shape.effort for shape in mouth_shapes(spoken.phones, effort)} == {1.0}


def test_an_accent_in_the_sound_makes_a_vowel_whole() -> None:
    spoken = voice(0, 0, 12, 0)
    shapes = [each for each in mouth_shapes(spoken.phones, Effort(spoken, normal_level([spoken]))) if each.vowel]
    assert shapes[2].degree > max(shapes[0].degree, shapes[1].degree, shapes[3].degree) + 0.05


def test_a_line_without_sound_or_vowels_is_even() -> None:
    for spoken in (
        replace(USUAL, sound=b""),
        replace(USUAL, phones=()),
        replace(USUAL, phones=(PhoneTime("s", 0, 0.4),)),
    ):
        assert Effort(spoken, normal_level([spoken])).line == 1.0
