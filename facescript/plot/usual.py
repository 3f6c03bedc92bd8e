"""The panels of a plot for which no channels are asked."""

from __future__ import annotations

from collections.abc import Sequence

from facescript.performance.channels import MUSCLES, OWN, SIDES
from facescript.plot.channels import Curve, Panel
from facescript.plot.looks import BLACK, BLUE, GREEN, VERMILION

TURNS, ROLLS, STIRS = 1.0, 3.0, 0.01
"""How far something must move to have its place: pitch and roll, deg; muscles and mouth, a share of 1."""

DEGREES, SHARES = (-5.0, 5.0), (0.0, 1.0)
"""Ranges that are always shown, so that what is small looks small."""


def _gaze(axis: str) -> tuple[Curve, ...]:
    return (
        Curve("eyes in head", tuple(f"eye.{side}.{axis}" for side in SIDES), BLUE),
        Curve("head", (f"head.{axis}",), VERMILION),
        Curve("gaze", (f"gaze.{axis}",), BLACK, width=1.8),
    )


_LIDS = (
    Curve("lid.left", ("lid.left",), BLUE),
    Curve("lid.right", ("lid.right",), VERMILION, (5.0, 2.0)),
)

_MUSCLES = tuple(Curve(f"{muscle}.{side}", (f"{muscle}.{side}",)) for muscle in MUSCLES for side in SIDES)

_MOUTH = (
    Curve("open", ("mouth.open",), BLUE),
    Curve("wide", ("mouth.wide",), VERMILION),
    Curve("jaw", ("mouth.jaw",), GREEN),
)

USUAL: tuple[Panel, ...] = (
    Panel("yaw, deg", _gaze("yaw"), DEGREES, 1.3, target=0),
    Panel("pitch, deg", _gaze("pitch"), DEGREES, 1.0, TURNS, target=1),
    Panel("roll, deg", (Curve("head", ("head.roll",), VERMILION),), DEGREES, 0.6, ROLLS),
    Panel("lids", _LIDS, SHARES, 0.6),
    Panel("muscles", _MUSCLES, SHARES, 1.0, STIRS, each=True),
    Panel("mouth", _MOUTH, (0.0, 0.5), 0.9, STIRS, heard=True),
)
"""What is shown of every face that is seen."""

_OWN = tuple(Curve(channel.name, (channel.name,)) for channel in OWN)


def usual(channels: Sequence[str]) -> tuple[Panel, ...]:
    """What is shown of a face that is seen and has these channels."""
    own = tuple(curve for curve in _OWN if curve.label in channels)
    return (*USUAL, Panel("ears, muzzle", own, SHARES, 0.6, STIRS, each=True)) if own else USUAL


HEARD: tuple[Panel, ...] = (Panel("sound", (), SHARES, 0.5, heard=True),)
"""What is shown of a face that is only heard."""
