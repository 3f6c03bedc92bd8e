"""A soundtrack to MP3, a block at a time: what every browser plays, from its first sample on."""

from __future__ import annotations

import tempfile
from pathlib import Path

from facescript.backends.encoder import Encoder
from facescript.speech.sound.mix import Soundtrack

OPTIONS = ("-c:a", "libmp3lame", "-b:a", "64k", "-map_metadata", "-1", "-flags", "+bitexact", "-fflags", "+bitexact")
"""A constant rate, so that a player finds any moment by reckoning; the file's head tells of the encoder's delay."""


def write_mp3(sound: Soundtrack, path: Path) -> None:
    """Mono, at 64 kbit a second. Into a file and not a pipe: the encoder goes back to write its head. Raises
    `JobFailure`."""
    source = ("-f", "s16le", "-ar", str(sound.rate), "-ac", "1", "-i", "pipe:0")
    with Encoder((*source, *OPTIONS, "-f", "mp3"), path) as encoder:
        for block in sound.blocks():
            encoder.write(block.astype("<i2"))


def mp3(sound: Soundtrack) -> bytes | None:
    """An MP3 file's bytes; None where the sound is silent throughout. Raises `JobFailure`."""
    if sound.silent:
        return None
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "sound.mp3"
        write_mp3(sound, path)
        return path.read_bytes()
