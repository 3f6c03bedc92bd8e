"""Polygons and lines of one look to ThorVG's paints, for pictures that are drawn once."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

import numpy as np

from facescript.canvas.thorvg import CLOSE, LINE, MOVE, colour, library

ROUND_JOIN = 1
"""Corners of lines are round: a spike would show more than there is (thorvg_capi.h, Tvg_Stroke_Join)."""

Points = Sequence[tuple[float, float]]
"""px."""


class Path:
    """Straight lines from point to point. Fill and stroke are `#rrggbb`; what is empty is not drawn."""

    def __init__(self, points: Points, closed: bool, fill: str = "", stroke: str = "") -> None:
        self._lib = library()
        self.paint = self._lib.tvg_shape_new()
        self._commands = np.array([MOVE, *[LINE] * (len(points) - 1), *([CLOSE] if closed else [])], dtype=np.uint8)
        self._points = np.array(points, dtype=np.float32).reshape(-1, 2)
        addresses = self._commands.ctypes.data, len(self._commands), self._points.ctypes.data, len(self._points)
        self._lib.tvg_shape_append_path(self.paint, *addresses)
        if fill:
            self._lib.tvg_shape_set_fill_color(self.paint, *colour(fill), 255)
        if stroke:
            self._lib.tvg_shape_set_stroke_color(self.paint, *colour(stroke), 255)
            self._lib.tvg_shape_set_stroke_join(self.paint, ROUND_JOIN)

    def stroke(self, width: float, dash: Sequence[float] = (), along: float = 0.0) -> None:
        """The width of its stroke, the lengths drawn and left out by turns, and how far along those it begins, px."""
        self._lib.tvg_shape_set_stroke_width(self.paint, width)
        if dash:
            lengths = (ctypes.c_float * len(dash))(*dash)
            self._lib.tvg_shape_set_stroke_dash(self.paint, lengths, len(dash), along % sum(dash))
