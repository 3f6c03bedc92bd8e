"""A pose to the tracking parameters of VTube Studio."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import INDEX, POSE

EYE = 1 / 30
"""An eye at the end of its way, 1, is turned by 30 degrees."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter that VTube Studio has by itself: its value at rest, what channels add to it, and its range."""

    name: str
    low: float
    high: float
    rest: float
    channels: dict[str, float] = field(default_factory=dict)


def _sided(stem: str, low: float, high: float, rest: float, channels: dict[str, float]) -> list[Parameter]:
    """A parameter of each side; `{}` in its name is Left or Right, in channels left or right."""
    return [
        Parameter(stem.format(side.title()), low, high, rest, {name.format(side): by for name, by in channels.items()})
        for side in ("left", "right")
    ]


def _both(channels: dict[str, float]) -> dict[str, float]:
    """The mean of both sides."""
    return {f"{name}.{side}": by / 2 for name, by in channels.items() for side in ("left", "right")}


BROW = {"brow.inner": 0.25, "brow.outer": 0.25, "forehead": 0.5, "brow.lower": -0.5}
SMILE = {"cheek.lower": 0.5, "lip.corner": -0.5}

PARAMETERS: tuple[Parameter, ...] = (
    Parameter("FacePositionX", -15, 15, 0, {"head.x": 1}),
    Parameter("FacePositionY", -15, 15, 0, {"head.y": 1}),
    Parameter("FaceAngleX", -30, 30, 0, {"head.yaw": 1}),
    Parameter("FaceAngleY", -30, 30, 0, {"head.pitch": 1}),
    Parameter("FaceAngleZ", -30, 30, 0, {"head.roll": 1}),
    Parameter("MouthOpen", 0, 1, 0, {"mouth.open": 1}),
    Parameter("MouthSmile", 0, 1, 0.5, _both(SMILE)),
    Parameter("Brows", 0, 1, 0.5, _both(BROW)),
    *_sided("Brow{}Y", 0, 1, 0.5, {f"{name}.{{}}": by for name, by in BROW.items()}),
    *_sided("EyeOpen{}", 0, 1, 1, {"lid.{}": -1}),
    *_sided("Eye{}X", -1, 1, 0, {"eye.{}.yaw": EYE}),
    *_sided("Eye{}Y", -1, 1, 0, {"eye.{}.pitch": EYE}),
    Parameter("FaceAngry", 0, 1, 0, _both({"brow.lower": 1})),
)

NAMES = tuple(parameter.name for parameter in PARAMETERS)

_LOW, _HIGH, _REST = (np.array([getattr(one, name) for one in PARAMETERS]) for name in ("low", "high", "rest"))


def _factors() -> NDArray[np.float64]:
    """array[parameter, channel]."""
    factors = np.zeros((len(PARAMETERS), len(POSE)))
    for row, parameter in enumerate(PARAMETERS):
        for name, by in parameter.channels.items():
            factors[row, INDEX[name]] = by
    return factors


_FACTORS = _factors()


def parameters(pose: NDArray[np.float64]) -> list[float]:
    """array[channel of POSE] to the values of `NAMES`, each within its range."""
    values: list[float] = np.clip(_REST + _FACTORS @ pose, _LOW, _HIGH).tolist()
    return values
