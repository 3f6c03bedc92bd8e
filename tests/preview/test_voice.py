"""Speech without a wait: lines that would take long are estimated first, then spoken one by one."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from facescript.ir.acts import Say, Voice
from facescript.preview import voice as patience
from facescript.preview.voice import PatientVoice
from facescript.speech.model import Spoken, VoiceFailure
from facescript.world import World


class Slow:
    """A voice that takes its time."""

    def __init__(self) -> None:
        self.said: list[str] = []

    def speak(self, line: Say) -> Spoken:
        self.said.append(line.text)
        if line.text == "no":
            raise VoiceFailure("it will not")
        time.sleep(0.02)
        return Spoken(b"", 8000, 1.0, (), ())


def line(text: str) -> Say:
    return Say(text, Voice())


@pytest.fixture
def slow(monkeypatch: pytest.MonkeyPatch) -> Slow:
    monkeypatch.setattr(patience, "AT_ONCE", 0.01)
    return Slow()


def test_lines_wait_and_are_spoken_once(slow: Slow, tmp_path: Path) -> None:
    voice = PatientVoice(World(tmp_path), slow)
    voice.begin()
    assert [voice.answers.speak(line(text)).estimated for text in ("one", "two", "three")] == [False, True, True]
    while voice.waiting:
        voice.catch_up()
    voice.begin()
    assert not any(voice.answers.speak(line(text)).estimated for text in ("one", "two", "three"))
    assert slow.said == ["one", "two", "three"]


def test_a_line_that_cannot_be_spoken_is_said_to_be_so_each_time(slow: Slow, tmp_path: Path) -> None:
    voice = PatientVoice(World(tmp_path), slow)
    for _ in range(2):
        voice.begin()
        with pytest.raises(VoiceFailure):
            voice.answers.speak(line("no"))
    assert slow.said == ["no"]


def test_a_line_that_is_gone_is_not_waited_for(slow: Slow, tmp_path: Path) -> None:
    voice = PatientVoice(World(tmp_path), slow)
    voice.begin()
    voice.answers.speak(line("one")), voice.answers.speak(line("two"))
    voice.begin()
    assert not voice.waiting


def test_whoever_keeps_what_was_answered_is_told_when_it_may_be_another(slow: Slow, tmp_path: Path) -> None:
    voice = PatientVoice(World(tmp_path), slow)
    voice.begin()
    first = voice.answers
    voice.answers.speak(line("one"))
    voice.begin()
    assert voice.answers is first
    voice.answers.speak(line("two")), voice.answers.speak(line("three"))
    voice.catch_up()
    voice.begin()
    assert voice.answers is not first
