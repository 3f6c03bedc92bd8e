"""A CSV of channels, as a build writes it, to a take: `time` (s), and channels by their names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from facescript.performance.channels import CHANNELS
from facescript.shapes.takes.model import Found, NotATake, counted, number, take

TIME = "time"

MOST = 1000.0
"""The greatest value of a channel."""

LATEST = 24 * 3600.0

DERIVED = ("gaze.yaw", "gaze.pitch")
"""Channels that follow from others, and are not read."""


def is_channels(header: Sequence[str]) -> bool:
    """Whether a head line is one of such a file."""
    return bool(header) and header[0].strip() == TIME


def read_channels(path: str, lines: Iterator[tuple[int, list[str]]], header: Sequence[str], face: str) -> Found:
    """The take of the rows under a header. Where columns bear faces' names (`ada.head.yaw`), those of `face`. Raises
    `NotATake`."""
    columns = _columns(header, face)
    times: list[float] = []
    rows: list[list[float]] = []
    for line, cells in lines:
        counted(len(rows), line)
        if len(cells) != len(header):
            raise NotATake(f"there are {len(cells)} cells under {len(header)} columns", line)
        time = number(cells[0].strip(), line, TIME, LATEST)
        if times and time <= times[-1]:
            raise NotATake("its time does not come after the one above it", line)
        times.append(time)
        rows.append([number(cells[at].strip(), line, name, MOST) for name, at in columns])
    return Found(take(path, "channels", tuple(name for name, _ in columns), times, rows))


def _columns(header: Sequence[str], face: str) -> list[tuple[str, int]]:
    known = {channel.name for channel in CHANNELS}.difference(DERIVED)
    names = [cell.strip() for cell in header]
    plain = [(name, at) for at, name in enumerate(names) if name in known]
    own = [(name.removeprefix(f"{face}."), at) for at, name in enumerate(names) if name.startswith(f"{face}.")]
    found = plain or [(name, at) for name, at in own if name in known]
    if not found:
        raise NotATake(f"no column of it is a channel, alone or with `{face}.` in front", 1)
    if len({name for name, _ in found}) < len(found):
        raise NotATake("it has a channel twice", 1)
    return found
