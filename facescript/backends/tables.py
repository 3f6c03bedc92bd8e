"""A performance to tables of numbers: `.csv`, one row a moment, and `.jsonl`, one object a moment."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job

CHUNK = 2000
"""Rows sampled at once: memory does not grow with the film."""


def write_csv(job: Job, path: Path) -> None:
    """`time` in seconds, every channel by its name, and `marker`: the named statements that begin in that row.

    Six decimals; times from the film's start. Columns are `performance.names`.
    """
    with path.open("w", encoding="utf-8", newline="") as out:
        out.write(",".join(["time", *job.performance.names, "marker"]) + "\n")
        for time, values, names in _rows(job):
            out.write(f"{number(time)},{','.join(map(number, values))},{cell(' '.join(names))}\n")


def write_jsonl(job: Job, path: Path) -> None:
    """An object a line: `time`, every channel by its name, and `markers` where named statements begin."""
    keys = [json.dumps(name, ensure_ascii=False) for name in job.performance.names]
    with path.open("w", encoding="utf-8", newline="") as out:
        for time, values, names in _rows(job):
            fields = ", ".join(f"{key}: {number(value)}" for key, value in zip(keys, values, strict=True))
            marks = f', "markers": {json.dumps(names, ensure_ascii=False)}' if names else ""
            separator = ", " if fields else ""
            out.write(f'{{"time": {number(time)}{separator}{fields}{marks}}}\n')


def _rows(job: Job) -> Iterator[tuple[float, list[float], list[str]]]:
    times = job.times()
    marks = _marks(job, times)
    for first in range(0, len(times), CHUNK):
        chunk = times[first : first + CHUNK]
        values = job.performance.sample(chunk)
        for offset, time in enumerate(chunk.tolist()):
            yield time, values[offset].tolist(), marks.get(first + offset, [])
        job.progress(first + len(chunk), len(times))


def _marks(job: Job, times: NDArray[np.float64]) -> dict[int, list[str]]:
    """Marker names by the row in whose time they fall (the last row at or before them)."""
    found: dict[int, list[str]] = {}
    step = 1 / job.fps
    for marker in job.score.markers:
        row = int(np.searchsorted(times, marker.time + 1e-9, side="right")) - 1
        if row >= 0 and marker.time < times[row] + step:
            found.setdefault(row, []).append(marker.name)
    return found


def number(value: float) -> str:
    """Six decimals at most."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def cell(text: str) -> str:
    """A text as it stands between commas."""
    return '"' + text.replace('"', '""') + '"' if any(sign in text for sign in ',"\n') else text
