"""A soundtrack to an address that holds it: MP3 inside a `data:` URI."""

from __future__ import annotations

import base64
import tempfile
from pathlib import Path

from facescript.backends.encoder import Encoder
from facescript.speech.sound.mix import Soundtrack


def sound_address(sound: Soundtrack) -> str | None:
    """The `data:` URI of a sound, or None where it is silent throughout. Raises `JobFailure`."""
    if sound.silent:
        return None
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "sound.mp3"
        write_mp3(sound, path)
        return f"data:audio/mpeg;base64,{base64.b64encode(path.read_bytes()).decode('ascii')}"


def write_mp3(sound: Soundtrack, path: Path) -> None:
    """MP3 with the header that tells players the encoder's delay, so that sound starts at its first sample.

    Into a file and not a pipe: the encoder goes back to the beginning to write that header. Raises `JobFailure`.
    """
    source = ("-f", "s16le", "-ar", str(sound.rate), "-ac", "1", "-i", "pipe:0", "-c:a", "libmp3lame", "-b:a", "64k")
    with Encoder((*source, "-map_metadata", "-1", "-flags", "+bitexact", "-fflags", "+bitexact"), path) as encoder:
        for block in sound.blocks():
            encoder.write(block.astype("<i2"))
