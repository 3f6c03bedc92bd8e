"""Samples to an address that holds them: MP3 inside a `data:` URI."""

from __future__ import annotations

import base64
import subprocess
import tempfile
from pathlib import Path

import imageio_ffmpeg
import numpy as np

from facescript.backends.job import JobFailure, Sound

LIMIT = 600
"""Seconds the encoder may take."""


def sound_address(sound: Sound) -> str | None:
    """The `data:` URI of a sound, or None where it is silent throughout. Raises `JobFailure`."""
    samples, rate = sound
    if not np.any(samples):
        return None
    encoded = base64.b64encode(_mp3(samples.astype("<i2").tobytes(), rate)).decode("ascii")
    return f"data:audio/mpeg;base64,{encoded}"


def _mp3(pcm: bytes, rate: int) -> bytes:
    """MP3 with the header that tells players the encoder's delay, so that sound starts at its first sample.

    Into a file and not a pipe: the encoder goes back to the beginning to write that header.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sound.mp3"
        words = [imageio_ffmpeg.get_ffmpeg_exe(), "-hide_banner", "-loglevel", "error", "-f", "s16le"]
        words += ["-ar", str(rate), "-ac", "1", "-i", "pipe:0", "-c:a", "libmp3lame", "-b:a", "64k"]
        words += ["-map_metadata", "-1", "-flags", "+bitexact", "-fflags", "+bitexact", str(path)]
        try:
            done = subprocess.run(words, input=pcm, capture_output=True, timeout=LIMIT, check=False)
        except (OSError, subprocess.TimeoutExpired) as fault:
            raise JobFailure(f"the sound could not be encoded ({fault})") from None
        if done.returncode:
            raise JobFailure(f"the sound could not be encoded: {done.stderr.decode(errors='replace').strip()[-200:]}")
        return path.read_bytes()
