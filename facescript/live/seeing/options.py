"""What stands behind `?` in the address of a camera to how the camera stands: `camera:0?fov=90&tilt=-30&y=60cm`."""

from __future__ import annotations

import re
from dataclasses import dataclass
from urllib.parse import parse_qsl

from facescript.ir.values import Point
from facescript.live.seeing.geometry import Camera

OPTIONS = ("fov", "tilt", "x", "y", "z", "distance", "mirrored", "size", "delay", "by")
SIZE = (640, 480)
SMALLEST, LARGEST = 120, 1920
"""Pixels of a picture's sides."""

DELAY = 0.05
"""How old a picture is when a camera gives it, s: half an exposure and a frame's transport at 30 a second."""

BY = ("cascade", "mediapipe")


@dataclass(frozen=True, slots=True)
class Options:
    """How a camera stands, what size of pictures it is asked for, how old they are (s) and which finder is wanted
    (None: MediaPipe where it is installed)."""

    camera: Camera
    size: tuple[int, int] = SIZE
    delay: float = DELAY
    by: str | None = None


def options(query: str, top: float) -> Options:
    """The options of a query; the camera stands in the middle of the screen's upper edge, `top` cm above the picture's
    centre, unless it says otherwise. Raises `ValueError` with a sentence."""
    given = dict(parse_qsl(query, keep_blank_values=True, max_num_fields=len(OPTIONS)))
    for name in given:
        if name not in OPTIONS:
            raise ValueError(f"a camera has no option `{name}`; it has {', '.join(OPTIONS)}")
    place = Point(*(_length(given, axis, usual) for axis, usual in (("x", 0.0), ("y", top), ("z", 0.0))))
    distance = _length(given, "distance", 0.0, 10.0) if "distance" in given else None
    mirrored = _one(given, "mirrored", ("no", "yes")) == "yes"
    camera = Camera(place, _angle(given, "tilt", 0.0, -80, 80), _angle(given, "fov", 60.0, 20, 150), mirrored, distance)
    by = _one(given, "by", BY) if "by" in given else None
    return Options(camera, _size(given), _delay(given), by)


def _one(given: dict[str, str], name: str, known: tuple[str, ...]) -> str:
    text = given.get(name, known[0])
    if text not in known:
        raise ValueError(f"`{name}={text[:40]}` is none of {', '.join(known)}")
    return text


def _length(given: dict[str, str], name: str, usual: float, least: float = -1_000.0) -> float:
    """Centimetres, ten metres at most."""
    amount = _amount(given, name, {"cm": 1.0, "m": 100.0}, usual)
    if not least <= amount <= 1_000.0:
        raise ValueError(f"`{name}={given[name][:40]}` is not within {least:.0f} and 1000 cm")
    return amount


def _angle(given: dict[str, str], name: str, usual: float, least: float, most: float) -> float:
    amount = _amount(given, name, {"": 1.0, "deg": 1.0}, usual)
    if not least <= amount <= most:
        raise ValueError(f"`{name}={given[name][:40]}` is not within {least:.0f} and {most:.0f} deg")
    return amount


def _delay(given: dict[str, str]) -> float:
    amount = _amount(given, "delay", {"ms": 0.001, "s": 1.0}, DELAY)
    if not 0.0 <= amount <= 1.0:
        raise ValueError(f"`delay={given['delay'][:40]}` is not within 0 and 1 s")
    return amount


def _size(given: dict[str, str]) -> tuple[int, int]:
    text = given.get("size")
    if text is None:
        return SIZE
    found = re.fullmatch(r"(\d{1,4})x(\d{1,4})", text)
    sides = (int(found[1]), int(found[2])) if found else (0, 0)
    if not all(SMALLEST <= side <= LARGEST for side in sides):
        raise ValueError(f"`size={text[:40]}` is no size such as 640x480, with sides of {SMALLEST} to {LARGEST}")
    return sides


def _amount(given: dict[str, str], name: str, units: dict[str, float], usual: float) -> float:
    """A number with its unit, in the base unit. Raises `ValueError`."""
    text = given.get(name)
    if text is None:
        return usual
    found = re.fullmatch(r"([+-]?\d{1,6}(?:\.\d{1,6})?)([a-z]*)", text)
    if found is None or found[2] not in units:
        wanted = " or ".join(f"`{name}=30{unit}`" for unit in units)
        raise ValueError(f"`{name}={text[:40]}` is written {wanted}")
    return float(found[1]) * units[found[2]]
