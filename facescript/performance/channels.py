"""The channels of a pose: names, units and rest values, in the order every output uses."""

from __future__ import annotations

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

CHANNELS: tuple[Channel, ...] = _channels()
NAMES: tuple[str, ...] = tuple(channel.name for channel in CHANNELS)
INDEX: dict[str, int] = {name: index for index, name in enumerate(NAMES)}
