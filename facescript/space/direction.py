"""Directions as yaw and pitch to vectors of the room, and back."""

from __future__ import annotations

from math import atan2, cos, degrees, hypot, radians, sin


def towards(yaw: float, pitch: float) -> tuple[float, float, float]:
    """The unit vector (x right, y up, z to the viewer) of a direction in deg: yaw, then pitch."""
    y, p = radians(yaw), radians(pitch)
    return sin(y) * cos(p), sin(p), cos(y) * cos(p)


def angles(x: float, y: float, z: float) -> tuple[float, float]:
    """Yaw and pitch (deg) of a vector, the inverse of `towards`."""
    return degrees(atan2(x, z)), degrees(atan2(y, hypot(x, z)))
