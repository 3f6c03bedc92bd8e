"""A performance of one face to `.fap`: a text file of MPEG-4's facial animation parameters, two lines a frame."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from facescript.backends.job import Job, JobFailure
from facescript.backends.one_face import chunks, face_of
from facescript.shapes import fap

VERSION = "2.1"
"""What files of this form name first."""


def write_fap(job: Job, path: Path) -> None:
    """A head line (version, name, frames a second, frames), then a mask of 68 and the frame's number with a whole
    number for each parameter that the mask has, in 1/1024 FAPU and 1e-5 rad. The mask has all that the face can say.

    Raises `JobFailure` where it is not clear whose face is meant, or the rate is no whole number.
    """
    if job.fps != round(job.fps):
        raise JobFailure(f"it counts whole frames a second, and {job.fps:g} are none: `--fps {max(round(job.fps), 1)}`")
    made = fap.made()
    mask = " ".join("1" if told else "0" for told in made.tolist())
    name = re.sub(r"[^A-Za-z0-9_-]", "_", face_of(job))
    with path.open("w", encoding="ascii", newline="") as out:
        out.write(f"{VERSION} {name}.fap {round(job.fps)} {len(job.times())}\n")
        number = 0
        for _, poses in chunks(job):
            for values in np.rint(fap.shapes(poses)[:, made]).astype(int).tolist():
                out.write(f"{mask}\n{number} {' '.join(map(str, values))}\n")
                number += 1
