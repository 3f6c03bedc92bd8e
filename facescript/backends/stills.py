"""A job to still pictures (.png): one moment, or every frame numbered."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import imageio.v3 as iio
import numpy as np

from facescript.backends.frames import drawing_faults, pictures
from facescript.backends.job import Job


def write_png(job: Job, path: Path) -> None:
    """The one moment asked for, or the first frame: RGB, the same bytes every time. Raises `JobFailure`."""
    write_pngs(job, [path])


def write_pngs(job: Job, paths: Sequence[Path]) -> None:
    """One file a frame, as many as there are paths. Raises `JobFailure`."""
    times = job.times()[: len(paths)]
    with drawing_faults():
        for number, (frame, path) in enumerate(zip(pictures(job.stage, times), paths, strict=True), start=1):
            iio.imwrite(path, np.ascontiguousarray(frame[..., 2::-1]), extension=".png")
            job.progress(number, len(paths))
