"""Channels to the 52 shapes of ARKit with the nine rotations of Live Link, and back."""

from __future__ import annotations

from functools import cache

import numpy as np

from facescript.performance.channels import POSE
from facescript.shapes.limits import limits
from facescript.shapes.measures import (
    AT,
    COLUMNS,
    lids_from_shut,
    measured,
    mouth_from_jaw,
    posed,
    teeth_shown,
    tongue_of,
)
from facescript.shapes.rows import rows
from facescript.shapes.solver import Floats, Solver, matrix

SQUINT, WIDE = 0.3, 0.35
"""How far a lid is shut by a whole squint, and opened by a whole widening."""

NARROWED = -0.2
"""How far the corners of wholly rounded lips are in, MW0: no shape says it."""

LOOK = 30.0
"""Degrees that an eye is turned by a whole look shape (by recordings: 30 to 31)."""

NAMES: tuple[str, ...] = tuple(row["name"] for row in rows("arkit"))
"""In the order of Live Link's packets: 52 shapes (0..1), then yaw, pitch and roll of head, left and right eye (rad)."""

APPLE: tuple[str, ...] = tuple(name[0].lower() + name[1:] for name in NAMES)
"""The same as Apple writes them."""

INDEX = {name: number for number, name in enumerate(NAMES)}

SHAPES = 52
"""How many of them are shapes; the others are rotations."""

UNREAD = ("lips.raised", "lips.parted", "forehead.left", "forehead.right")
"""What is not looked for in shapes: other columns say the same."""


def shapes(poses: Floats) -> Floats:
    """array[n, POSE] of one face to array[n, 61]."""
    factors, low, high = _factors()
    return np.clip(measured(poses) @ factors.T, low, high)


def poses(shapes: Floats) -> Floats:
    """array[n, 61] to array[n, POSE]: the channels that make these shapes, within their limits. Rest where no shape
    tells of a channel."""
    told = np.array(shapes, dtype=np.float64)
    _turn_eyes(told)
    for side in ("Left", "Right"):
        blink, squint, wide = (told[:, INDEX[f"Eye{name}{side}"]] for name in ("Blink", "Squint", "Wide"))
        told[:, INDEX[f"EyeBlink{side}"]] = 1.0 - (1.0 - blink) * (1.0 - SQUINT * squint) - WIDE * wide
    columns = _solver()(told)
    found = posed(columns)
    lids_from_shut(found, columns)
    mouth_from_jaw(found, columns)
    found[:, AT["mouth.tongue"]] = tongue_of(columns[:, AT["tongue.out"]])
    found[:, AT["mouth.wide"]] += NARROWED * found[:, AT["mouth.round"]]
    teeth_shown(found)
    return found


def _turn_eyes(told: Floats) -> None:
    """Where a file has no rotation of an eye, its look shapes tell of it."""
    for side, out in (("Left", 1.0), ("Right", -1.0)):
        turns = [INDEX[f"{side}Eye{axis}"] for axis in ("Yaw", "Pitch", "Roll")]
        look = {way: told[:, INDEX[f"EyeLook{way}{side}"]] for way in ("Up", "Down", "In", "Out")}
        still = ~np.any(told[:, turns] != 0.0, axis=1)
        yaw, pitch = out * (look["Out"] - look["In"]), look["Up"] - look["Down"]
        for column, turned in zip(turns, (-yaw, -pitch), strict=False):
            told[still, column] = np.radians(LOOK * turned[still])


@cache
def _factors() -> tuple[Floats, Floats, Floats]:
    table = rows("arkit")
    factors = matrix((row["made of"] for row in table), COLUMNS)
    return factors, np.array([float(row["low"]) for row in table]), np.array([float(row["high"]) for row in table])


@cache
def _told() -> Floats:
    """The factors that count on the way back."""
    told = matrix((row["made of"] if row["back"] == "yes" else "" for row in rows("arkit")), COLUMNS)
    told[:, [AT[name] for name in UNREAD]] = 0.0
    return told


@cache
def _solver() -> Solver:
    low, high = limits()
    high[AT["mouth.lower"]] = high[AT["mouth.upper"]] = low[AT["mouth.wide"]] = 0.0
    return Solver(_told(), low, high)


def channels(told: tuple[str, ...] = NAMES) -> tuple[str, ...]:
    """The channels that come back from the shapes `told`, in the order of a pose."""
    rows_ = [INDEX[name] for name in told]
    found = set(np.array(COLUMNS)[np.any(_told()[rows_] != 0.0, axis=0)])
    for name, (shape, others) in BY_MEASURE.items():
        found |= {name, *others} if shape in told else set()
    for side in ("Left", "Right"):
        if any(f"EyeLook{way}{side}" in told for way in ("Up", "Down", "In", "Out")):
            found |= {f"eye.{side.lower()}.{axis}" for axis in ("yaw", "pitch", "roll")}
    return tuple(channel.name for channel in POSE if channel.name in found)


BY_MEASURE = {
    "lid.left": ("EyeBlinkLeft", ()),
    "lid.right": ("EyeBlinkRight", ()),
    "mouth.open": ("JawOpen", ("mouth.upper", "mouth.lower", "mouth.teeth")),
    "mouth.wide": ("MouthFunnel", ()),
    "mouth.tongue": ("TongueOut", ()),
}
"""Channels that are told by measures: of which shape each, and what comes with it."""
