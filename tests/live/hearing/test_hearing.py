"""Who speaks is told from what only sounds, in whatever blocks it comes; the face does not hear itself."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from facescript.ir.acts import Say, Voice
from facescript.live.hearing.activity import RATE, Activity, Turn
from facescript.live.hearing.ear import Ear
from facescript.live.hearing.flow import Flow
from facescript.live.hearing.own_voice import AFTER, OwnVoice
from facescript.live.model import Utterance
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.model import Spoken
from facescript.speech.sound.resample import resampled

Samples = NDArray[np.int16]


@pytest.fixture(scope="module")
def room() -> tuple[Samples, list[tuple[float, float]]]:
    """Two sentences and a click in the hum and the noise of a room; when the sentences are, s."""
    pytest.importorskip("espeakng_loader")
    dice = np.random.default_rng(1)
    whole, spans = 120.0 * np.sin(2 * np.pi * 100.0 * np.arange(7 * RATE) / RATE), []
    whole += 60.0 * dice.standard_normal(len(whole))
    for at, text in ((1.5, "Thank you very much."), (4.5, "No.")):
        spoken = process_voice().speak(Say(text, Voice("en-us")))
        samples = np.frombuffer(spoken.pcm, "<i2")
        loud = np.flatnonzero(np.abs(samples.astype(int)) > 300)
        samples = samples[loud[0] : loud[-1]]
        said = resampled(samples, spoken.rate, RATE, 0, len(samples) * RATE // spoken.rate)
        whole[round(at * RATE) : round(at * RATE) + len(said)] += said
        spans.append((at, at + len(said) / RATE))
    whole[round(3.8 * RATE) : round(3.8 * RATE) + 80] += 8000.0
    return np.clip(whole, -32768, 32767).astype(np.int16), spans


def turns(sound: Samples, block: int) -> list[Turn]:
    activity = Activity()
    return [turn for first in range(0, len(sound), block) for turn in activity.take(sound[first : first + block])]


def test_speech_begins_and_ends_where_it_does(room: tuple[Samples, list[tuple[float, float]]]) -> None:
    sound, spans = room
    found = turns(sound, 512)
    assert [turn.begins for turn in found] == [True, False, True, False]
    times = [turn.at / RATE for turn in found]
    assert times == pytest.approx([time for span in spans for time in span], abs=0.08)


@pytest.mark.parametrize("block", [100, 160, 5000])
def test_it_does_not_hang_on_the_blocks(room: tuple[Samples, list[tuple[float, float]]], block: int) -> None:
    assert turns(room[0], block) == turns(room[0], 512)


def test_noise_that_begins_is_only_for_a_while_taken_for_speech() -> None:
    dice = np.random.default_rng(2)
    sound = np.concatenate([30.0 * dice.standard_normal(RATE), 3000.0 * dice.standard_normal(14 * RATE)])
    found = turns(sound.astype(np.int16), 512)
    assert len(found) <= 2 and (not found or not found[-1].begins)


class Listener:
    """Keeps what it is given of each utterance: the part of the sound."""

    def __init__(self) -> None:
        self.heard: list[Samples] = []

    def begin(self) -> None:
        self.heard.append(np.zeros(0, np.int16))

    def take(self, sound: Samples) -> None:
        self.heard[-1] = np.concatenate([self.heard[-1], sound])

    def end(self) -> tuple[str, float] | None:
        return "no", 0.7


@pytest.mark.parametrize(("least", "count"), [(0.6, 2), (0.8, 0)])
def test_each_utterance_is_listened_to_whole(
    room: tuple[Samples, list[tuple[float, float]]], least: float, count: int
) -> None:
    sound, spans = room
    listener = Listener()
    ear = Ear(listener, least)
    found = [one for first in range(0, len(sound), 700) for one in ear.listen(sound[first : first + 700])]
    assert len(found) == count and ear.counts["heard"] == count and ear.counts["unsure"] == 2 - count
    for part, (start, end) in zip(listener.heard, spans, strict=True):
        at = int(np.flatnonzero((sliding_window_view(sound, 16) == part[:16]).all(axis=1))[0])
        assert at / RATE == pytest.approx(start - 0.2, abs=0.08)
        assert (at + len(part)) / RATE == pytest.approx(end + 0.1, abs=0.08)
        assert np.array_equal(sound[at : at + len(part)], part)


def test_what_is_passed_over_is_not_heard(room: tuple[Samples, list[tuple[float, float]]]) -> None:
    sound, _ = room
    listener, cut = Listener(), round(2.0 * RATE)
    ear = Ear(listener, 0.0)
    assert not list(ear.listen(sound[:cut]))
    ear.deaf(RATE)
    (heard,) = ear.listen(sound[cut + RATE :])
    assert heard.start == pytest.approx(4.3, abs=0.1) and ear.counts["deaf"] == 1


def test_the_face_is_heard_while_its_lines_sound() -> None:
    own, spoken = OwnVoice(), Spoken(b"", 22_050, 2.0, (), ())
    own.utter(Utterance(1, "ada", 1.0, spoken, 1.0, "Hello."))
    assert [own.sounds(time) for time in (0.9, 1.0, 2.9, 3.0 + AFTER)] == [False, True, True, False]
    own.utter(Utterance(1, "ada", 1.0, spoken, 1.0, "Hello.", cut=1.5))
    assert own.sounds(1.6) and not own.sounds(2.0)
    own.utter(Utterance(2, "ada", 5.0, spoken, 0.0, "Unheard."))
    assert not own.sounds(5.5)


@pytest.mark.parametrize("rate", [44_100, 48_000, 8_000])
def test_sound_of_any_rate_flows_as_if_it_were_whole(rate: int) -> None:
    sound = (8000.0 * np.random.default_rng(3).standard_normal(rate)).clip(-32768, 32767).astype(np.int16)
    flow = Flow(rate)
    made = np.concatenate([flow.take(sound[first : first + 1411]) for first in range(0, len(sound), 1411)])
    whole = np.clip(np.round(resampled(sound, rate, RATE, 0, len(made))), -32768, 32767)
    assert 0.98 * RATE < len(made) <= RATE
    assert np.array_equal(made[: len(made) - 100], whole[: len(made) - 100].astype(np.int16))
