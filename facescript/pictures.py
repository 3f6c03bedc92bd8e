"""A picture file's bytes to a picture, or to what is wrong with them."""

from __future__ import annotations

import io
import warnings

from PIL import Image

FORMATS = ("PNG", "JPEG", "WEBP", "GIF", "BMP")
"""What may be a background."""

MOST_PIXELS = 64_000_000
"""A picture may not be larger; it is decoded into memory whole."""

BROKEN = (OSError, SyntaxError, ValueError, EOFError, MemoryError)
"""What Pillow raises on bytes that are not what they say."""


class PictureFailure(Exception):
    """A background picture that cannot be used; `args[0]` says why, without a full stop."""


def opened(data: bytes) -> Image.Image:
    """The picture, its size known and its pixels decoded. Raises `PictureFailure`."""
    image = _begun(data)
    if image.width * image.height > MOST_PIXELS:
        raise _too_large()
    try:
        image.load()
    except BROKEN as fault:
        raise PictureFailure(f"it is broken ({fault})") from None
    return image


def _begun(data: bytes) -> Image.Image:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return Image.open(io.BytesIO(data), formats=FORMATS)
    except Image.DecompressionBombError:
        raise _too_large() from None
    except BROKEN:
        raise PictureFailure(f"it is none of {', '.join(FORMATS)}") from None


def _too_large() -> PictureFailure:
    return PictureFailure(f"it has more than {MOST_PIXELS // 1_000_000} million pixels")
