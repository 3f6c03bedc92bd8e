"""Engines of speech behind one interface: how a script names them, what is told where they are not, sound at once."""

from __future__ import annotations

import importlib.metadata
import sys
import types
from pathlib import Path

import pytest
from saying import line
from test_voices_kept import SPOKEN, Counted

from facescript.cli.list import LISTS
from facescript.compile import compile_source
from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Say, Stretch, Voice
from facescript.ir.json_form import dump, load
from facescript.resolve.resolver import resolve
from facescript.speech.espeak.engine import EspeakEngine
from facescript.speech.espeak.voicebox import open_voice, process_voice
from facescript.speech.model import PhoneTime, VoiceFailure
from facescript.speech.sound.prosody import prosody
from facescript.speech.studio import open_studio
from facescript.speech.voices.kept import KeptVoice
from facescript.speech.voices.manner import with_bursts
from facescript.speech.voices.registry import GROUP, engines
from facescript.speech.voices.wording import begun_words
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World


def told(script: str, folder: Path) -> tuple[list[tuple[str, str]], Voice | None]:
    """What is said of a script before anybody speaks, and the voice of its first face."""
    diagnostics = Diagnostics()
    play = resolve(parse(Source("s.face", script), diagnostics), World(folder), diagnostics)
    voice = next(iter(play.faces)).voice if play is not None else None
    return [(item.code, item.message) for item in diagnostics if item.severity == "error"], voice


@pytest.mark.parametrize(
    ("written", "voice"),
    [
        ("en-us", Voice()),
        ("de female", Voice("de", "female")),
        ('en-us flite "slt"', Voice("en-us", "slt", engine="flite")),
        ('en-gb piper "voices/amy.onnx", rate 90%', Voice("en-gb", "voices/amy.onnx", 0.9, engine="piper")),
        ('fr festival "Jean Luc", range 150%', Voice("fr", "Jean Luc", range=1.5, engine="festival")),
    ],
)
def test_a_voice_names_its_engine(written: str, voice: Voice, tmp_path: Path) -> None:
    (tmp_path / "voices").mkdir()
    (tmp_path / "voices" / "amy.onnx").touch()
    assert told(f"face ada = woman, voice {written}\nada: nod\n", tmp_path) == ([], voice)


@pytest.mark.parametrize(
    ("written", "code", "part"),
    [
        ('piper "amy.onnx"', "FS326", "`piper` is no language"),
        ('en-us piper "amy.onnx"', "FS701", "there is no such file"),
        ('en-us piper "../amy.onnx"', "FS701", "amy.onnx"),
        ("en-us flite", "FS312", "as in `en-us flite "),
        ("en-us flite slt", "FS312", "an engine and its voice in quotes"),
        ('en-us flite ""', "FS312", "in quotes"),
        ('en-us flite "slt" female', "FS312", "in quotes"),
    ],
)
def test_a_voice_that_cannot_be_read_is_told(written: str, code: str, part: str, tmp_path: Path) -> None:
    ((found, message),) = told(f"face ada = woman, voice {written}\nada: nod\n", tmp_path)[0]
    assert (found, part in message) == (code, True), message


def test_the_json_form_has_it(tmp_path: Path) -> None:
    script = Source("s.face", 'face ada = woman, voice en-us flite "slt", range 80%\nada: nod\n')
    play = resolve(parse(script, Diagnostics()), World(tmp_path), Diagnostics())
    assert play is not None
    voice = next(iter(load(dump(play)).faces)).voice
    assert voice == Voice("en-us", "slt", range=0.8, engine="flite")


def test_an_unknown_engine_is_told(tmp_path: Path) -> None:
    with pytest.raises(VoiceFailure, match="`festival`; there are `espeak`, `flite`, `piper`") as failure:
        open_studio(World(tmp_path)).speak(Say("Hi.", Voice(engine="festival")))
    assert failure.value.code == "FS508"


@pytest.mark.parametrize(("engine", "hint"), [("flite", "apt install flite"), ("piper", "pip install")])
def test_an_engine_that_is_not_there_says_what_to_install(
    engine: str, hint: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("facescript.speech.piper.engine.find_spec", lambda name: None)
    with pytest.raises(VoiceFailure, match=hint) as failure:
        open_studio(World(tmp_path)).speak(Say("Hi.", Voice(variant="x", engine=engine)))
    assert failure.value.code == "FS507"
    assert any(name == engine and hint in meaning for name, meaning in LISTS["voices"]())


def test_a_plug_in_adds_an_engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    module = types.ModuleType("loud")
    module.open_loud = lambda world: Counted("loud 1")  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "loud", module)
    points = [importlib.metadata.EntryPoint(name, "loud:open_loud", GROUP) for name in ("loudly", "espeak")]
    monkeypatch.setattr(importlib.metadata, "entry_points", lambda group: points if group == GROUP else [])
    assert open_studio(World(tmp_path)).speak(Say("Hi.", Voice(variant="any", engine="loudly"))) == SPOKEN
    assert engines()["espeak"].target.startswith("facescript.")


