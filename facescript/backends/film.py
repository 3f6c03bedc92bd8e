"""A job to a film with sound (.mp4, .webm) or a looping picture (.gif); the same job gives the same bytes."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path

import numpy as np

from facescript.backends.encoder import Encoder
from facescript.backends.frames import Bytes, Floats, drawing_faults, even, film_planes, pictures
from facescript.backends.job import Job
from facescript.backends.wav import write_wav
from facescript.canvas.alpha import cut_out

EXACT = ("-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-flags:a", "+bitexact")
"""Nothing of the time or the machine in the file."""

COLOURS = ("-vf", "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709")
"""What the planes are (`canvas.video`)."""

NO_LOOKAHEAD = "rc-lookahead=0:sync-lookahead=0:b-adapt=0:mbtree=0:scenecut=0:weightp=0"
"""With a fixed quantiser and these, x264 makes no small copies of the frames to look ahead on."""

MP4 = (
    *("-c:v", "libx264", "-preset", "veryfast", "-qp", "24", "-threads", "2"),
    *("-x264-params", f"{NO_LOOKAHEAD}:aq-mode=0:ipratio=2:me=dia:subme=1:trellis=0:bframes=2:b-pyramid=0"),
    *("-c:a", "aac", "-b:a", "128k", "-movflags", "+faststart", "-f", "mp4"),
)
"""For flat pictures that mostly stand: one fineness for all, but key frames, on which what stands still feeds, finer.
About two thirds of the work of veryfast crf 20 (SSIM 0.9969 and 0.9975, 64 and 53 KB a second, twenty seconds of
speech at 1080p30). x264's output depends on the number of threads."""

KEY_SECONDS = 8.0
"""The most from one key frame to the next: how finely a player can seek."""

WEBM = (
    *("-c:v", "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "7", "-crf", "30", "-b:v", "0"),
    *("-row-mt", "1", "-threads", "4"),
    *("-c:a", "libopus", "-b:a", "96k", "-f", "webm"),
)

SWIFTEST_GIF = 50.0
"""Frames a second: a GIF counts time in hundredths of a second, and players slow down what is under two."""

PALETTE_FRAMES = 24
"""Frames from all over the film whose colours make its palette."""


def write_mp4(job: Job, path: Path) -> None:
    """H.264 and AAC. Raises `JobFailure`."""
    _write_film(job, path, MP4)


def write_webm(job: Job, path: Path) -> None:
    """VP9 and Opus; with opacity where the ground is ever transparent. Raises `JobFailure`."""
    _write_film(job, path, WEBM, job.stage.clear is not None)


@contextmanager
def film_options(job: Job, kind: Sequence[str], clear: bool = False) -> Iterator[tuple[str, ...]]:
    """ffmpeg's options for a film of the job (`kind` is MP4 or WEBM) whose planes come on its standard input."""
    pixels = "yuva420p" if clear else "yuv420p"
    picture = raw_input(pixels, even(job.stage.width), even(job.stage.height), job.fps)
    with _sound_file(job) as heard:
        yield (*picture, *heard, *COLOURS, *kind, *EXACT)


def write_gif(job: Job, path: Path) -> None:
    """A GIF that loops for ever, one palette of 256 colours for the whole film, one of them for what is clear where
    the ground is ever transparent. Raises `JobFailure`."""
    step = int(np.ceil(job.fps / SWIFTEST_GIF))
    times = job.times()[::step]
    clear = job.stage.clear is not None
    source = raw_input("bgra" if clear else "bgr0", job.stage.width, job.stage.height, job.fps / step)
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder, drawing_faults():
        palette = Path(folder) / "palette.png"
        some = times[np.unique(np.linspace(0, len(times) - 1, PALETTE_FRAMES).round().astype(int))]
        making = (*source, "-vf", "palettegen", "-update", "1", "-f", "image2")
        _encode(_gif_pictures(job, some, clear), making, palette)
        mapped = ("-i", str(palette), "-lavfi", "paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle")
        options = (*source, *mapped, *EXACT, "-loop", "0", "-f", "gif")
        _encode(_counted(job, _gif_pictures(job, times, clear), len(times)), options, path)


def _gif_pictures(job: Job, times: Floats, clear: bool) -> Iterator[Bytes]:
    """The pictures at `times`; with `clear` each pixel is opaque or clear, which is all that a GIF knows."""
    for frame in pictures(job.stage, times):
        yield cut_out(frame.view("<u4")[..., 0]).view(np.uint8).reshape(frame.shape) if clear else frame


def _write_film(job: Job, path: Path, kind: Sequence[str], clear: bool = False) -> None:
    times = job.times()
    planes = film_planes(job.stage, times, job.hands(), clear)
    kind = (*kind, "-g", str(max(1, round(KEY_SECONDS * job.fps))))
    with drawing_faults(), film_options(job, kind, clear) as options, planes as frames:
        _encode(_counted(job, frames, len(times)), options, path)


def raw_input(pixels: str, width: int, height: int, fps: float) -> tuple[str, ...]:
    """ffmpeg's options for frames on its standard input."""
    rate = Fraction(fps).limit_denominator(1001)
    return ("-f", "rawvideo", "-pix_fmt", pixels, "-s", f"{width}x{height}", "-r", str(rate), "-i", "-")


def _encode(frames: Iterator[Bytes], options: Sequence[str], path: Path) -> None:
    with Encoder(options, path) as encoder:
        for frame in frames:
            encoder.write(frame)


def _counted(job: Job, frames: Iterator[Bytes], total: int) -> Iterator[Bytes]:
    """The frames, with the job's progress told after each."""
    for number, frame in enumerate(frames, start=1):
        yield frame
        job.progress(number, total)


@contextmanager
def _sound_file(job: Job) -> Iterator[tuple[str, ...]]:
    """ffmpeg's options for the sound as an input, in a file for as long as the block lasts; none for silence."""
    if job.heard.silent:
        yield ()
        return
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "sound.wav"
        write_wav(job, path)
        yield "-i", str(path)
