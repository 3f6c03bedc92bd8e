"""Outlines and fills to pixels: the few calls of ThorVG's C interface that the painter needs, over ctypes."""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Sequence
from ctypes import POINTER, c_bool, c_float, c_int, c_uint8, c_uint32, c_void_p
from functools import cache
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.rig.picture import Linear, Paint, Stop

CLOSE, MOVE, LINE, CUBIC = 0, 1, 2, 3
"""Path commands (thorvg_capi.h, Tvg_Path_Command)."""

NO_PARTIAL_RENDERING = 0
ARGB_PREMULTIPLIED = 1


class CanvasFailure(Exception):
    """ThorVG refused a call; `args[0]` names it."""


class _ColourStop(ctypes.Structure):
    _fields_ = (("offset", c_float), ("r", c_uint8), ("g", c_uint8), ("b", c_uint8), ("a", c_uint8))


class _Matrix(ctypes.Structure):
    _fields_ = tuple((f"e{row}{column}", c_float) for row in (1, 2, 3) for column in (1, 2, 3))


CREATORS: dict[str, list[Any]] = {
    "tvg_swcanvas_create": [c_uint8],
    "tvg_scene_new": [],
    "tvg_shape_new": [],
    "tvg_linear_gradient_new": [],
    "tvg_radial_gradient_new": [],
}
"""Calls that give a new object, with their argument types."""

CALLS: dict[str, list[Any]] = {
    "tvg_engine_init": [c_uint32],
    "tvg_canvas_destroy": [c_void_p],
    "tvg_canvas_add": [c_void_p, c_void_p],
    "tvg_canvas_update": [c_void_p],
    "tvg_canvas_draw": [c_void_p, c_bool],
    "tvg_canvas_sync": [c_void_p],
    "tvg_scene_add": [c_void_p, c_void_p],
    "tvg_swcanvas_set_target": [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_int],
    "tvg_shape_reset": [c_void_p],
    "tvg_shape_append_path": [c_void_p, c_void_p, c_uint32, c_void_p, c_uint32],
    "tvg_shape_set_fill_color": [c_void_p, c_uint8, c_uint8, c_uint8, c_uint8],
    "tvg_shape_set_gradient": [c_void_p, c_void_p],
    "tvg_shape_set_stroke_width": [c_void_p, c_float],
    "tvg_shape_set_stroke_color": [c_void_p, c_uint8, c_uint8, c_uint8, c_uint8],
    "tvg_shape_set_stroke_join": [c_void_p, c_int],
    "tvg_shape_set_stroke_dash": [c_void_p, POINTER(c_float), c_uint32, c_float],
    "tvg_paint_set_opacity": [c_void_p, c_uint8],
    "tvg_paint_set_clip": [c_void_p, c_void_p],
    "tvg_paint_get_aabb": [c_void_p, POINTER(c_float), POINTER(c_float), POINTER(c_float), POINTER(c_float)],
    "tvg_linear_gradient_set": [c_void_p, *[c_float] * 4],
    "tvg_radial_gradient_set": [c_void_p, *[c_float] * 6],
    "tvg_gradient_set_color_stops": [c_void_p, POINTER(_ColourStop), c_uint32],
    "tvg_gradient_set_transform": [c_void_p, POINTER(_Matrix)],
}
"""Calls that give a result code, 0 for success."""


@cache
def library() -> Any:
    """The library, its calls typed and checked, started with no threads of its own. Raises `CanvasFailure`."""
    try:
        from thorvg_python.engine import THORVG_LIB as lib
    except ImportError as fault:
        raise CanvasFailure(f"ThorVG cannot be loaded ({fault})") from None
    if lib is None:
        raise CanvasFailure("ThorVG's library is not where its package should have it")
    for name, types in CREATORS.items():
        getattr(lib, name).argtypes, getattr(lib, name).restype = types, c_void_p
    for name, types in CALLS.items():
        call = getattr(lib, name)
        call.argtypes, call.restype, call.errcheck = types, c_int, _checked
    lib.tvg_engine_init(0)
    return lib


def _checked(result: int, call: Any, arguments: Any) -> int:
    if result:
        raise CanvasFailure(f"{call.__name__} gave {result}")
    return result


class Drawable(Protocol):
    """What a canvas draws: `paint` is ThorVG's own handle of it."""

    paint: int


