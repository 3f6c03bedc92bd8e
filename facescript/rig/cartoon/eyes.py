"""Channels of the usual two eyes -> the state of every eye that a face has, wherever it is, drawn by `eye.py`.

All eyes point at the one point that the two converge on: its direction changes along the face as the slopes do, evenly.
"""

from __future__ import annotations

import numpy as np

from facescript.performance.channels import SIDES
from facescript.rig.cartoon.eye import EyeState, draw_eye
from facescript.rig.cartoon.pen import Floats, Pen
from facescript.rig.cartoon.style import Eye, FaceStyle

Columns = dict[str, Floats]

FARTHEST = 1.4
"""Radians that an eye is turned at most, where the two others are turned apart."""


def draw_eyes(pen: Pen, style: FaceStyle, named: Columns) -> None:
    """Draw all eyes of a face in the poses of `named`."""
    for eye in style.eyes:
        side = -1 if eye.x < 0.0 else 1
        draw_eye(pen, eye.style, style.d, side, eye.name, _state(named, eye, style.d))
        pen.shift(f"-{eye.name}", eye.x - side * style.d / 2, eye.y)


def place(named: Columns, eye: Eye, d: float) -> tuple[Floats, Floats, Floats]:
    """How far an eye is moved to the right and up (cm), and its size, by the channels of the usual two."""
    x, y, size = (_between(named, eye, d, f"eye.{{}}.{what}") for what in ("x", "y", "scale"))
    return x, y, size


def _state(named: Columns, eye: Eye, d: float) -> EyeState:
    def mean(name: str) -> Floats:
        return _between(named, eye, d, name)

    yaw, pitch = _direction(named, eye, d)
    return EyeState(
        opening=1 - np.clip(mean("lid.{}"), -0.35, 1.0),
        yaw=yaw,
        pitch=pitch,
        roll=np.radians(mean("eye.{}.roll")),
        pupil=mean("pupil.{}"),
        cheek=mean("cheek.upper.{}") + 0.15 * mean("cheek.lower.{}"),
        nose=mean("nose.upper.{}"),
        frown=mean("brow.lower.{}"),
        raised=mean("brow.inner.{}") * 0.5 + mean("brow.outer.{}") * 0.5 + mean("forehead.{}"),
    )


def _share(eye: Eye, d: float) -> float:
    """Where an eye is across the face: 0 at the face's right one of the usual two, 1 at its left one."""
    return 0.5 + eye.x / d


def _between(named: Columns, eye: Eye, d: float, name: str) -> Floats:
    """A channel of both sides at an eye, by where it is; `{}` stands for the side."""
    left, right = (named[name.format(side)] for side in SIDES)
    share = min(1.0, max(0.0, _share(eye, d)))
    return left if share == 1.0 else right if share == 0.0 else right + share * (left - right)


def _direction(named: Columns, eye: Eye, d: float) -> tuple[Floats, Floats]:
    """Yaw and pitch (rad) at which an eye points at what the usual two converge on."""
    if eye.name in SIDES:
        yaw, pitch = (np.radians(named[f"eye.{eye.name}.{axis}"]) for axis in ("yaw", "pitch"))
        return yaw, pitch
    aside, up = zip(*(_slopes(named, side) for side in SIDES), strict=True)
    share, near = _share(eye, d), (aside[1] - aside[0]) / d
    x = aside[1] + share * (aside[0] - aside[1])
    y = (up[0] + up[1]) / 2 + eye.y * near
    yaw = np.clip(np.arctan(x), -FARTHEST, FARTHEST)
    return yaw, np.clip(np.arctan2(y, np.hypot(1.0, x)), -FARTHEST, FARTHEST)


def _slopes(named: Columns, side: str) -> tuple[Floats, Floats]:
    """How far aside and up an eye looks for each unit ahead."""
    yaw, pitch = (np.clip(np.radians(named[f"eye.{side}.{axis}"]), -FARTHEST, FARTHEST) for axis in ("yaw", "pitch"))
    return np.tan(yaw), np.tan(pitch) / np.cos(yaw)
