"""A sound file to mono samples at its own rate, and what an author should know of it."""

from __future__ import annotations

import subprocess
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from io import BytesIO
from pathlib import Path
from typing import IO

import imageio_ffmpeg
import numpy as np
from numpy.typing import NDArray

from facescript.speech.model import Doubt, VoiceFailure
from facescript.speech.sound.channels import Channels
from facescript.speech.sound.intact import breaks_off

Samples = NDArray[np.int16]

UNUSABLE = "FS504"
BROKEN, CLIPPED = "FS526", "FS527"
"""The diagnostics of a recording that is used all the same."""

FASTEST = 48_000
"""Samples a second that are kept; what has more is taken down to it."""

LONGEST = 4 * 3600.0
"""Seconds of a recording."""

LARGEST = 8 << 30
"""Bytes of a sound file."""

PATIENCE = 300.0
"""Seconds that reading may take."""

CHUNK = 1 << 20
"""Bytes that are read at once."""

PEAK, RUN, SHARE = 32_600, 3, 0.0005
"""A recording is clipped where at least this share of its samples stands in a run of so many this high."""

SIGNS = (
    (b"RIFF", b"WAVE", "wav"),
    (b"RF64", b"WAVE", "wav"),
    (b"fLaC", b"", "flac"),
    (b"OggS", b"", "ogg"),
    (b"ID3", b"", "mp3"),
)
"""What sound files begin with, and hold from their eighth byte on, and ffmpeg's name of their form: it is told, so that
it never guesses."""

OTHERS = (
    (0, b"\x1a\x45\xdf\xa3", "Matroska or WebM"),
    (4, b"ftyp", "MP4 or M4A"),
    (8, b"AVI ", "AVI"),
    (0, b"FORM", "AIFF"),
)
"""Place and sign of files that often hold sound and are not read."""


@dataclass(frozen=True, slots=True)
class Recording:
    """Sound as 16-bit samples at `rate` Hz; `doubts` are what the author should know of it."""

    samples: Samples
    rate: int
    doubts: tuple[Doubt, ...] = ()

    @property
    def duration(self) -> float:
        """Seconds."""
        return len(self.samples) / self.rate

    @property
    def pcm(self) -> bytes:
        """The samples as bytes, little-endian; those that were read are not copied."""
        base = self.samples.base
        whole = isinstance(base, bytes) and len(base) == self.samples.nbytes
        return base if isinstance(base, bytes) and whole else self.samples.astype("<i2").tobytes()


def read_recording(path: Path) -> Recording:
    """The sound of a WAV, FLAC, OGG or MP3 file, its channels mixed to one. Raises `VoiceFailure` (FS504)."""
    form = _form(path)
    recording = _decoded(path, form)
    if recording.duration > LONGEST:
        raise VoiceFailure(f"it is longer than {LONGEST / 3600:g} hours", UNUSABLE)
    return replace(recording, doubts=tuple(_doubts(recording, breaks_off(path, form, recording.duration))))


def _form(path: Path) -> str:
    """ffmpeg's name of the file's form, by what it begins with."""
    try:
        if path.stat().st_size > LARGEST:
            raise VoiceFailure(f"it is larger than {LARGEST >> 30} GiB", UNUSABLE)
        with path.open("rb") as file:
            head = file.read(28)
    except OSError as fault:
        raise VoiceFailure(fault.strerror or "it cannot be read", UNUSABLE) from None
    if not head:
        raise VoiceFailure("it is empty", UNUSABLE)
    if len(head) > 1 and head[0] == 0xFF and head[1] & 0xE0 == 0xE0 and head[1] & 6:
        return "mp3"
    for sign, inner, form in SIGNS:
        if head.startswith(sign) and head[8:].startswith(inner):
            if form == "wav" and head[12:16] == b"fmt " and head[24:28] == bytes(4):
                raise VoiceFailure("its head says that it has 0 samples a second", UNUSABLE)
            return form
    for place, sign, name in OTHERS:
        if head[place:].startswith(sign):
            raise VoiceFailure(f"it is {name}, and a recording is a WAV, FLAC, OGG or MP3 file", UNUSABLE)
    raise VoiceFailure("it is no WAV, FLAC, OGG or MP3 file", UNUSABLE)


