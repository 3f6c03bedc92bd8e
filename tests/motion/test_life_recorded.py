"""Life and mouth on what was recorded: at other rates, without stress, without phones, without words."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib.util import find_spec

import numpy as np
import pytest
from performing import HERE, channels, grid, performed

from facescript.ir.acts import Life, Say, Stretch, Voice
from facescript.motion.life.occasions import Occasions
from facescript.schedule.score import TimedLine
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.model import Spoken
from facescript.speech.sound.accents import heard, stretches
from facescript.speech.studio import Studio
from facescript.world import World

pytestmark = pytest.mark.skipif(find_spec("espeakng_loader") is None, reason="espeakng-loader is not installed")

TEXT = "The old bridge is closed, said the mayor. Nobody knows when it opens again, and nobody asks."
WAYS = ("as spoken", "aligned", "words alone", "nothing known")


@cache
def said() -> Spoken:
    return open_voice().speak(Say(TEXT, Voice("en-us")))


def recorded(way: str, rate: int = 44_100) -> Spoken:
    """The line as a recording at another rate; what is known of it is as much as each source can tell."""
    spoken = said()
    sound = np.frombuffer(spoken.pcm, "<i2")
    times = np.arange(round(len(sound) / spoken.rate * rate)) / rate
    pcm = np.interp(times, np.arange(len(sound)) / spoken.rate, sound).astype("<i2").tobytes()
    taken = replace(spoken, sound=pcm, rate=rate)
    if way == "aligned":
        return replace(taken, phones=tuple(replace(phone, stress=False) for phone in spoken.phones))
    if way == "words alone":
        return replace(taken, phones=())
    return replace(taken, phones=(), words=()) if way == "nothing known" else taken


@pytest.mark.parametrize("rate", [16_000, 44_100, 48_000])
def test_a_recording_is_heard_at_any_rate(rate: int) -> None:
    own, other = heard(said()), heard(recorded("as spoken", rate))
    assert len(own.accents) >= 5
    near = [min(abs(one.time - each.time) for each in other.accents) < 0.03 for one in own.accents]
    assert np.mean(near) >= 0.8


@pytest.mark.parametrize("way", WAYS)
def test_pauses_are_where_the_voice_pauses(way: str) -> None:
    """After `closed`, `mayor`, `again` and the end; a nod is before each of them and a lift begins with it."""
    ends = [word.end for word in said().words if word.text in ("closed", "mayor", "again", "asks")]
    line = TimedLine("ada", 2.0, recorded(way), 1.0, HERE)
    pauses = [pause.start - 2.0 for pause in Occasions((), (line,)).pauses(0.0, 20.0)]
    assert all(min(abs(end - pause) for pause in pauses) < 0.09 for end in ends)
    life = Life("announcer", (("nods", 1.0), ("sway", 0.0), ("brows", 0.0), ("blink", 0.0)))
    pitch = channels(performed(duration=10.0, life=life, lines=(line,)), grid(10.0, 100.0))["head.pitch"]
    nods = sum(
        pitch[round(100 * (2.0 + pause))] < -1.0 and abs(pitch[round(100 * (2.7 + pause))]) < 1.0 for pause in pauses
    )
    assert nods >= 2


@pytest.mark.parametrize("way", WAYS)
def test_brows_and_beats_come_on_accents(way: str) -> None:
    line = TimedLine("ada", 1.0, recorded(way), 1.0, HERE)
    accents = np.array([1.0 + one.time for one in heard(line.spoken).accents])
    assert len(accents) >= 5
    life = Life("conversation", (("brows", 30.0), ("nods", 1.0), ("sway", 1.0), ("blink", 0.0)))
    made = channels(performed(duration=8.0, life=life, lines=(line,)), grid(8.0, 200.0))
    raised = made["brow.inner.left"]
    tops = np.flatnonzero((raised[1:-1] > raised[:-2]) & (raised[1:-1] >= raised[2:]) & (raised[1:-1] > 0.05)) / 200.0
    talking = tops[(tops > 1.0) & (tops < 1.0 + line.spoken.duration)]
    assert len(talking) and all(np.abs(accents - top - 0.06).min() < 0.03 for top in talking)
    assert np.ptp(made["head.pitch"]) > 1.0


def test_silence_around_a_recording_is_no_speech() -> None:
    spoken = recorded("nothing known")
    quiet = bytes(2 * spoken.rate)
    padded = replace(spoken, sound=quiet + spoken.pcm + quiet, duration=spoken.duration + 2.0)
    first, last = stretches(padded)[0][0], stretches(padded)[-1][1]
    assert 1.0 <= first < 1.2 and spoken.duration + 0.8 < last <= spoken.duration + 1.05
    assert stretches(replace(spoken, sound=b"")) == ((0.0, spoken.duration),)


def test_a_word_that_the_text_stresses_is_an_accent_whoever_speaks_it(tmp_path) -> None:  # type: ignore[no-untyped-def]
    class Taken:
        """A voice that speaks as a recording does: no stress in text changes it."""

        def speak(self, line: Say) -> Spoken:
            return recorded("aligned")

    def strength(word: str) -> float:
        at = TEXT.index(word)
        line = Say(TEXT, Voice("en-us"), stretches=(Stretch("stress", at, at + len(word)),))
        spoken = Studio(World(tmp_path), Taken()).speak(line)
        span = next(each for each in spoken.words if each.text == word)
        return max((one.strength for one in heard(spoken).accents if span.start <= one.time < span.end), default=0.0)

    assert min(strength(word) for word in ("when", "it", "said")) > 0.5
