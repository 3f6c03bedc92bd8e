"""Poses for the rig's tests: channels by name to array[channel]."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Life, Voice
from facescript.ir.play import Face
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST
from facescript.resolve.resolver import resolve
from facescript.syntax.parser import parse
from facescript.text import Source, Span
from facescript.world import World

Floats = NDArray[np.float64]

RANGES: dict[str, tuple[float, float]] = {
    "head.yaw": (-45, 45),
    "head.pitch": (-30, 30),
    "head.roll": (-30, 30),
    "head.x": (-6, 6),
    "head.y": (-6, 6),
    "head.scale": (0.5, 1.5),
    "eye.left.yaw": (-45, 45),
    "eye.right.yaw": (-45, 45),
    "eye.left.pitch": (-47, 28),
    "eye.right.pitch": (-47, 28),
    "mouth.open": (0, 1.4),
    "mouth.wide": (-0.2, 0.15),
    "mouth.upper": (-0.3, 0.3),
    "mouth.lower": (-0.2, 0.8),
}
"""The ranges channels move in, where the unit does not say it."""


def plain(kind: str, **looks: str) -> Face:
    """A face of a kind, in its usual looks but for those given."""
    here = Span(Source("here.face", ""), 0, 0)
    return Face("ada", kind, Voice(), Life("still"), here, looks=tuple(looks.items()))


def script_face(text: str) -> Face:
    """The first face of a script."""
    diagnostics = Diagnostics()
    play = resolve(parse(Source("here.face", text), diagnostics), World(Path()), diagnostics)
    assert play is not None, [item.message for item in diagnostics]
    return play.faces[0]


def span(name: str) -> tuple[float, float]:
    """Lowest and highest value of a channel."""
    if name in RANGES:
        return RANGES[name]
    if name.startswith("lid."):
        return -0.35, 1.0
    if name.startswith(("ear.", "hair.")):
        return (-1.0, 1.0) if name.startswith("ear.") else (-12.0, 12.0)
    if name.startswith("eye."):
        return {"roll": (-20.0, 20.0), "x": (-0.3, 0.3), "y": (-0.3, 0.3), "scale": (0.7, 1.4)}[name.rsplit(".")[-1]]
    return (0.5, 1.6) if name.startswith("pupil.") else (0.0, 1.0)


def pose(**values: float) -> Floats:
    """The rest pose but for `values`; `_` stands for `.`, and a name of a pair means both sides."""
    out = REST.copy()
    for key, value in values.items():
        name = key.replace("_", ".")
        for one in (name,) if name in INDEX else (f"{name}.left", f"{name}.right"):
            out[INDEX[one]] = value
    return out


def sweep(name: str, count: int, base: Floats = REST) -> Floats:
    """Poses that differ in one channel, which goes through its whole range: array[count, channel]."""
    frames = np.repeat(base[None], count, axis=0)
    frames[:, INDEX[name]] = np.linspace(*span(name), count)
    return frames


def some(count: int, seed: int = 0) -> Floats:
    """Poses drawn at random from all channels' ranges."""
    drawn = np.random.default_rng(seed).random((count, len(INDEX)))
    low, high = np.array([span(name) for name in INDEX]).T
    poses: Floats = low + drawn * (high - low)
    return poses


def mirrored(frames: Floats) -> Floats:
    """The poses as a mirror shows them: sides change places, sideways turns and shifts their signs."""
    out = frames.copy()
    for name, row in INDEX.items():
        other = name.replace("left", "right") if "left" in name else name.replace("right", "left")
        turned = name.endswith((".yaw", ".roll", ".x"))
        out[:, INDEX[other]] = -frames[:, row] if turned else frames[:, row]
    return out
