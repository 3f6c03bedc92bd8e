"""Aligning: words and phones of a recording are where they are said, and what is not said is told."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from labels import FOLDER, pairs, read
from saying import line, over, words_of

from facescript.compile import compile_source
from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.align.aligned import aligned
from facescript.speech.align.alignment import Alignment
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.model import Spoken
from facescript.speech.sound.recording import Recording, read_recording
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

BRIDGE = "The council has voted to close the old harbour bridge. Nobody seems to mind."
MUSEUM = "欢迎来到博物馆，每幅画都讲述一个故事。"

pytestmark = pytest.mark.usefixtures("synthesiser")


@cache
def said(text: str, language: str = "en-us", variant: str = "f4", rate: float = 0.9) -> Spoken:
    return process_voice().speak(Say(text, Voice(language, variant, rate, 1.1)))


def recording(spoken: Spoken, first: float = 0.0, last: float = 1e9) -> Recording:
    """The seconds `first` to `last` of a line."""
    samples = np.frombuffer(spoken.pcm, "<i2")[round(first * spoken.rate) : round(min(last, 1e4) * spoken.rate)]
    return Recording(samples, spoken.rate)


def heard(sound: Recording, text: str, language: str = "en-us") -> Alignment:
    return aligned(sound, line(text, language), process_voice())


def in_order(found: Alignment) -> bool:
    moments = [moment for word in found.words for moment in (word.start, word.end)]
    return moments == sorted(moments) and moments[0] >= 0 and moments[-1] <= found.duration + 0.01


def off(found: Alignment, spoken: Spoken, by: float = 0.0) -> float:
    """Mean seconds by which words begin elsewhere than they were said, `by` seconds later."""
    assert [word.first for word in found.words] == [word.first for word in spoken.words]
    pairs = zip(found.words, spoken.words, strict=True)
    return float(np.mean([abs(ours.start - by - theirs.start) for ours, theirs in pairs]))


@pytest.mark.parametrize(("text", "language"), [(BRIDGE, "en-us"), (MUSEUM, "cmn")])
def test_words_and_phones_are_where_they_are_said(text: str, language: str) -> None:
    spoken = said(text, language)
    found = heard(recording(spoken), text, language)
    assert off(found, spoken) < 0.008
    assert {phone.symbol for phone in found.phones} == {phone.symbol for phone in spoken.phones}
    assert in_order(found)
    assert not found.doubts
    assert np.mean(found.confidences) > 0.7


def test_sentences_are_found_between_long_silences_and_noise() -> None:
    spoken = said(BRIDGE)
    cut = next(word.start for word in spoken.words if word.text == "Nobody") - 0.1
    noise = np.random.default_rng(1).normal(0, 30, 5 * spoken.rate).astype(np.int16)
    sound = recording(spoken).samples
    split = round(cut * spoken.rate)
    late = Recording(np.concatenate([noise, sound[:split], noise, sound[split:], noise[:20_000]]), spoken.rate)
    found = heard(late, BRIDGE)
    expected = [word.start + (5 if word.start < cut else 10) for word in spoken.words]
    assert np.mean([abs(word.start - start) for word, start in zip(found.words, expected, strict=True)]) < 0.02
    assert found.phones[0].symbol == ""


def test_a_labelled_plosive_begins_before_its_burst() -> None:
    text = "Take a cup of tea, a pack of paper, and a pot of coffee."
    found = heard(recording(said(text)), text)
    stops = [
        (phone.start - label, phone.symbol)
        for phone, label, before in zip(found.phones[1:], found.labelled[1:], found.phones, strict=False)
        if phone.symbol in ("p", "t", "k") and before.symbol
    ]
    assert np.median([closure for closure, _ in stops]) > 0.02
    assert all(closure < 0.13 for closure, _ in stops)


def test_a_recording_of_another_text_is_told() -> None:
    other = "Six spoons of fresh snow peas, five thick slabs of blue cheese, and maybe a snack for her brother."
    found = heard(recording(said(BRIDGE)), other)
    assert [doubt.code for doubt in found.doubts] == ["FS510"]
    assert in_order(found)
    assert np.mean(found.confidences) < 0.5 < np.mean(heard(recording(said(BRIDGE)), BRIDGE).confidences)


def test_a_text_that_is_far_too_long_is_spread_over_the_speech() -> None:
    spoken = said(BRIDGE)
    found = heard(recording(spoken, 0.0, 1.0), BRIDGE)
    assert [doubt.code for doubt in found.doubts] == ["FS510"]
    assert len(found.words) == len(spoken.words)
    assert in_order(found)


def test_a_recording_that_breaks_off_is_told() -> None:
    spoken = said(BRIDGE)
    end = spoken.words[-4].start - 0.05
    found = heard(recording(spoken, 0.0, end), BRIDGE)
    assert [doubt.code for doubt in found.doubts] == ["FS511"]
    assert found.doubts[0].reason.startswith("the last ")
    assert in_order(found)
    early = [abs(ours.start - theirs.start) for ours, theirs in zip(found.words[:8], spoken.words, strict=False)]
    assert np.mean(early) < 0.02


@pytest.mark.parametrize("level", [0, 2])
def test_silence_is_told(level: int) -> None:
    samples = np.random.default_rng(1).integers(-level, level + 1, 16_000).astype(np.int16)
    found = heard(Recording(samples, 16_000), BRIDGE)
    assert found.doubts[0].code == "FS510"
    assert "nobody" in found.doubts[0].reason
    assert len(found.words) == 14


def test_clipped_sound_is_aligned() -> None:
    spoken = said(BRIDGE)
    loud = np.clip(recording(spoken).samples.astype(np.int32) * 8, -32_768, 32_767).astype(np.int16)
    assert off(heard(Recording(loud, spoken.rate), BRIDGE), spoken) < 0.02


@pytest.mark.parametrize("rate", [8000, 44_100])
def test_any_rate_is_aligned(rate: int) -> None:
    spoken = said(BRIDGE)
    sound = recording(spoken).samples
    places = np.arange(0, len(sound) - 1, spoken.rate / rate)
    other = np.interp(places, np.arange(len(sound)), sound).astype(np.int16)
    assert off(heard(Recording(other, rate), BRIDGE), spoken) < 0.02


def test_odd_signs_do_not_stop_it() -> None:
    text = "It costs 3.50 dollars 😀 at https://example.org/x?y=1, don’t\x07 you think?"
    spoken = said(text)
    found = heard(recording(spoken), text)
    assert words_of(spoken) == " ".join(word.text for word in found.words)
    assert in_order(found)


def test_a_reading_and_a_pause_are_kept() -> None:
    text = "We read the lead story."
    marks = (over(text, "lead", "reading", "/lɛd/"), Stretch("pause", 3, 3, "400"))
    found = aligned(recording(said(text)), line(text, "en-us", *marks), process_voice())
    assert "ɛ" in [phone.symbol for phone in found.phones]
    assert found.duration < 4


def test_an_alignment_is_the_same_each_time() -> None:
    assert heard(recording(said(BRIDGE)), BRIDGE) == heard(recording(said(BRIDGE)), BRIDGE)


def test_a_cue_of_a_recorded_line_is_at_the_real_word(tmp_path: Path, wav_of) -> None:  # type: ignore[no-untyped-def]
    spoken = said(BRIDGE)
    wav_of(spoken, tmp_path / "take.wav")
    script = f'face ada = woman\nsay "{BRIDGE}" from "take.wav"\n    on "bridge": nod\n'
    world = World(tmp_path)
    compiled = compile_source(Source("x.face", script), world, open_studio(world))
    assert compiled.score is not None
    assert not list(compiled.diagnostics)
    real = next(word.start for word in spoken.words if word.text == "bridge")
    assert any(abs(act.start - real) < 0.03 for act in compiled.score.acts if "nod" in repr(act).lower())


@pytest.mark.skipif(not FOLDER.exists(), reason="the labelled recordings are not here")
def test_phones_are_near_the_labels_of_a_recording() -> None:
    each = next(read(FOLDER))
    times = heard(read_recording(each.file), each.text).times()
    found = pairs([phone.symbol for phone in times.phones], [symbol for _, symbol in each.labels])
    errors = [abs(times.phones[i].start - each.labels[j][0]) for i, j in found]
    assert len(errors) >= 34
    assert np.median(errors) < 0.022
    assert np.percentile(errors, 90) < 0.06
