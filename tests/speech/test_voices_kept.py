"""Spoken lines are kept between programs: by what makes them, whole, and `check` has their times."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable
from dataclasses import fields, replace
from pathlib import Path

import pytest
from saying import line

from facescript.compile import compile_source
from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.espeak.engine import EspeakEngine
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import Doubt, PhoneTime, Spoken, WordTime
from facescript.speech.voices import store
from facescript.speech.voices.kept import KeptVoice
from facescript.speech.voices.known import KnownTimes
from facescript.text import Source
from facescript.world import World

SPOKEN = Spoken(
    b"\1\0" * 2205,
    22_050,
    0.1,
    (WordTime("Hi", 0, 2, 0.01, 0.1 / 3),),
    (PhoneTime("", 0.0, 0.01), PhoneTime("h", 0.01, 0.02, True)),
    doubts=(Doubt("FS509", "it is a test"),),
    marks=(("here", 0.05),),
)


class Counted:
    """An engine that counts what it is asked to speak."""

    def __init__(self, identity: str = "counted 1") -> None:
        self.asked: list[Say] = []
        self._identity = identity

    def speak(self, line: Say) -> Spoken:
        self.asked.append(line)
        return SPOKEN

    def identity(self, voice: Voice) -> str:
        return self._identity

    def voices(self) -> Iterable[tuple[str, str]]:
        return ()


@pytest.fixture(autouse=True)
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "facescript" / "spoken"


def test_the_next_program_does_not_speak_it_again() -> None:
    first, second = Counted(), Counted()
    KeptVoice(first).speak(line("Hi."))
    assert KeptVoice(second).speak(line("Hi.")) == SPOKEN
    assert (len(first.asked), len(second.asked)) == (1, 0)


def test_all_of_a_spoken_line_is_kept() -> None:
    kept = {"sound", "rate", "duration", "words", "phones", "doubts", "marks"}
    assert {field.name for field in fields(Spoken)} == kept | {"estimated"}, "keep the new field in store.py"
    store.save("0" * 40, SPOKEN)
    assert store.load("0" * 40) == SPOKEN


@pytest.mark.parametrize(
    "other",
    [
        Say("Hi!", Voice()),
        Say("Hi.", Voice("en-gb")),
        Say("Hi.", Voice(variant="female")),
        Say("Hi.", Voice(rate=1.1)),
        Say("Hi.", Voice(pitch=1.1)),
        Say("Hi.", Voice(range=1.1)),
        Say("Hi.", Voice(engine="other")),
        Say("Hi.", Voice(), (Stretch("stress", 0, 2),)),
    ],
)
def test_what_sounds_different_is_spoken(other: Say) -> None:
    engine = Counted()
    KeptVoice(engine).speak(line("Hi."))
    KeptVoice(engine).speak(other)
    assert len(engine.asked) == 2


def test_what_sounds_the_same_is_not() -> None:
    engine = Counted()
    voice = KeptVoice(engine)
    assert voice.speak(line("Hi.")) is voice.speak(Say("Hi.", Voice(volume=0.5)))
    KeptVoice(engine).speak(Say("Hi.", Voice(volume=0.5)))
    assert len(engine.asked) == 1


def test_another_engine_or_version_speaks_it_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    engines = [Counted("counted 1"), Counted("counted 2"), Counted("counted 1")]
    KeptVoice(engines[0]).speak(line("Hi."))
    KeptVoice(engines[1]).speak(line("Hi."))
    monkeypatch.setattr(store, "_sources", lambda: "another version of ours")
    KeptVoice(engines[2]).speak(line("Hi."))
    assert [len(engine.asked) for engine in engines] == [1, 1, 1]


def test_an_engine_that_does_not_know_itself_is_not_kept(empty: Path) -> None:
    KeptVoice(Counted("")).speak(line("Hi."))
    assert not empty.exists()


def test_a_damaged_line_is_spoken_again(empty: Path) -> None:
    KeptVoice(Counted()).speak(line("Hi."))
    (path,) = empty.iterdir()
    path.write_bytes(path.read_bytes()[:-1])
    engine = Counted()
    assert KeptVoice(engine).speak(line("Hi.")) == SPOKEN
    assert len(engine.asked) == 1


def test_check_has_the_times_of_a_line_that_was_spoken() -> None:
    said, new = line("Hi."), line("Never said.")
    store.save(store.key_of(said, EspeakEngine().identity(said.voice)), SPOKEN)
    voice = KnownTimes(World(Path.cwd()))
    assert voice.speak(said) == replace(SPOKEN, sound=b"")
    assert voice.speak(new) == EstimatedVoice().speak(new)


@pytest.mark.usefixtures("synthesiser")
def test_a_conflict_is_decided_by_check_once_it_is_spoken(tmp_path: Path) -> None:
    script = Source("s.face", 'say "Hello, everyone, and welcome."\nwait until 500ms\n')
    world = World(tmp_path)
    before = compile_source(script, world, KnownTimes(world)).diagnostics
    assert [(item.code, item.severity) for item in before] == [("FS407", "warning")]
    KeptVoice(EspeakEngine()).speak(line("Hello, everyone, and welcome."))
    after = compile_source(script, world, KnownTimes(world)).diagnostics
    assert [(item.code, item.severity) for item in after] == [("FS406", "error")]


def test_check_loads_nothing_heavy_for_it() -> None:
    program = (
        "import sys; from pathlib import Path; from facescript.speech.voices.known import KnownTimes\n"
        "from facescript.ir.acts import *; from facescript.world import World\n"
        "KnownTimes(World(Path.cwd())).speak(Say('长城', Voice('cmn')))\n"
        "heavy = {'numpy', 'pypinyin', 'espeakng_loader', 'subprocess', 'importlib.metadata'}\n"
        "print(sorted(heavy & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout == "[]\n"
