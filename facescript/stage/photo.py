"""A picture file's bytes to pixels that fill the film."""

from __future__ import annotations

import io
import warnings

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageOps

FORMATS = ("PNG", "JPEG", "WEBP", "GIF", "BMP")
"""What may be a background."""

MOST_PIXELS = 64_000_000
"""A picture may not be larger; it is decoded into memory whole."""


class PictureFailure(Exception):
    """A background picture that cannot be used; `args[0]` says why, without a full stop."""


def photo(data: bytes, width: int, height: int) -> NDArray[np.uint32]:
    """The picture as array[y, x] of 0xFFRRGGBB, scaled to cover `width` x `height` and cut evenly; clear parts are
    white. Raises `PictureFailure`."""
    image = _opened(data)
    try:
        covered = ImageOps.fit(_upright(image), (width, height), Image.Resampling.LANCZOS)
        on_white = Image.alpha_composite(Image.new("RGBA", covered.size, "white"), covered)
    except (OSError, SyntaxError, ValueError, EOFError, MemoryError) as fault:
        raise PictureFailure(f"it is broken ({fault})") from None
    rgba = np.asarray(on_white)
    bgra = np.ascontiguousarray(rgba[..., [2, 1, 0, 3]])
    return np.asarray(bgra.view("<u4")[..., 0], dtype=np.uint32)


def _opened(data: bytes) -> Image.Image:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            image = Image.open(io.BytesIO(data), formats=FORMATS)
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError):
        raise PictureFailure(f"it is none of {', '.join(FORMATS)}") from None
    if image.width * image.height > MOST_PIXELS:
        raise PictureFailure(f"it has more than {MOST_PIXELS // 1_000_000} million pixels")
    return image


def _upright(image: Image.Image) -> Image.Image:
    """The picture as its camera was held, with an alpha channel."""
    return ImageOps.exif_transpose(image).convert("RGBA")
