"""A soundtrack to a file of its own, a block at a time: Opus for pages, which are sought in, and MP3 for the rest."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from facescript.backends.encoder import Encoder
from facescript.speech.sound.mix import Soundtrack

EXACT = ("-map_metadata", "-1", "-flags", "+bitexact", "-fflags", "+bitexact")

MP3 = ("-c:a", "libmp3lame", "-b:a", "64k", *EXACT, "-f", "mp3")
"""The file's head tells of the encoder's delay, so that sound starts at its first sample. But after a seek Chromium is
off by up to a tenth of a second a few minutes into it: it reckons the place by the head's coarse table."""

OPUS = ("-c:a", "libopus", "-b:a", "48k", *EXACT, "-f", "webm")
"""Sought to the sample: its file says at which time each stretch of it is heard."""


def write_mp3(sound: Soundtrack, path: Path) -> None:
    """Mono, at 64 kbit a second. Raises `JobFailure`."""
    _write(sound, MP3, path)


def write_opus(sound: Soundtrack, path: Path) -> None:
    """WebM, mono, at 48 kbit a second. Raises `JobFailure`."""
    _write(sound, OPUS, path)


def mp3(sound: Soundtrack) -> bytes | None:
    """An MP3 file's bytes; None where the sound is silent throughout. Raises `JobFailure`."""
    return _encoded(sound, MP3)


def opus(sound: Soundtrack) -> bytes | None:
    """The bytes of a WebM file, mono, at 48 kbit a second; None where the sound is silent throughout. Raises
    `JobFailure`."""
    return _encoded(sound, OPUS)


def _encoded(sound: Soundtrack, kind: Sequence[str]) -> bytes | None:
    if sound.silent:
        return None
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "sound"
        _write(sound, kind, path)
        return path.read_bytes()


def _write(sound: Soundtrack, kind: Sequence[str], path: Path) -> None:
    """Into a file and not a pipe: the encoder goes back to write its head."""
    source = ("-f", "s16le", "-ar", str(sound.rate), "-ac", "1", "-i", "pipe:0")
    with Encoder((*source, *kind), path) as encoder:
        for block in sound.blocks():
            encoder.write(block.astype("<i2"))