def _decoded(path: Path, form: str) -> Recording:
    """The sound in one channel; a file of several is read twice, first for how its channels go together."""
    with _ffmpeg(path, form, ("-f", "wav")) as stream:
        rate, count = _head(stream)
        if count == 1 and rate <= FASTEST:
            return _heard(stream, rate)
        channels = Channels(count)
        for block in _blocks(stream, 2 * count):
            channels.add(np.frombuffer(block, dtype="<i2").reshape(-1, count))
    mixed = "|".join(["pan=mono", "c0=" + "+".join(f"{w:.6f}*c{n}" for n, w in enumerate(channels.weights()) if w)])
    kept = min(rate, FASTEST)
    with _ffmpeg(path, form, ("-af", mixed, "-ar", str(kept), "-f", "s16le")) as stream:
        return _heard(stream, kept)


@contextmanager
def _ffmpeg(path: Path, form: str, output: Sequence[str]) -> Iterator[IO[bytes]]:
    """What a running ffmpeg writes; ended with the block. Raises `VoiceFailure` where it cannot run or runs on."""
    words = [_program(), "-hide_banner", "-loglevel", "error", "-nostdin", "-protocol_whitelist", "file,pipe"]
    words += ["-f", form, "-i", f"file:{path}", "-map", "0:a:0", "-t", f"{LONGEST + 1:g}", "-c:a", "pcm_s16le"]
    words += [*output, "-"]
    quiet = subprocess.DEVNULL
    try:
        process = subprocess.Popen(words, stdin=quiet, stdout=subprocess.PIPE, stderr=quiet)
    except OSError as fault:
        raise VoiceFailure(f"ffmpeg cannot be run ({fault.strerror})", UNUSABLE) from None
    guard = threading.Timer(PATIENCE, process.kill)
    guard.start()
    try:
        assert process.stdout is not None
        yield process.stdout
    finally:
        late = guard.finished.is_set()
        guard.cancel()
        process.kill()
        process.communicate()
        if late:
            raise VoiceFailure("reading it takes too long", UNUSABLE)


def _head(stream: IO[bytes]) -> tuple[int, int]:
    """The rate and the number of channels in the WAV that ffmpeg writes, read up to its samples."""
    head = stream.read(36)
    rate, count = int.from_bytes(head[24:28], "little"), int.from_bytes(head[22:24], "little")
    behind = int.from_bytes(head[16:20], "little") - 16
    if len(head) < 36 or not rate or not count:
        raise VoiceFailure("there is no sound in it that can be read", UNUSABLE)
    stream.read(behind)
    while (chunk := stream.read(8)) and chunk[:4] != b"data":
        stream.read(int.from_bytes(chunk[4:], "little"))
    return rate, count


def _heard(stream: IO[bytes], rate: int) -> Recording:
    held = BytesIO()
    for block in _blocks(stream, 2):
        held.write(block)
    samples = np.frombuffer(held.getvalue(), dtype="<i2")
    if not len(samples):
        raise VoiceFailure("there is no sound in it", UNUSABLE)
    return Recording(samples, rate)


def _blocks(stream: IO[bytes], size: int) -> Iterator[bytes]:
    """What comes, in whole pieces of `size` bytes."""
    while block := stream.read(CHUNK // size * size):
        yield block[: len(block) // size * size]


def _doubts(recording: Recording, broken: bool) -> Iterator[Doubt]:
    if broken:
        yield Doubt(BROKEN, f"it ends after {recording.duration:.1f} s, before the end that its head tells of")
    clipped = 0
    for first in range(0, len(recording.samples), CHUNK):
        block = recording.samples[first : first + CHUNK]
        clipped += _standing((block >= PEAK) | (block <= -PEAK))
    if clipped > SHARE * len(recording.samples):
        yield Doubt(CLIPPED, f"{clipped / len(recording.samples):.1%} of it stands at full scale")


def _standing(peaks: NDArray[np.bool_]) -> int:
    """How many samples stand in runs of at least `RUN`."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], peaks, [False]])))
    runs = edges[1::2] - edges[::2]
    return int(runs[runs >= RUN].sum())


def _program() -> str:
    try:
        return str(imageio_ffmpeg.get_ffmpeg_exe())
    except RuntimeError:
        raise VoiceFailure("ffmpeg is not installed", UNUSABLE) from None