# ------------------------------------------------------------------------------------------------ espeak-ng


@pytest.mark.usefixtures("synthesiser")
def test_range_is_how_far_the_melody_swings() -> None:
    swings = []
    for factor in (0.0, 1.0, 2.0):
        spoken = open_voice().speak(Say("Well, do you really believe that we were away?", Voice(range=factor)))
        found = prosody(spoken.pcm, spoken.rate)
        heard = found.f0[found.voiced]
        swings.append(float(heard.std()) / float(heard.mean()))
    assert swings[0] < 0.5 * swings[1] and swings[2] > 1.3 * swings[1]
    with pytest.raises(VoiceFailure, match="a range of 300% lies outside what it speaks, 0% to 200%"):
        open_voice().speak(Say("Hi.", Voice(range=3.0)))


LONG = "The council has voted to close the old harbour bridge, after thirty years of repairs. " * 12
SAID = (
    line("Hello there."),
    line(LONG, "en-us", Stretch("pause", 20, 20, "0.3"), Stretch("stress", 30, 35)),
    line("你好，我今天很高兴 hello world 再见。", "cmn", Stretch("pause", 3, 3, "0.5")),
    line("... Im Jahr 1998, z. B. mmm-mama!?", "de", variant="whisper"),
)


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize("said", SAID, ids=lambda said: str(said.voice.language))
def test_what_is_heard_meanwhile_is_the_line(said: Say) -> None:
    heard: list[bytes] = []
    spoken = process_voice().speak(said, heard.append)
    assert b"".join(heard) == spoken.pcm
    assert spoken == process_voice().speak(said)
    assert len(heard) >= 2 and len(heard[0]) < 22_050


@pytest.mark.usefixtures("synthesiser")
def test_a_kept_line_is_heard_at_once_and_whole() -> None:
    said = line("Heard twice, kept once.")
    first, second = KeptVoice(EspeakEngine()), KeptVoice(EspeakEngine())
    heard: list[bytes] = []
    spoken = first.speak_aloud(said, heard.append)
    assert len(heard) > 1 and b"".join(heard) == spoken.pcm
    for voice in (first, second):
        again: list[bytes] = []
        assert voice.speak_aloud(said, again.append) == spoken
        assert again == [spoken.pcm]


def test_an_engine_that_speaks_all_at_once_is_heard_too() -> None:
    heard: list[bytes] = []
    assert KeptVoice(Counted("")).speak_aloud(line("Hi."), heard.append) == SPOKEN
    assert heard == [SPOKEN.pcm]


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize(
    "text", ["😀 🎉 ½ see https://example.com/a?b=c&d 1,234.50", "\x00a\x07\x1b[31mb\u202e\ufeffc", "Zürich " * 285]
)
def test_odd_texts_are_spoken(text: str) -> None:
    spoken = process_voice().speak(line(text))
    assert spoken.words
    assert all(text[word.first : word.last] == word.text for word in spoken.words)


@pytest.mark.parametrize("text", ["😀🎉", "?!", "\u202e\ufeff", "\x07"])
def test_texts_without_anything_to_say_are_told(text: str, tmp_path: Path) -> None:
    with pytest.raises(VoiceFailure) as failure:
        open_studio(World(tmp_path)).speak(line(text))
    assert failure.value.code == "FS503"


# ------------------------------------------------------------------------------------------------ words and bursts


def test_words_are_found_by_what_they_sound_like_alone() -> None:
    heard = [PhoneTime(symbol, at / 10, (at + 1) / 10) for at, symbol in enumerate(["", *"ðəkatsat", "", *"ɒnðəmat"])]
    apart = [("ð", "iː"), ("k", "a", "t"), ("s", "a", "t"), ("ɒ", "n"), ("ð", "iː"), ("m", "a", "t")]
    assert begun_words(heard, apart) == [(0, 0.1), (1, 0.3), (2, 0.6), (3, 1.0), (4, 1.2), (5, 1.4)]
    assert begun_words(heard, [()] * 6) == [(0, 0.1)]
    assert begun_words([], apart) == [(0, 0.0)]


def test_a_plosive_begins_at_its_burst() -> None:
    phones = [PhoneTime("a", 0.0, 0.1), PhoneTime("p", 0.1, 0.2), PhoneTime("a", 0.2, 0.3)]
    found = list(with_bursts(phones))
    assert [(phone.symbol, round(phone.start, 3), round(phone.end, 3)) for phone in found] == [
        ("a", 0.0, 0.16),
        ("p", 0.16, 0.2),
        ("a", 0.2, 0.3),
    ]


def test_a_line_does_not_lose_its_warning_when_it_is_kept(tmp_path: Path) -> None:
    script = Source("s.face", 'say "Hi."\n')
    world = World(tmp_path)
    for _ in range(2):
        found = [item.code for item in compile_source(script, world, KeptVoice(Counted("warned"))).diagnostics]
        assert found == [doubt.code for doubt in SPOKEN.doubts]
