"""The second way to align English: what it is asked, and what is made of its answers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from saying import line

from facescript.cli.main import main
from facescript.ir.acts import Say, Voice
from facescript.speech.align import sphinx
from facescript.speech.align.aligned import aligned
from facescript.speech.align.piece import Heard
from facescript.speech.align.second import Part, better
from facescript.speech.align.sphinx import Utterance, names, starts
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.speech.sound.recording import Recording

TEXT = "The council has voted to close the old harbour bridge."


def part(likeness: float = 0.85) -> Part:
    """`hip` and `up` from 1 s on; the p bursts 50 ms after its closure begins."""
    words = (WordTime("hip", 0, 3, 1.0, 1.3), WordTime("up", 4, 6, 1.3, 1.5))
    phones = tuple(
        PhoneTime(symbol, start, end)
        for symbol, start, end in (
            ("h", 1.0, 1.1),
            ("ɪ", 1.1, 1.25),
            ("p", 1.25, 1.3),
            ("ʌ", 1.3, 1.45),
            ("p", 1.45, 1.5),
        )
    )
    heard = Heard(words, phones, 100, np.full(50, likeness, np.float32))
    return Part(heard, [1.0, 1.1, 1.2, 1.3, 1.4])


def test_sounds_have_their_names() -> None:
    assert [names(symbol) for symbol in ("ɑːɹ", "tʃ", "eɪ", "əl", "ɜː", "")] == [
        ["AA", "R"],
        ["CH"],
        ["EY"],
        ["AH", "L"],
        ["ER"],
        [],
    ]


def test_all_times_move_with_the_starts() -> None:
    found = better(part(), [1.02, 1.12, 1.22, None, 1.42])
    assert found.labelled == pytest.approx([1.02, 1.12, 1.22, 1.32, 1.42])
    assert [phone.start for phone in found.heard.phones] == pytest.approx([1.02, 1.12, 1.27, 1.32, 1.47])
    assert [word.start for word in found.heard.words] == pytest.approx([1.02, 1.32])
    assert not found.doubts


def test_no_answer_changes_nothing() -> None:
    one = part()
    assert better(one, None) is one
    assert better(one, [None] * 5) is one


@pytest.mark.parametrize(("likeness", "first"), [(0.85, 1.0), (1.0, 1.5)])
def test_where_they_differ_grossly_the_more_plausible_is_taken_and_told(likeness: float, first: float) -> None:
    found = better(part(likeness), [1.5, 1.6, 1.7, 1.8, 1.9])
    assert found.labelled[0] == pytest.approx(first)
    assert [doubt.code for doubt in found.doubts] == ["FS512"]
    assert "0.50 s" in found.doubts[0].reason


@pytest.mark.parametrize("program", ["import sys; sys.exit(3)", "print('null')", "import os; os.abort()"])
@pytest.mark.usefixtures("synthesiser")
def test_a_program_that_breaks_off_finds_no_way(program: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "program.py").write_text(program, "utf-8")
    monkeypatch.setattr(sphinx, "PROGRAM", tmp_path / "program.py")
    one = part()
    asked = [Utterance(np.zeros(8000, np.int16), 16_000, 1.0, one.heard.words, one.heard.phones)] * 2
    assert starts(asked) == [None, None]


@pytest.mark.usefixtures("synthesiser")
def test_it_agrees_with_the_voice() -> None:
    pytest.importorskip("pocketsphinx", reason="the extra `english` is not installed")
    spoken = process_voice().speak(Say(TEXT, Voice("en-us", "f4", 0.9)))
    recording = Recording(np.frombuffer(spoken.pcm, "<i2"), spoken.rate)
    twice = aligned(recording, line(TEXT), process_voice())
    once = aligned(recording, line(TEXT), process_voice(), by_voice_alone=True)
    assert twice != once
    apart = [abs(a.start - b.start) for a, b in zip(twice.words, once.words, strict=True)]
    assert np.median(apart) < 0.04


@pytest.mark.usefixtures("synthesiser")
def test_the_command_says_what_to_install(
    tmp_path: Path,
    wav_of: Callable[[Spoken, Path], None],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    wav_of(process_voice().speak(line(TEXT)), tmp_path / "take.wav")
    (tmp_path / "take.txt").write_text(TEXT, "utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("facescript.cli.align.installed", lambda: False)
    assert main(["align", "take.wav", "take.txt", "--by", "pocketsphinx"]) == 2
    assert "facescript[english]" in capsys.readouterr().err
    assert main(["align", "take.wav", "take.txt", "--by", "voice"]) == 0
