"""A sound file to mono samples at its own rate."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import imageio_ffmpeg
import numpy as np
from numpy.typing import NDArray

from facescript.speech.model import VoiceFailure

Samples = NDArray[np.int16]

UNUSABLE = "FS504"

FASTEST = 48_000
"""Samples a second that are kept; what has more is taken down to it."""

LONGEST = 4 * 3600.0
"""Seconds of a recording."""

LARGEST = 2 << 30
"""Bytes of a sound file."""

PATIENCE = 120.0
"""Seconds that reading may take."""

SIGNS = ((b"RIFF", "wav"), (b"RF64", "wav"), (b"fLaC", "flac"), (b"OggS", "ogg"), (b"ID3", "mp3"))
"""What sound files begin with, and ffmpeg's name of their form: it is told, so that it never guesses."""


@dataclass(frozen=True, slots=True)
class Recording:
    """Sound as 16-bit samples at `rate` Hz."""

    samples: Samples
    rate: int

    @property
    def duration(self) -> float:
        """Seconds."""
        return len(self.samples) / self.rate


def read_recording(path: Path) -> Recording:
    """The sound of a WAV, FLAC, OGG or MP3 file, its channels mixed to one. Raises `VoiceFailure` (FS504)."""
    words = [_program(), "-hide_banner", "-loglevel", "error", "-nostdin", "-protocol_whitelist", "file,pipe"]
    words += ["-f", _form(path), "-i", f"file:{path}", "-map", "0:a:0", "-t", f"{LONGEST + 1:g}", "-ac", "1"]
    words += ["-c:a", "pcm_s16le", "-f", "wav", "-"]
    try:
        done = subprocess.run(words, capture_output=True, stdin=subprocess.DEVNULL, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        raise VoiceFailure("reading it takes too long", UNUSABLE) from None
    except OSError as fault:
        raise VoiceFailure(f"ffmpeg cannot be run ({fault.strerror})", UNUSABLE) from None
    recording = _plain(done.stdout)
    if recording is None or not len(recording.samples):
        raise VoiceFailure("there is no sound in it", UNUSABLE)
    if recording.duration > LONGEST:
        raise VoiceFailure(f"it is longer than {LONGEST / 3600:g} hours", UNUSABLE)
    return recording


def _form(path: Path) -> str:
    """ffmpeg's name of the file's form, by what it begins with."""
    try:
        if path.stat().st_size > LARGEST:
            raise VoiceFailure(f"it is larger than {LARGEST >> 30} GiB", UNUSABLE)
        with path.open("rb") as file:
            head = file.read(12)
    except OSError as fault:
        raise VoiceFailure(fault.strerror or "it cannot be read", UNUSABLE) from None
    if not head:
        raise VoiceFailure("it is empty", UNUSABLE)
    if len(head) > 1 and head[0] == 0xFF and head[1] & 0xE0 == 0xE0:
        return "mp3"
    for sign, form in SIGNS:
        if head.startswith(sign):
            return form
    raise VoiceFailure("it is no WAV, FLAC, OGG or MP3 file", UNUSABLE)


def _program() -> str:
    try:
        return str(imageio_ffmpeg.get_ffmpeg_exe())
    except RuntimeError:
        raise VoiceFailure("ffmpeg is not installed", UNUSABLE) from None


def _plain(wav: bytes) -> Recording | None:
    """The sound of the WAV that ffmpeg writes to a pipe: its sizes are unknown there; None where it wrote none."""
    data = wav.find(b"data", 12)
    if len(wav) < 44 or data < 0:
        return None
    rate = int.from_bytes(wav[24:28], "little")
    samples = np.frombuffer(wav, dtype="<i2", offset=data + 8, count=(len(wav) - data - 8) // 2)
    return Recording(samples, rate) if rate else None
