"""Files of recordings: how long they are by their headers, and the command that aligns them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import imageio_ffmpeg
import pytest
from saying import line

from facescript.cli.main import main
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.sound.length import seconds_of
from facescript.speech.timing.files import read_times
from facescript.world import World

TEXT = "The bridge is closed. Nobody minds."


@pytest.fixture(scope="module")
def takes(tmp_path_factory: pytest.TempPathFactory, synthesiser: None, wav_of) -> Path:  # type: ignore[no-untyped-def]
    """A folder with one line in every form."""
    folder = tmp_path_factory.mktemp("takes")
    wav_of(process_voice().speak(line(TEXT, variant="f4")), folder / "take.wav")
    (folder / "take.txt").write_text(TEXT, "utf-8")
    words = [imageio_ffmpeg.get_ffmpeg_exe(), "-loglevel", "error", "-i", str(folder / "take.wav")]
    forms = ("take.flac", "take.ogg", "take.mp3", "stereo.wav")
    subprocess.run(
        [*words, *(str(folder / name) for name in forms[:3]), "-ac", "2", str(folder / forms[3])], check=True
    )
    subprocess.run([*words, "-c:a", "libopus", str(folder / "opus.ogg")], check=True)
    subprocess.run([*words, "-write_xing", "0", "-b:a", "64k", str(folder / "plain.mp3")], check=True)
    return folder


@pytest.mark.parametrize(
    "name", ["take.wav", "take.flac", "take.ogg", "take.mp3", "stereo.wav", "opus.ogg", "plain.mp3"]
)
def test_headers_tell_how_long_it_is(takes: Path, name: str) -> None:
    real = process_voice().speak(line(TEXT, variant="f4")).duration
    assert seconds_of(takes / name) == pytest.approx(real, abs=0.1 if name == "plain.mp3" else 0.03)


@pytest.mark.parametrize(
    "data", [b"", b"RIFF", b"fLaC\0", b"OggS" + bytes(40), b"ID3" + b"\x7f" * 9, b"\xff\xfb\x90", b"text"]
)
def test_broken_headers_tell_nothing(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "take").write_bytes(data)
    assert seconds_of(tmp_path / "take") is None
    assert seconds_of(tmp_path / "absent") is None


def test_an_estimate_is_as_long_as_the_recording(takes: Path) -> None:
    from dataclasses import replace

    asked = replace(line(TEXT), recording="take.ogg")
    found = EstimatedVoice(World(takes)).speak(asked)
    assert found.duration == pytest.approx(seconds_of(takes / "take.wav"), abs=0.01)
    assert [word.text for word in found.words][-1] == "minds"
    assert found.words[-1].end <= found.duration


def test_check_loads_nothing_heavy_for_a_recording(takes: Path) -> None:
    program = (
        "import sys; from pathlib import Path; from facescript.speech.estimate import EstimatedVoice;"
        "from facescript.ir.acts import *; from facescript.world import World;"
        f"EstimatedVoice(World(Path({str(takes)!r}))).speak(Say('Hi', Voice(), recording='take.mp3'));"
        "print(sorted({'numpy', 'espeakng_loader'} & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout == "[]\n"


def run(takes: Path, monkeypatch: pytest.MonkeyPatch, *words: str) -> int:
    monkeypatch.chdir(takes)
    return main(["align", *words])


def test_words_are_printed(takes: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(takes, monkeypatch, "take.mp3", "take.txt") == 0
    rows = [row.split() for row in capsys.readouterr().out.splitlines()]
    assert [row[-1] for row in rows] == ["The", "bridge", "is", "closed", "Nobody", "minds"]
    assert all(row[2].endswith("%") and float(row[0]) < float(row[1]) for row in rows)


@pytest.mark.parametrize("name", ["out.TextGrid", "out.json", "out.csv", "out.vtt"])
def test_what_is_written_can_be_read(takes: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    assert run(takes, monkeypatch, "take.flac", "take.txt", "-o", name) == 0
    times = read_times(name, (takes / name).read_bytes())
    assert [word.text.strip(".,") for word in times.words] == ["The", "bridge", "is", "closed", "Nobody", "minds"]


@pytest.mark.parametrize("pause", [("first",), ("1.1s", "1.5s")])
def test_a_pause_can_be_chosen(takes: Path, monkeypatch: pytest.MonkeyPatch, pause: tuple[str, ...]) -> None:
    assert run(takes, monkeypatch, "take.wav", "take.txt", "-o", "out.csv", "--pause", *pause) == 0


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("take.txt", "take.txt"), "FS950"),
        (("take.wav", "take.txt", "--language", "klingon"), "FS950"),
        (("take.wav", "absent.txt"), "FS901"),
        (("absent.wav", "take.txt"), "FS950"),
        (("take.wav", "take.txt", "-o", "out.doc"), "FS902"),
        (("take.wav", "take.txt", "--pause", "1s", "99s"), "FS951"),
        (("take.wav", "take.txt", "--pause", "1s"), "FS951"),
        (("take.wav", "take.wav"), "FS901"),
    ],
)
def test_faults_are_told(
    takes: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    words: tuple[str, ...],
    told: str,
) -> None:
    assert run(takes, monkeypatch, *words) != 0
    assert told in capsys.readouterr().err
