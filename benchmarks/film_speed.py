"""A minute of speech with life as a 1080p30 film, beside encoding alone: its frames, finished, into ffmpeg as it is."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from _measure import job_of, row
from _scripts import talk

from facescript.backends.encoder import Encoder
from facescript.backends.film import film_options, write_mp4
from facescript.backends.frames import planes
from facescript.backends.job import Job
from facescript.speech.espeak.voicebox import open_voice

RUNS = 3
"""Pairs; the middle one counts."""
BAR = 0.8
ALONE = "-c:v libx264 -preset veryfast -crf 20 -threads 2 -c:a aac -b:a 128k -f mp4".split()
"""What encoding alone is: what everyone uses."""


def main() -> None:
    job = job_of(talk(60), open_voice())
    assert not job.heard.silent
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as name:
        folder = Path(name)
        frames = kept(job, folder / "frames.yuv")
        shares = []
        for _ in range(RUNS):
            alone = timed(lambda: encode(job, frames, folder / "alone.mp4"))
            whole = timed(lambda: write_mp4(job, folder / "whole.mp4"))
            shares.append((alone / whole, whole, alone))
    share, whole, alone = sorted(shares)[RUNS // 2]
    rates = f"{len(frames) / whole:.0f} of {len(frames) / alone:.0f} frames/s"
    row("a minute's film beside encoding alone", f"{share:.2f} ({rates})", f"{BAR:g}", share >= BAR)


def kept(job: Job, path: Path) -> np.ndarray:
    """All frames as yuv420p in a file, array[frame, byte]."""
    with path.open("wb") as file:
        for frame in planes(job.stage, job.times()):
            file.write(frame)
    return np.memmap(path, np.uint8, "r").reshape(len(job.times()), -1)


def encode(job: Job, frames: np.ndarray, path: Path) -> None:
    """The frames through a plain encoder, sound and all."""
    with film_options(job, ALONE) as options, Encoder(options, path) as encoder:
        for frame in frames:
            encoder.write(frame)


def timed(work: Callable[[], None]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
