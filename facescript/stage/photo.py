"""A picture file's bytes to pixels that fill the film."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageOps

from facescript.pictures import BROKEN, PictureFailure, opened


def photo(data: bytes, width: int, height: int) -> NDArray[np.uint32]:
    """The picture as array[y, x] of 0xFFRRGGBB, scaled to cover `width` x `height` and cut evenly; clear parts are
    white. Raises `PictureFailure`."""
    image = opened(data)
    try:
        covered = ImageOps.fit(_upright(image), (width, height), Image.Resampling.LANCZOS)
        on_white = Image.alpha_composite(Image.new("RGBA", covered.size, "white"), covered)
    except BROKEN as fault:
        raise PictureFailure(f"it is broken ({fault})") from None
    rgba = np.asarray(on_white)
    bgra = np.ascontiguousarray(rgba[..., [2, 1, 0, 3]])
    return np.asarray(bgra.view("<u4")[..., 0], dtype=np.uint32)


def _upright(image: Image.Image) -> Image.Image:
    """The picture as its camera was held, with an alpha channel."""
    return ImageOps.exif_transpose(image).convert("RGBA")