class Outline:
    """One filled path: a fixed list of contours and its fill."""

    def __init__(self, lengths: Sequence[int], fill: Paint) -> None:
        """`lengths` are the contours' point counts, each 1 + 3 * segments."""
        self._lib = library()
        self.paint = self._lib.tvg_shape_new()
        commands = [[MOVE, *[CUBIC] * ((length - 1) // 3), CLOSE] for length in lengths]
        self._kept = np.array([command for contour in commands for command in contour], dtype=np.uint8)
        self._commands = self._kept.ctypes.data, len(self._kept)
        self._count = sum(lengths)
        self._gradient = self._filled(fill)

    def shape(self, address: int, place: Sequence[float] = ()) -> None:
        """Take a new outline, pairs of 32-bit floats in px, contour after contour. Its gradient follows: it
        fills the upright box, or goes to a `place`, the first two rows of a matrix from the unit square."""
        lib = self._lib
        lib.tvg_shape_reset(self.paint)
        lib.tvg_shape_append_path(self.paint, *self._commands, address, self._count)
        if self._gradient is not None:
            lib.tvg_gradient_set_transform(self._gradient, _Matrix(*place, 0, 0, 1) if place else self._box())
            lib.tvg_shape_set_gradient(self.paint, self._gradient)

    def shade(self, level: int) -> None:
        """Take a new opacity, 0..255."""
        self._lib.tvg_paint_set_opacity(self.paint, level)

    def _filled(self, fill: Paint) -> int | None:
        """Set the fill; give the gradient where it is one. Places are fractions of the bounding box."""
        lib = self._lib
        if isinstance(fill, str):
            lib.tvg_shape_set_fill_color(self.paint, *colour(fill), 255)
            return None
        if isinstance(fill, Linear):
            gradient = lib.tvg_linear_gradient_new()
            lib.tvg_linear_gradient_set(gradient, *fill.start, *fill.end)
        else:
            gradient = lib.tvg_radial_gradient_new()
            lib.tvg_radial_gradient_set(gradient, *fill.centre, fill.radius, *fill.centre, 0.0)
        stops = (_ColourStop * len(fill.stops))(*map(_stop, fill.stops))
        lib.tvg_gradient_set_color_stops(gradient, stops, len(stops))
        lib.tvg_shape_set_gradient(self.paint, gradient)
        return int(gradient)

    def _box(self) -> _Matrix:
        """The unit square to the curves' bounding box, as SVG's objectBoundingBox."""
        x, y, width, height = c_float(), c_float(), c_float(), c_float()
        self._lib.tvg_paint_get_aabb(self.paint, x, y, width, height)
        thin = 1e-3
        return _Matrix(max(width.value, thin), 0, x.value, 0, max(height.value, thin), y.value, 0, 0, 1)


class Clipped:
    """Outlines drawn inside the outline of another."""

    def __init__(self, clip: Outline, outlines: Sequence[Outline]) -> None:
        lib = library()
        self.paint = lib.tvg_scene_new()
        for outline in outlines:
            lib.tvg_scene_add(self.paint, outline.paint)
        lib.tvg_paint_set_clip(self.paint, clip.paint)


class Canvas:
    """Paints drawn in their order onto pixels that the caller owns: array[y, x] of 0xAARRGGBB, premultiplied."""

    def __init__(self, pixels: NDArray[np.uint32], paints: Sequence[Drawable]) -> None:
        self._lib = library()
        self._pixels = pixels
        self._canvas = self._lib.tvg_swcanvas_create(NO_PARTIAL_RENDERING)
        self._release = weakref.finalize(self, self._lib.tvg_canvas_destroy, self._canvas)
        height, width = pixels.shape
        self._lib.tvg_swcanvas_set_target(self._canvas, pixels.ctypes.data, width, width, height, ARGB_PREMULTIPLIED)
        self._empty = not paints
        for paint in paints:
            self._lib.tvg_canvas_add(self._canvas, paint.paint)

    def draw(self) -> None:
        """Draw all paints over what the pixels hold."""
        if self._empty:
            return
        self._lib.tvg_canvas_update(self._canvas)
        self._lib.tvg_canvas_draw(self._canvas, False)
        self._lib.tvg_canvas_sync(self._canvas)


def colour(text: str) -> tuple[int, int, int]:
    """Red, green and blue 0..255 of `#rrggbb`."""
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def _stop(stop: Stop) -> _ColourStop:
    return _ColourStop(stop.offset, *colour(stop.colour), round(255 * stop.opacity))
