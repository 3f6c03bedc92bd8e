"""A film's file to how far its sound is from its picture, both decoded again."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

import imageio_ffmpeg
import numpy as np
from bars import Floats
from playing import Playing, Studio

from facescript.backends.film import write_mp4
from facescript.backends.job import Job

SIZE = 320, 240
RATE = 22050
"""Samples a second of the decoded sound."""

SPOKEN = """\
film {width}x{height}, {fps}fps, screen none
face ada = woman
    life still
view ada 220%
wait 700ms
say "Pa pa pa, | papa, | baba pa, | pa!"
wait 900ms
"""

WIDEST = 0.2
"""How far the picture or the sound may be off to be found, s."""

GRID = 0.001


def offset(studio: Studio, fps: int) -> float:
    """Sound after the mouth in the file, beside the same in the performance, ms; + is late."""
    playing = studio.play(SPOKEN.format(width=SIZE[0], height=SIZE[1], fps=fps))
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        path = Path(folder) / "film.mp4"
        job = Job(playing.play, playing.score, lambda _: b"", 0.0, playing.duration)
        write_mp4(job, path)
        return 1000.0 * (_sound_late(job, path) - _mouth_late(playing, path, fps))


def _sound_late(job: Job, path: Path) -> float:
    """By how much the decoded sound is behind the soundtrack, s."""
    options = ("-f", "f32le", "-ac", "1", "-ar", str(RATE), "-")
    found = np.frombuffer(_decoded(path, options), dtype="<f4").astype(np.float64)
    samples, rate = job.sound.samples(), job.sound.rate
    sent = np.interp(np.arange(len(found)) / RATE, np.arange(len(samples)) / rate, samples.astype(np.float64))
    size = 2 * len(found)
    echo = np.fft.irfft(np.fft.rfft(found, size) * np.conj(np.fft.rfft(sent, size)))
    shift = int(echo.argmax())
    return (shift if shift < len(found) else shift - size) / RATE


def _mouth_late(playing: Playing, path: Path, fps: int) -> float:
    """By how much the picture's mouth is behind the performance's, s: the shift at which the change of the frames from
    the first is most alike to the gap of the lips."""
    moved = _change(path)
    times = np.arange(len(moved)) / fps
    trace = playing.trace(0.0, playing.duration)
    opened = trace.channels["mouth.open"]
    shifts = np.arange(-WIDEST, WIDEST, GRID)
    alike = [np.corrcoef(moved, np.interp(times - late, trace.times, opened))[0, 1] for late in shifts]
    return float(shifts[int(np.argmax(alike))])


def _change(path: Path) -> Floats:
    """How much each frame differs from the first."""
    frames = np.frombuffer(_decoded(path, ("-f", "rawvideo", "-pix_fmt", "gray", "-")), dtype=np.uint8)
    grey = frames.reshape(-1, SIZE[1] * SIZE[0]).astype(np.float64)
    return np.abs(grey - grey[0]).sum(axis=1)


def _decoded(path: Path, options: tuple[str, ...]) -> bytes:
    words = [imageio_ffmpeg.get_ffmpeg_exe(), "-v", "error", "-i", str(path), *options]
    return subprocess.run(words, check=True, stdout=subprocess.PIPE).stdout
