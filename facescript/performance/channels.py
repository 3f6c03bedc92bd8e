"""The channels of a pose: names, units and rest values, in the order every output uses."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

SIDES = ("left", "right")

MUSCLES = (
    "brow.inner",
    "brow.outer",
    "forehead",
    "brow.lower",
    "cheek.upper",
    "cheek.lower",
    "nose.upper",
    "lip.upper",
    "lip.corner",
    "lip.lower",
    "lip.stretch",
    "lip.press",
    "lip.pucker",
    "chin",
)
"""The 14 muscle pairs (`architecture`, "The 28 muscles"); each is `NAME.left` and `NAME.right`."""


@dataclass(frozen=True, slots=True)
class Channel:
    """One number of a pose: its unit ("deg", "cm", "1") and the value it has at rest."""

    name: str
    unit: str
    rest: float = 0.0


def _channels() -> tuple[Channel, ...]:
    head = [Channel(f"head.{axis}", "deg") for axis in ("yaw", "pitch", "roll")]
    head += [Channel("head.x", "cm"), Channel("head.y", "cm"), Channel("head.scale", "1", 1.0)]
    eyes = []
    for side in SIDES:
        eyes += [Channel(f"eye.{side}.{axis}", "deg") for axis in ("yaw", "pitch", "roll")]
        eyes += [Channel(f"eye.{side}.x", "cm"), Channel(f"eye.{side}.y", "cm")]
        eyes += [Channel(f"eye.{side}.scale", "1", 1.0)]
    lids = [Channel(f"lid.{side}", "1") for side in SIDES]
    pupils = [Channel(f"pupil.{side}", "1", 1.0) for side in SIDES]
    muscles = [Channel(f"{muscle}.{side}", "1") for muscle in MUSCLES for side in SIDES]
    mouth = [Channel(f"mouth.{name}", "1") for name in MOUTH]
    gaze = [Channel("gaze.yaw", "deg"), Channel("gaze.pitch", "deg")]
    return tuple(head + eyes + lids + pupils + muscles + mouth + gaze)


MOUTH = ("open", "wide", "round", "upper", "lower", "jaw", "teeth", "tongue")
"""What speech drives, as fractions of the face's own units (FAPU):

`open` the gap between the inner lips at the middle, in MNS0 (mouth to nose), 0 closed; `wide` how far each corner
moves out, in MW0 (mouth width), negative in; `round` 0..1 how round and pushed forward; `upper` how far the upper
lip's edge rises and `lower` how far the lower lip's edge sinks, in MNS0 (thesis 5.2: up and dn), negative towards
each other; `jaw` 0..1 how far the jaw drops; `teeth` 0..1 how much of them shows; `tongue` 0..1 how far its tip is up.
"""

COMMON: tuple[Channel, ...] = _channels()
"""The channels of every face."""

NAMES: tuple[str, ...] = tuple(channel.name for channel in COMMON)
"""Their names, in their order."""

PARTS = ("ear", "muzzle")
"""What the faces of some kinds move besides."""

OWN: tuple[Channel, ...] = tuple(Channel(f"{part}.{side}", "1") for part in PARTS for side in SIDES)
"""The channels that only faces with such parts have: `ear` -1 pressed down or back .. 0 at rest .. 1 up, `muzzle` 0..1
how far its pad swells and rises. A sum may drive them on every face; elsewhere nothing comes of it."""

CHANNELS: tuple[Channel, ...] = COMMON + OWN
"""All that an author may name."""

HAIR: tuple[Channel, ...] = tuple(
    Channel(f"hair.{lock}.{axis}", "deg") for lock in ("slow", "middle", "quick") for axis in "xy"
)
"""How far slow, middle and quick locks trail behind the head, + to the viewer's right and up, as if they were turned by
so much. They follow from the head, are drawn only, and no table shows them."""

POSE: tuple[Channel, ...] = CHANNELS + HAIR
"""The columns of a pose, whatever the face has of them."""

INDEX: dict[str, int] = {channel.name: index for index, channel in enumerate(POSE)}


def channels_of(parts: Collection[str]) -> tuple[str, ...]:
    """The names of the channels that a face with these parts has, in their order: what tables of it show."""
    return (*NAMES, *(channel.name for channel in OWN if channel.name.partition(".")[0] in parts))
