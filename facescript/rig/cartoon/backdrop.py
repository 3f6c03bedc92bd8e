"""A face's style -> the default ground behind it, which nothing moves."""

from __future__ import annotations

import numpy as np

from facescript.rig.cartoon import table
from facescript.rig.cartoon.style import FaceStyle
from facescript.rig.picture import Picture, Shape


def backdrop(style: FaceStyle) -> tuple[tuple[Shape, ...], Picture]:
    """Shapes of group "background" with points of their own, and their one frame; the art box is 720 x 720 px."""
    parts = style.backdrop
    if not parts:
        return (), Picture(np.empty((1, 0, 2)), np.empty((1, 0)), np.empty((1, 0)))
    outlines = {part.id: part.loops for part in parts}
    anchors = table.build(parts, outlines, outlines)
    middle = style.eyes_at
    columns = [anchors.points(values[:, None])[:, 0] + middle[k] for k, values in enumerate((anchors.x, anchors.y))]
    shapes = tuple(
        Shape(part.id, part.group, anchors.contours[part.id], part.fill, part.clip, moving=False) for part in parts
    )
    opacity = np.array([[part.opacity for part in parts]])
    return shapes, Picture(np.stack(columns, axis=-1)[None], opacity, np.zeros_like(opacity))
