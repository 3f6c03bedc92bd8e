"""Shapes, their paints and what lies behind them to the plain objects that `drawing.js` draws from."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from facescript.backends.page.basis import PLACE
from facescript.backends.page.motion import LEVELS, RATE, TURN, VIEW, Motion
from facescript.backends.page.packing import packed
from facescript.backends.svg.ground import photo_address
from facescript.rig.picture import Linear, Paint, Radial, Shape
from facescript.stage.ground import Backdrop, Clear, Layer, Photo
from facescript.stage.stage import Stage

Object = dict[str, object]


def figure(stage: Stage, moved: Motion) -> Object:
    """All that does not change from frame to frame; `moved` must be whole."""
    layers: dict[Layer, int] = {}
    grounds = [
        [frame, [[layers.setdefault(layer, len(layers)), round(share, 4)] for layer, share in ground]]
        for frame, ground in moved.grounds
    ]
    return {
        **outlines(stage),
        "frames": moved.frames,
        "partFrames": moved.part_frames,
        "parts": [part.ways for part in moved.parts],
        "cuts": moved.cuts,
        "faces": [_face(moved, number) for number in range(len(moved.bases))],
        "layers": [layer_of(layer, stage.pictures) for layer in layers],
        "grounds": grounds,
    }


def outlines(stage: Stage) -> Object:
    """What does not change however faces move: the shapes in drawing order, their paints, and the steps of numbers."""
    paints: dict[Paint, int] = {}
    shapes = _shapes(stage.shapes, paints)
    return {
        "size": [stage.width, stage.height],
        "fps": RATE,
        "steps": {"place": PLACE, "level": 1 / LEVELS, "turn": TURN, "view": VIEW.tolist()},
        "shapes": shapes,
        "paints": [_paint(paint) for paint in paints],
        "still": next((place for place, shape in enumerate(stage.shapes) if shape.moving), len(shapes)),
    }


def _face(moved: Motion, number: int) -> Object:
    """A face's points: mean places and ways of moving."""
    basis = moved.bases[number]
    ways, steps = basis.ways()
    rows = ways.reshape(2 * len(ways), ways.shape[1] // 2)
    return {
        "first": moved.firsts[number],
        "mean": packed(basis.mean.reshape(2, -1)),
        "ways": packed(rows) if len(ways) else "",
        "steps": [float(f"{step:.4g}") for step in steps],
    }


def _shapes(shapes: Sequence[Shape], paints: dict[Paint, int]) -> list[Object]:
    place = {shape.id: number for number, shape in enumerate(shapes)}
    return [
        {
            "contours": [[each.first, each.count] for each in shape.contours],
            "paint": paints.setdefault(shape.fill, len(paints)),
            "clip": [place[name] for name in shape.clip],
        }
        for shape in shapes
    ]


def _paint(paint: Paint) -> object:
    """A colour, or a gradient's places in fractions of its box, and its stops."""
    if isinstance(paint, Linear):
        return {"line": [*paint.start, *paint.end], "stops": _stops(paint)}
    if isinstance(paint, Radial):
        return {"circle": [*paint.centre, paint.radius], "stops": _stops(paint)}
    return str(paint)


def _stops(paint: Linear | Radial) -> list[list[object]]:
    return [[stop.offset, f"{stop.colour}{round(255 * stop.opacity):02x}"] for stop in paint.stops]


def layer_of(layer: Layer, pictures: Callable[[str], bytes]) -> object:
    """A paint, a picture's address, or null for nothing."""
    if isinstance(layer, Photo):
        return {"picture": photo_address(pictures(layer.path))}
    if isinstance(layer, Clear):
        return None
    return _paint(layer.paint if isinstance(layer, Backdrop) else layer)
