"""Sound files of every kind to what is heard of them, and what an author is told of those that are not whole."""

from __future__ import annotations

import struct
import subprocess
import time
import tracemalloc
import wave
from dataclasses import replace
from pathlib import Path

import imageio_ffmpeg
import numpy as np
import pytest
from saying import line

from facescript.speech.model import VoiceFailure
from facescript.speech.sound.recording import read_recording
from facescript.speech.studio import open_studio
from facescript.world import World

RATE = 16_000
TONE = np.rint(8_000 * np.sin(2 * np.pi * 300 * np.arange(RATE) / RATE)).astype("<i2")


def wav(path: Path, samples: np.ndarray = TONE, rate: int = RATE, channels: int = 1) -> Path:
    with wave.open(str(path), "wb") as out:
        out.setparams((channels, 2, rate, 0, "NONE", ""))
        out.writeframes(samples.astype("<i2").tobytes())
    return path


def made(path: Path, *options: str) -> Path:
    """The tone as ffmpeg writes it."""
    source = wav(path.with_name("source.wav"))
    words = [imageio_ffmpeg.get_ffmpeg_exe(), "-v", "error", "-i", str(source), *options, str(path)]
    subprocess.run(words, check=True)
    return path


def cut(path: Path, share: float) -> Path:
    data = path.read_bytes()
    path.write_bytes(data[: round(share * len(data))])
    return path


def codes(path: Path) -> list[str]:
    return [doubt.code for doubt in read_recording(path).doubts]


def is_tone(samples: np.ndarray, tolerance: float = 0.02) -> bool:
    """Whether samples are the tone, as loud as it was."""
    expected = TONE.astype(np.float64)
    found = np.interp(np.arange(RATE) / RATE, np.arange(len(samples)) * (1.0 / len(samples)), samples)
    inner = slice(800, -800)
    return bool(np.sqrt(np.mean((found - expected)[inner] ** 2)) < tolerance * 8_000)


CODERS = ("pcm_u8", "pcm_s24le", "pcm_s32le", "pcm_f32le", "pcm_f64le", "pcm_mulaw", "pcm_alaw")


@pytest.mark.parametrize("coder", CODERS)
def test_wav_of_every_width(coder: str, tmp_path: Path) -> None:
    recording = read_recording(made(tmp_path / "take.wav", "-c:a", coder))
    assert (recording.rate, len(recording.samples), recording.doubts) == (RATE, RATE, ())
    assert is_tone(recording.samples)


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("take.flac", ()),
        ("take.ogg", ("-c:a", "libvorbis")),
        ("opus.ogg", ("-c:a", "libopus")),
        ("take.mp3", ("-b:a", "128k")),
        ("extensible.wav", ("-ac", "6", "-c:a", "pcm_s24le", "-af", "pan=5.1|FC=c0")),
        ("rf64.wav", ("-rf64", "always")),
        ("fast.wav", ("-ar", "96000")),
    ],
)
def test_other_files(name: str, options: tuple[str, ...], tmp_path: Path) -> None:
    recording = read_recording(made(tmp_path / name, *options))
    assert recording.rate <= 48_000
    assert recording.duration == pytest.approx(1.0, abs=0.06)
    assert recording.doubts == ()
    assert np.abs(recording.samples.astype(int)).max() == pytest.approx(8_000, rel=0.1)


