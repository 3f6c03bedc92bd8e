"""Sound to MP3, a stretch at a time: what every browser plays, from its first sample on."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from facescript.backends.encoder import Encoder

Samples = NDArray[np.int16]

OPTIONS = ("-c:a", "libmp3lame", "-b:a", "64k", "-map_metadata", "-1", "-flags", "+bitexact", "-fflags", "+bitexact")
"""A constant rate, so that a player finds any moment by reckoning; the file's head tells of the encoder's delay."""


def write_mp3(blocks: Iterable[Samples], rate: int, path: Path) -> None:
    """Mono samples to a file, at 64 kbit a second. Raises `JobFailure`."""
    options = ("-f", "s16le", "-ar", str(rate), "-ac", "1", "-i", "pipe:0", *OPTIONS, "-f", "mp3")
    with Encoder(options, path) as encoder:
        for block in blocks:
            encoder.write(np.ascontiguousarray(block, dtype="<i2").view(np.uint8))


def mp3(blocks: Iterable[Samples], rate: int) -> bytes:
    """Mono samples as an MP3 file's bytes. Raises `JobFailure`."""
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "sound.mp3"
        write_mp3(blocks, rate, path)
        return path.read_bytes()
