"""A voice of piper: its phonemes to phones, and piper itself, where it is installed, with a voice of tones."""

from __future__ import annotations

from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from saying import over, phones_of, words_of

from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.model import Spoken, VoiceFailure
from facescript.speech.piper.engine import PiperEngine
from facescript.speech.piper.phones import phones, symbols
from facescript.world import World

VOICES = Path(__file__).with_name("voices")
"""`tones.onnx` is made by `make_tones.py`: a tone a phoneme, of 70 ms, and as much behind it."""

TEXT = "Hello, it's 21 dogs. Papa cut [the] cake!"

needs_piper = pytest.mark.skipif(find_spec("piper") is None, reason="piper is not installed")


def test_marks_belong_to_their_letters_and_spaces_to_what_is_before() -> None:
    sounds = [
        (sign, 100) for sign in ("^", "d", "ˈ", "ɑ", "ː", "k", " ", "ˌ", "n̩"[0], "\u0329", ",", " ", "a", ".", "$")
    ]
    found = phones(sounds, 1000)
    assert [(phone.symbol, phone.stress) for phone in found] == [
        ("", False),
        ("d", False),
        ("ɑː", True),
        ("k", False),
        ("n̩", False),
        ("", False),
        ("a", False),
        ("", False),
        ("", False),
    ]
    assert (found[2].start, found[2].end) == pytest.approx((0.2, 0.5))
    assert all(one.end == two.start for one, two in pairwise(found))
    assert symbols(["d", "ˈ", "ɑ", "ː", "k", "."]) == ("d", "ɑː", "k")


def say(text: str, *marks: Stretch, language: str = "en-us", voice: str = "tones.onnx", **manner: float) -> Spoken:
    return PiperEngine(World(VOICES)).speak(Say(text, Voice(language, voice, engine="piper", **manner), marks))


@needs_piper
def test_words_and_phones_stand_where_they_are_heard() -> None:
    spoken = say(TEXT)
    assert words_of(spoken) == "Hello it's 21 dogs Papa cut the cake"
    first = {word.text: next(p.symbol for p in spoken.phones if p.start >= word.start - 1e-9) for word in spoken.words}
    assert [first[word] for word in ("Hello", "21", "dogs", "Papa", "cut", "the")] == ["h", "t", "d", "p", "k", "ð"]
    assert "s" in phones_of(spoken).split()
    assert spoken.duration == len(spoken.pcm) / 2 / spoken.rate
    assert all(one.end == pytest.approx(two.start) for one, two in pairwise(spoken.phones))
    (start, end) = next((p.start, p.end) for p in spoken.phones if p.symbol == "s")
    samples = np.frombuffer(spoken.pcm, "<i2")[round(start * spoken.rate) : round(end * spoken.rate)].astype(float)
    peak = float(np.abs(np.fft.rfft(samples[:1500])).argmax()) * spoken.rate / 1500
    assert peak == pytest.approx(310, abs=20)  # the tone of `s`: ten times its number among the phonemes


@needs_piper
def test_the_same_line_has_the_same_bytes_in_every_program() -> None:
    first = say(TEXT)
    say("Something else.")
    assert say(TEXT) == first


@needs_piper
def test_rate_pauses_and_readings_are_followed() -> None:
    assert say("All year.").duration / say("All year.", rate=2.0).duration == pytest.approx(2.0, rel=0.1)
    paused = say("We were away.", Stretch("pause", 7, 7, "0.7"))
    assert paused.words[2].start - paused.words[1].end > 0.7
    text = "I say xyzzy now"
    assert "h ə l ˈo ʊ" in phones_of(say(text, over(text, "xyzzy", "reading", "/həˈloʊ/")))
    assert [doubt.reason for doubt in say("Hi.", pitch=1.2).doubts] == ["`piper` has no `pitch` for it"]


@needs_piper
@pytest.mark.parametrize(
    ("voice", "language", "part"),
    [
        ("tones.onnx", "de", "speaks `en_US`, not `de`"),
        ("make_tones.py", "en-us", "there is no `make_tones.py.json`"),
        ("none.onnx", "en-us", "no file `none.onnx`"),
        ("broken.onnx", "en-us", "piper cannot read it"),
    ],
)
def test_a_voice_that_cannot_speak_is_told(voice: str, language: str, part: str, tmp_path: Path) -> None:
    for file in VOICES.iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes() if file.is_file() else b"")
    (tmp_path / "broken.onnx").write_text("no voice", "utf-8")
    (tmp_path / "broken.onnx.json").write_text("{}", "utf-8")
    with pytest.raises(VoiceFailure, match=part):
        PiperEngine(World(tmp_path)).speak(Say("Hi.", Voice(language, voice, engine="piper")))