@pytest.mark.parametrize(("left", "right"), [(1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (1.0, -1.0), (1.0, 0.01)], ids=str)
def test_two_channels_are_heard_whatever_they_hold(left: float, right: float, tmp_path: Path) -> None:
    both = np.rint(np.stack([left * TONE, right * TONE], axis=1))
    samples = read_recording(wav(tmp_path / "take.wav", both, channels=2)).samples
    assert len(samples) == RATE
    assert is_tone(samples)


def test_channels_that_differ_are_mixed(tmp_path: Path) -> None:
    noise = np.random.default_rng(3).normal(0.0, 5_000, RATE)
    mixed = read_recording(wav(tmp_path / "take.wav", np.rint(np.stack([TONE, noise], axis=1)), channels=2)).samples
    assert mixed == pytest.approx((TONE + noise) / 2, abs=2)


def test_chunks_around_the_sound_are_passed_by(tmp_path: Path) -> None:
    data = wav(tmp_path / "take.wav").read_bytes()
    odd = b"junk" + struct.pack("<I", 3) + b"abc\0"
    (tmp_path / "take.wav").write_bytes(data[:12] + odd + data[12:] + odd)
    recording = read_recording(tmp_path / "take.wav")
    assert np.array_equal(recording.samples, TONE)
    assert recording.pcm == TONE.tobytes()
    assert recording.doubts == ()


@pytest.mark.parametrize(("form", "share"), [("wav", 0.6), ("flac", 0.95), ("mp3", 0.6), ("ogg", 0.9)])
def test_what_is_there_of_a_file_that_breaks_off_is_heard(form: str, share: float, tmp_path: Path) -> None:
    path = made(tmp_path / f"take.{form}", *(("-page_duration", "100000") if form == "ogg" else ()))
    assert codes(path) == []
    assert codes(cut(path, share)) == ["FS526"]
    assert 0.3 < read_recording(path).duration < 1.0


def test_a_wav_whose_length_was_never_written_is_whole(tmp_path: Path) -> None:
    data = bytearray(wav(tmp_path / "take.wav").read_bytes())
    data[4:8] = data[40:44] = b"\xff\xff\xff\xff"
    (tmp_path / "take.wav").write_bytes(data)
    assert codes(tmp_path / "take.wav") == []


def test_sound_that_is_clipped(tmp_path: Path) -> None:
    loud = np.clip(TONE.astype(int) * 8, -32_768, 32_767)
    assert codes(wav(tmp_path / "clipped.wav", loud)) == ["FS527"]
    assert codes(wav(tmp_path / "loud.wav", np.rint(TONE * (32_700 / 8_000)))) == []


def test_silence_is_a_recording(tmp_path: Path) -> None:
    recording = read_recording(wav(tmp_path / "take.wav", np.zeros(RATE)))
    assert not recording.samples.any()
    assert recording.doubts == ()


def without_rate(data: bytes) -> bytes:
    return data[:24] + bytes(4) + data[28:]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "it is empty"),
        (b"Hello.\n", "it is no WAV, FLAC, OGG or MP3 file"),
        ("Hello, everyone.\n".encode("utf-16"), "no sound"),
        (b"RIFF\x24\0\0\0WAVEfmt ", "no sound"),
        (b"RIFF\x24\0\0\0AVI LIST", "it is AVI"),
        (b"\0\0\0\x20ftypisom\0\0\2\0isomiso2", "it is MP4 or M4A"),
        (b"OggS" + bytes(200), "no sound"),
        (b"\xff\xfb\x90\0" + bytes(40), "no sound"),
        (b"fLaC", "no sound"),
        (b"ID3", "no sound"),
    ],
    ids=lambda value: repr(value[:12]),
)
def test_what_is_no_sound(data: bytes, reason: str, tmp_path: Path) -> None:
    (tmp_path / "take.wav").write_bytes(data)
    with pytest.raises(VoiceFailure, match=reason) as failure:
        read_recording(tmp_path / "take.wav")
    assert failure.value.code == "FS504"


def test_a_rate_of_zero_and_a_film(tmp_path: Path) -> None:
    whole = wav(tmp_path / "take.wav").read_bytes()
    (tmp_path / "take.wav").write_bytes(without_rate(whole))
    with pytest.raises(VoiceFailure, match="0 samples a second"):
        read_recording(tmp_path / "take.wav")
    (tmp_path / "take.wav").write_bytes(whole[:44])
    with pytest.raises(VoiceFailure, match="no sound"):
        read_recording(tmp_path / "take.wav")
    with pytest.raises(VoiceFailure, match="No such file"):
        read_recording(tmp_path / "absent.wav")
    with pytest.raises(VoiceFailure):
        read_recording(tmp_path)


@pytest.mark.parametrize("name", ["-i.wav", "a b%d:c'\"\n.wav", "长城.wav", "http:", "concat:x|y"])
def test_any_name(name: str, tmp_path: Path) -> None:
    assert np.array_equal(read_recording(wav(tmp_path / name)).samples, TONE)


def test_ten_minutes_are_read_quickly_and_held_once(tmp_path: Path) -> None:
    """Held as long as they are, and read in much less than a hundredth of their length."""
    path = wav(tmp_path / "take.wav", np.tile(TONE, 600))
    tracemalloc.start()
    start = time.process_time()
    try:
        recording = read_recording(path)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert len(recording.samples) == 600 * RATE
    assert most < 1.5 * recording.samples.nbytes + (8 << 20)
    assert time.process_time() - start < 3.0


def test_a_line_of_a_recording_is_kept_with_what_was_found_in_it(tmp_path: Path) -> None:
    """Spoken twice, the second time from the cache: the same sound, phones and warnings."""
    buzz = np.tile(np.exp(-np.arange(160) / 12.0) * 20_000, 150)
    cut(wav(tmp_path / "take.wav", np.rint(np.concatenate([np.zeros(4_000), buzz, np.zeros(4_000)]))), 0.9)
    asked = replace(line("", "fi"), recording="take.wav")
    first, again = (open_studio(World(tmp_path)).speak(asked) for _ in range(2))
    assert any(phone.symbol and phone.stress for phone in first.phones)
    assert (again.pcm, again.phones, again.doubts) == (first.pcm, first.phones, first.doubts)
    assert [doubt.code for doubt in first.doubts] == ["FS526"]
