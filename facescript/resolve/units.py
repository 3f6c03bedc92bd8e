"""Units to base units: what each unit measures, and how kinds of quantities are called and written."""

from __future__ import annotations

from dataclasses import dataclass

TIME, ANGLE, LENGTH, SHARE, RATE, FRAMES, COUNT = "time", "angle", "length", "percentage", "rate", "frame rate", "count"


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit: what it measures, how it is called in a message, and base = value * times / over."""

    kind: str
    called: str
    times: float = 1.0
    over: float = 1.0


UNITS: dict[str, Unit] = {
    "ms": Unit(TIME, "milliseconds", over=1000.0),
    "s": Unit(TIME, "seconds"),
    "deg": Unit(ANGLE, "degrees"),
    "cm": Unit(LENGTH, "centimetres"),
    "m": Unit(LENGTH, "metres", times=100.0),
    "%": Unit(SHARE, "percent", over=100.0),
    "/min": Unit(RATE, "a rate a minute"),
    "fps": Unit(FRAMES, "frames a second"),
}

MENDS: dict[str, tuple[str, float]] = {
    "sec": ("s", 1.0),
    "min": ("s", 60.0),
    "h": ("s", 3600.0),
    "mm": ("cm", 0.1),
    "°": ("deg", 1.0),
    "rad": ("deg", 57.29577951),
    "hz": ("/min", 60.0),
    "Hz": ("/min", 60.0),
}
"""Units of elsewhere, and what they are in the language's own."""

EXAMPLES = {
    TIME: "2s",
    ANGLE: "20deg",
    LENGTH: "10cm",
    SHARE: "40%",
    RATE: "17/min",
    FRAMES: "30fps",
    COUNT: "3",
}

USUAL_UNIT = {TIME: "s", ANGLE: "deg", LENGTH: "cm", SHARE: "%", RATE: "/min", FRAMES: "fps", COUNT: ""}

LARGEST = {TIME: 86_400.0, ANGLE: 3_600.0, LENGTH: 1e7, SHARE: 100.0, RATE: 6_000.0, FRAMES: 1_000.0, COUNT: 1e9}
"""The largest magnitude of each kind in base units: a day, ten turns, 100 km, 10,000 %, and so on."""


def article(kind: str) -> str:
    """`a time`, `an angle`."""
    return f"an {kind}" if kind[0] in "aeiou" else f"a {kind}"


def written(kind: str, amount: float) -> str:
    """An amount in base units as an author writes it: `2s`, `40%`."""
    shown = amount * 100 if kind == SHARE else amount
    return f"{shown:.10g}{USUAL_UNIT[kind]}"
