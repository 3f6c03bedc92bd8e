"""A recording alone: its mouth against the voice's own phonemes, and every kind of sound that is no speech."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from listen_voices import espeak
from measure_listen import recalls
from numpy.typing import NDArray
from saying import line

from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.listen.alone import alone
from facescript.speech.listen.classes import CLASSES, frames
from facescript.speech.listen.listened import listened
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.mouthing import mouth_shapes
from facescript.speech.sound.recording import Recording

RATE = 22_050


def sound_of(values: NDArray[np.float64], rate: int = RATE) -> Recording:
    return Recording(np.rint(np.clip(values, -1.0, 1.0) * 32_767).astype("<i2"), rate)


def noise(seconds: float, height: float) -> NDArray[np.float64]:
    return height * np.random.default_rng(2).standard_normal(round(seconds * RATE))


def music(seconds: float) -> NDArray[np.float64]:
    times = np.arange(round(seconds * RATE)) / RATE
    return np.sum([0.2 * np.sin(2 * np.pi * each * times) for each in (262.0, 330.0, 392.0, 1047.0)], axis=0)


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en-us", "Many people began to move the heavy boxes, but the farmer and a woman stayed at home."),
        ("cmn", "我们坐船去看美丽的大海,妈妈买了面包和苹果。"),
    ],
)
def test_the_mouth_is_that_of_what_was_said(language: str, text: str) -> None:
    takes = [espeak(text, language, variant) for variant in ("f2", "m7")]
    assert np.mean(recalls(takes, listened)) > 0.7


@pytest.mark.usefixtures("synthesiser")
def test_loudness_and_rate_of_the_file_hardly_matter() -> None:
    take = espeak("The baby made a funny face at my mother.", "en-us").recording
    whole = take.samples.astype(np.float64) / 32_768.0
    quiet = sound_of(whole / 20.0)
    slower = np.interp(np.arange(round(len(whole) * 16_000 / RATE)) * RATE / 16_000, np.arange(len(whole)), whole)
    count = round(take.duration * 60)
    heard = frames(listened(take), count)[1]
    assert (frames(listened(quiet), count)[1] == heard).mean() > 0.95
    assert (frames(listened(sound_of(slower, 16_000)), count)[1] == heard).mean() > 0.85


@pytest.mark.usefixtures("synthesiser")
def test_lips_close_where_a_b_was_said() -> None:
    take = espeak("Abba, abba, abba.", "it")
    bursts = [phone.start for phone in take.phones if phone.symbol.startswith("b")]
    shut = [shape for shape in mouth_shapes(listened(take.recording)) if shape.name == "m"]
    assert len(bursts) == 3
    assert all(any(shape.on - 0.05 <= burst <= shape.off + 0.05 for shape in shut) for burst in bursts)


@pytest.mark.parametrize(
    "values",
    [
        np.zeros(0),
        np.zeros(1),
        np.zeros(RATE),
        noise(0.01, 0.5),
        noise(2.0, 0.3),
        music(2.0),
        np.clip(40.0 * music(1.0), -1.0, 1.0),
        np.ones(RATE),
    ],
    ids=["nothing", "one sample", "silence", "a click", "noise", "music", "clipped", "a level"],
)
def test_any_sound_has_phones_from_its_start_to_its_end(values: NDArray[np.float64]) -> None:
    recording = sound_of(values)
    found = listened(recording)
    assert found == listened(recording)
    assert [one.end for one, _ in pairwise(found)] == [other.start for _, other in pairwise(found)]
    assert (found[0].start, found[-1].end) == (0.0, pytest.approx(recording.duration)) if len(values) else not found


def test_in_silence_and_noise_the_mouth_rests() -> None:
    assert {phone.symbol for phone in listened(sound_of(noise(2.0, 0.1)))} == {""}
    assert {phone.symbol for phone in listened(sound_of(np.zeros(RATE)))} == {""}
    assert {phone.symbol for phone in listened(sound_of(noise(1.0, 1e-4)))} == {""}


@pytest.mark.usefixtures("synthesiser")
def test_between_sentences_the_mouth_rests() -> None:
    said = espeak("Good morning.", "en-us").recording.samples
    gap = np.zeros(RATE, dtype="<i2")
    found = listened(Recording(np.concatenate([said, gap, said]), RATE))
    middle = len(said) / RATE + 0.5
    assert [phone.symbol for phone in found if phone.start <= middle < phone.end] == [""]


def test_the_classes_are_the_mouths() -> None:
    phones = [PhoneTime(symbol, place * 0.2, place * 0.2 + 0.2) for place, symbol in enumerate("mfsɛiaæouy")]
    classes = frames(phones, 120)[1][6::12]
    assert [CLASSES[place] for place in classes] == (["closed"] * 2 + ["narrow"] * 3 + ["open"] * 2 + ["round"] * 3)


def test_a_stop_is_shut_before_its_burst_and_not_behind_it() -> None:
    phones = [PhoneTime("a", 0.0, 0.2), PhoneTime("p", 0.2, 0.3), PhoneTime("o", 0.3, 0.5)]
    said = [CLASSES[place] for place in frames(phones, 30)[1]]
    assert said == ["open"] * 8 + ["closed"] * 4 + ["round"] * 18


@pytest.mark.usefixtures("synthesiser")
def test_a_line_without_text_is_heard_and_silence_is_told_of() -> None:
    spoken = open_voice().speak(line("Hello."))
    found = alone(Recording(np.frombuffer(spoken.pcm, dtype="<i2"), spoken.rate), "de")
    assert (found.pcm, found.words, found.doubts) == (spoken.pcm, (), ())
    assert any(phone.symbol for phone in found.phones)
    assert [doubt.code for doubt in alone(sound_of(np.zeros(RATE)), "de").doubts] == ["FS521"]
