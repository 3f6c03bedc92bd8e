"""A job to the poses of the one face that an output is of, some thousand frames at a time."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job, JobFailure
from facescript.backends.tables import CHUNK
from facescript.performance.performance import Frames


def face_of(job: Job) -> str:
    """The face that is meant: the one that there is, or the one that `--face` names. Raises `JobFailure`."""
    faces = tuple(job.performance.faces)
    if job.face is not None and job.face not in faces:
        raise JobFailure(f"there is no face `{job.face}` to see{_known(faces)}")
    if job.face is None and len(faces) != 1:
        raise JobFailure(f"it holds one face, and `--face NAME` says which{_known(faces)}")
    return job.face or faces[0]


def _known(faces: tuple[str, ...]) -> str:
    return f": {', '.join(f'`{face}`' for face in faces)}" if faces else ": none is seen here"


def chunks(job: Job) -> Iterator[tuple[NDArray[np.float64], Frames]]:
    """Times (s) and poses, array[n, POSE], of all frames in their order. Raises `JobFailure`."""
    face, times = face_of(job), job.times()
    for first in range(0, len(times), CHUNK):
        chunk = times[first : first + CHUNK]
        yield chunk, job.performance.sample_face(face, chunk)
        job.progress(first + len(chunk), len(times))
