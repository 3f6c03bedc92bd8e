"""A job to still pictures (.png): one moment, or every frame numbered."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import imageio.v3 as iio
import numpy as np

from facescript.backends.frames import Bytes, Floats, drawing_faults, pictures
from facescript.backends.job import Job
from facescript.canvas.alpha import straight
from facescript.stage.stage import Stage


def write_png(job: Job, path: Path) -> None:
    """The one moment asked for, or the first frame, the same bytes every time: RGB, or RGBA in a film whose ground
    is ever transparent. Raises `JobFailure`."""
    write_pngs(job, [path])


def write_pngs(job: Job, paths: Sequence[Path]) -> None:
    """One file a frame, as many as there are paths. Raises `JobFailure`."""
    for number, _ in enumerate(written(job.stage, job.times()[: len(paths)], paths), start=1):
        job.progress(number, len(paths))


def written(stage: Stage, times: Floats, paths: Sequence[Path]) -> Iterator[Path]:
    """One file a moment (seconds, sorted), each handed on when it is there. Raises `JobFailure`."""
    with drawing_faults():
        for frame, path in zip(pictures(stage, times), paths, strict=True):
            iio.imwrite(path, _rgba(frame) if stage.clear else _rgb(frame), extension=".png")
            yield path


def _rgb(frame: Bytes) -> Bytes:
    return np.ascontiguousarray(frame[..., 2::-1])


def _rgba(frame: Bytes) -> Bytes:
    """Straight, as PNG has it."""
    pixels = straight(frame.view("<u4")[..., 0])
    bgra = pixels.view(np.uint8).reshape(frame.shape)
    return np.ascontiguousarray(bgra[..., [2, 1, 0, 3]])
