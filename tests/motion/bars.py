"""Measures of human motion, taken from a trace as a reader of the .csv would take them, and the bars they must meet.

A trace is `times` (s, evenly spaced, 1000 Hz for saccades) and channels by name. Velocity is the derivative of
position by central differences. Onset and end of a movement, the same for eye and head: where its speed first and last
exceeds 5 % of its peak. Gaze has landed when it is first within 0.5 deg of the target. The bars are read from
`motion_bars.json`; each measure names the bar it is for.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

ONSET_SHARE = 0.05
LANDED_DEG = 0.5
APART_CM = 6.3

_BARS = {
    bar["id"]: bar["cases"] for bar in json.loads(Path(__file__).with_name("motion_bars.json").read_text())["bars"]
}


def bar(name: str, case: str) -> tuple[float, float]:
    """The low and high edge of a bar's case."""
    low, high = _BARS[name][case]
    return low, high


@dataclass(frozen=True)
class Trace:
    """Times and channels of one face, by their names."""

    times: Floats
    channels: Mapping[str, Floats]

    def eye(self, axis: str) -> Floats:
        """The mean of both eyes in the head."""
        return (self.channels[f"eye.left.{axis}"] + self.channels[f"eye.right.{axis}"]) / 2

    def head(self, axis: str) -> Floats:
        return self.channels[f"head.{axis}"]

    def gaze(self, axis: str) -> Floats:
        return self.channels[f"gaze.{axis}"]

    def part(self, start: float, end: float) -> Trace:
        """The trace from `start` to `end`."""
        inside = (self.times >= start) & (self.times <= end)
        return Trace(self.times[inside], {name: values[inside] for name, values in self.channels.items()})

    def speed(self, values: Floats) -> Floats:
        return np.gradient(values, self.times)


def read(path: Path) -> Trace:
    """The trace of a .csv of one face."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    channels = {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if "." in name}
    return Trace(np.array([float(row["time"]) for row in rows]), channels)


@dataclass(frozen=True)
class Movement:
    """A movement's onset and end (s), size (deg, with its sign), peak speed (deg/s), and when the peak is, 0..1."""

    onset: float
    end: float
    size: float
    peak: float
    peak_part: float

    @property
    def lasts_ms(self) -> float:
        return (self.end - self.onset) * 1000

    @property
    def peak_over_mean(self) -> float:
        return self.peak * (self.end - self.onset) / abs(self.size)


def movement(trace: Trace, values: Floats, share: float = ONSET_SHARE) -> Movement:
    """The one movement in the values of a trace (S1 to S6, H1, H2, H6), by the share of its peak speed at its ends."""
    speed = np.abs(trace.speed(values))
    moving = np.flatnonzero(speed > share * speed.max())
    onset, end = trace.times[moving[0]], trace.times[moving[-1]]
    peak_time = trace.times[speed.argmax()]
    size = values[moving[-1]] - values[moving[0]]
    return Movement(onset, end, size, float(speed.max()), float((peak_time - onset) / (end - onset)))


def head_lag_ms(trace: Trace, axis: str) -> float:
    """Head onset minus eye onset (H1)."""
    return (movement(trace, trace.head(axis)).onset - movement(trace, trace.gaze(axis)).onset) * 1000


def landing(trace: Trace, axis: str, target: float) -> int:
    """The index at which gaze is first within 0.5 deg of the target."""
    return int(np.flatnonzero(np.abs(trace.gaze(axis) - target) <= LANDED_DEG)[0])


def share_at_landing(trace: Trace, axis: str, target: float) -> float:
    """The head's part of the target's angle when gaze lands (H3)."""
    return float(trace.head(axis)[landing(trace, axis, target)] / target)


def final_share(trace: Trace, axis: str, target: float) -> float:
    """The head's part of the target's angle at the trace's end (H4)."""
    return float(trace.head(axis)[-1] / target)


def vor_phase(trace: Trace, axis: str, target: float) -> Trace:
    """From 20 ms after landing to the head's end."""
    start = trace.times[landing(trace, axis, target)] + 0.020
    return trace.part(start, movement(trace, trace.head(axis)).end)


def vor_error(trace: Trace, axis: str, target: float) -> tuple[float, float]:
    """Mean gaze error (deg) and rms retinal slip (deg/s) in the VOR phase (H7)."""
    phase = vor_phase(trace, axis, target)
    slip = phase.speed(phase.gaze(axis))
    return float(np.abs(phase.gaze(axis) - target).mean()), float(np.sqrt((slip**2).mean()))


def vor_gain(trace: Trace, axis: str, target: float) -> float:
    """The slope of eye velocity on head velocity in the VOR phase, with its sign turned (H8)."""
    phase = vor_phase(trace, axis, target)
    slope = np.polyfit(phase.speed(phase.head(axis)), phase.speed(phase.eye(axis)), 1)[0]
    return float(-slope)


def vergence(trace: Trace) -> Floats:
    """The angle between the eyes, + converging."""
    return trace.channels["eye.right.yaw"] - trace.channels["eye.left.yaw"]


def vergence_error(trace: Trace, distance_cm: float) -> float:
    """How far the settled vergence is from the geometry of a target straight ahead (V1)."""
    return float(abs(vergence(trace)[-1] - 2 * np.degrees(np.arctan(APART_CM / 2 / distance_cm))))


def vergence_share(trace: Trace, axis: str) -> float:
    """The part of the change of vergence done while the saccade lasts (V2)."""
    saccade = movement(trace, trace.gaze(axis))
    angle = vergence(trace)
    inside = np.interp([saccade.onset, saccade.end], trace.times, angle)
    return float((inside[1] - inside[0]) / (angle[-1] - angle[0]))


def eye_extremes(trace: Trace) -> dict[str, float]:
    """The furthest any eye turns in the head: sideways, up and down (S8)."""
    yaw = np.concatenate([trace.channels["eye.left.yaw"], trace.channels["eye.right.yaw"]])
    pitch = np.concatenate([trace.channels["eye.left.pitch"], trace.channels["eye.right.pitch"]])
    return {"yaw": float(np.abs(yaw).max()), "up": float(max(0.0, pitch.max())), "down": float(max(0.0, -pitch.min()))}


def spearman(one: list[float], other: list[float]) -> float:
    """Rank correlation (H6)."""
    ranks = [np.argsort(np.argsort(values)) for values in (one, other)]
    return float(np.corrcoef(*ranks)[0, 1])


def largest_step(values: Floats) -> float:
    """The largest change from one sample to the next."""
    return float(np.abs(np.diff(values)).max())


def across(yaw: Floats, pitch: Floats) -> Floats:
    """Yaw counted as far as the line of sight goes sideways: near straight up and down, much yaw is little of that."""
    steps = np.diff(yaw) * np.cos(np.radians((pitch[1:] + pitch[:-1]) / 2))
    return np.concatenate([[0.0], np.cumsum(steps)])
