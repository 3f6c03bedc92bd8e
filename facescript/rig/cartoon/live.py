"""Poses -> what eyes and mouth draw afresh: channels by name handed to `eye.py` and `mouth.py`."""

from __future__ import annotations

import numpy as np

from facescript.performance.channels import INDEX, MUSCLES, SIDES
from facescript.performance.performance import Frames
from facescript.rig.cartoon.eyes import draw_eyes
from facescript.rig.cartoon.lips import MouthState, Side
from facescript.rig.cartoon.mouth import draw_mouth
from facescript.rig.cartoon.pen import Floats, Pen, soft_max, step
from facescript.rig.cartoon.style import FaceStyle

Columns = dict[str, Floats]
"""Channels, and what follows from them, by name: array[frame]."""

NEAR, FAR = (0.02, 0.36), (0.20, 0.70)
"""The sine of yaw from which, and to which, a side comes to show what it has towards the viewer, and away from it."""

FLOORS = {"mouth.jaw": (0.0, 1.5), "mouth.teeth": (0.0, 1.0), "mouth.tongue": (0.0, 1.0), "mouth.round": (0.0, 1.0)}


def columns(frames: Frames) -> Columns:
    """Channels of poses array[frame, channel] by name; muscles and the mouth's parts within their ranges."""
    rows = np.ascontiguousarray(np.asarray(frames, dtype=np.float64).T)
    named = {name: rows[row] for name, row in INDEX.items()}
    for muscle in MUSCLES:
        for side in SIDES:
            name = f"{muscle}.{side}"
            named[name] = np.clip(named[name], 0.0, 1.2)
    for name, (low, high) in FLOORS.items():
        named[name] = np.clip(named[name], low, high)
    named["chin"] = (named["chin.left"] + named["chin.right"]) / 2
    turned = np.sin(np.radians(named["head.yaw"]))
    for side, away in (("left", turned), ("right", -turned)):
        named[f"near.{side}"], named[f"far.{side}"] = step(*NEAR, -away), step(*FAR, away)
    return named


def signal(named: Columns, name: str) -> Floats:
    """A signal of a kind's rows by its name: a channel, what both sides have in the mean, the ear's way up or down; one
    that the face does not have stays 0."""
    if name in named:
        return named[name]
    base, _, way = name.partition(" ")
    if way:
        up, _, side = way.partition(".")
        whole = signal(named, f"{base}.{side}" if side else base)
        return np.maximum(whole if up == "up" else -whole, 0.0)
    if f"{name}.left" in named:
        return (named[f"{name}.left"] + named[f"{name}.right"]) / 2
    amount, _, one = name.rpartition(".")
    if one in SIDES and amount in named:
        return named[amount]
    return np.zeros_like(named["head.yaw"])


def draw_live(style: FaceStyle, named: Columns) -> Pen:
    """Eyes and mouth in the poses; adds the chin's way to the columns, `jaw-drop` in px and `jaw` as a part of 1."""
    pen = Pen()
    lips = draw_mouth(pen, style.mouth, _mouth(named))
    dropped = 0.55 * (lips.drop - 0.3)
    named["jaw-drop"] = np.asarray(soft_max(style.jaw.drop * named["mouth.jaw"], dropped, 4.0), dtype=np.float64)
    named["jaw"] = named["jaw-drop"] / style.jaw.drop
    draw_eyes(pen, style, named)
    return pen


def _mouth(named: Columns) -> MouthState:
    parts = {
        name: named[f"mouth.{name}"] for name in ("open", "wide", "round", "upper", "lower", "jaw", "teeth", "tongue")
    }
    return MouthState(chin=named["chin"], sides=(_side(named, "right"), _side(named, "left")), **parts)


def _side(named: Columns, side: str) -> Side:
    return Side(
        smile=named[f"cheek.lower.{side}"],
        frown=named[f"lip.corner.{side}"],
        raise_=named[f"lip.upper.{side}"],
        lower=named[f"lip.lower.{side}"],
        stretch=named[f"lip.stretch.{side}"],
        press=named[f"lip.press.{side}"],
        pucker=named[f"lip.pucker.{side}"],
        nose=named[f"nose.upper.{side}"],
        cheek=named[f"cheek.upper.{side}"],
    )
