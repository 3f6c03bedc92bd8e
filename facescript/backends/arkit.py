"""A performance of one face to `.arkit.csv`: the columns of Live Link Face, one row a frame."""

from __future__ import annotations

from pathlib import Path

from facescript.backends.job import Job
from facescript.backends.one_face import chunks
from facescript.shapes import arkit

RATE = 60
"""Frames a second that the time codes count, whatever the rate of the rows: as Live Link Face counts them."""

SWAPPED = (("JawLeft", "JawRight"), ("MouthLeft", "MouthRight"))
"""Files have these the other way round than packets."""


def columns() -> list[str]:
    """The shapes in the order of Live Link Face's files."""
    names = list(arkit.NAMES)
    for first, second in SWAPPED:
        at = names.index(first)
        names[at : at + 2] = [second, first]
    return names


def write_arkit(job: Job, path: Path) -> None:
    """`Timecode`, `BlendshapeCount`, 52 shapes (0..1) and nine rotations (rad); six decimals, times from the film's
    start. Raises `JobFailure` where it is not clear whose face is meant."""
    names = columns()
    order = [arkit.INDEX[name] for name in names]
    with path.open("w", encoding="ascii", newline="") as out:
        out.write(",".join(["Timecode", "BlendshapeCount", *names]) + "\n")
        for times, poses in chunks(job):
            shown = arkit.shapes(poses)[:, order].round(6) + 0.0
            for time, values in zip(times.tolist(), shown.tolist(), strict=True):
                out.write(f"{timecode(time)},{len(names)},{','.join(f'{value:.6f}' for value in values)}\n")


def timecode(time: float) -> str:
    """A time (s) as hours, minutes, seconds and frames of 1/60 s, these with three decimals: `00:01:23:45.678`."""
    thousandths = round(time * RATE * 1000)
    seconds, frames = divmod(thousandths, RATE * 1000)
    minutes, second = divmod(seconds, 60)
    hour, minute = divmod(minutes, 60)
    return f"{hour:02}:{minute:02}:{second:02}:{frames // 1000:02}.{frames % 1000:03}"
