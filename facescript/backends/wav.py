"""The soundtrack to a `.wav`: mono, 16 bit."""

from __future__ import annotations

import wave
from pathlib import Path

from facescript.backends.job import Job


def write_wav(job: Job, path: Path) -> None:
    """The sound from `start` to `end`, silence where nobody speaks."""
    heard = job.heard
    with wave.open(str(path), "wb") as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(heard.rate)
        out.setnframes(len(heard))
        for block in heard.blocks():
            out.writeframesraw(block.astype("<i2").tobytes())
