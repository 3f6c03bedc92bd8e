"""The signs of all captions of a film to one font that has them: the one asked for, else the first that does."""

from __future__ import annotations

import sys
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache, lru_cache
from io import BytesIO
from pathlib import Path

from PIL import ImageFont, features

from facescript.backends.job import JobFailure

FOLDERS = {
    "linux": ("/usr/share/fonts", "/usr/local/share/fonts"),
    "darwin": ("/System/Library/Fonts", "/Library/Fonts"),
    "win32": ("C:/Windows/Fonts",),
}
"""Where systems keep their fonts."""

NAMES = (
    *("NotoSans-Medium.ttf", "NotoSans-Regular.ttf", "DejaVuSans.ttf", "LiberationSans-Regular.ttf", "arial.ttf"),
    *("Arial.ttf", "segoeui.ttf", "NotoSansCJK-Medium.ttc", "NotoSansCJK-Regular.ttc", "SourceHanSansSC-Regular.otf"),
    *("wqy-microhei.ttc", "wqy-zenhei.ttc", "DroidSansFallbackFull.ttf", "PingFang.ttc", "STHeiti Medium.ttc"),
    *("msyh.ttc", "simhei.ttf", "Arial Unicode.ttf", "NotoSansArabic-Regular.ttf", "NotoSansHebrew-Regular.ttf"),
    *("NotoSansDevanagari-Regular.ttf", "NotoSansThai-Regular.ttf", "Nirmala.ttf", "leelawui.ttf"),
)
"""Fonts that are looked for there, in this order."""

LARGEST = 64 * 1024 * 1024
"""Bytes of a font."""

BIG = 40
"""The size at which a sign is told from the box that stands for one that is lacking, px."""

SHAPED = ((0x0590, 0x08FF), (0x0900, 0x0DFF), (0x0E00, 0x109F), (0x1780, 0x17FF), (0xFB1D, 0xFDFF), (0xFE70, 0xFEFF))
"""Scripts that run from right to left, or whose signs change with their neighbours: they need Raqm."""

ADVICE = "give a font that has them with `--font FILE`"


@dataclass(frozen=True)
class Face:
    """A font at any size. `data` is its file's bytes, None for Pillow's own."""

    data: bytes | None

    def at(self, size: int) -> ImageFont.FreeTypeFont:
        """The font at a size in px."""
        return _opened(self.data, size)

    def lacks(self, signs: Iterable[str]) -> str:
        """The signs that it does not have."""
        return "".join(sign for sign in signs if not _has(self.data, sign))


@lru_cache(maxsize=64)
def _opened(data: bytes | None, size: int) -> ImageFont.FreeTypeFont:
    if data is not None:
        return ImageFont.truetype(BytesIO(data), size)
    found = ImageFont.load_default(size)
    assert isinstance(found, ImageFont.FreeTypeFont), "Pillow comes with FreeType"
    return found


@lru_cache(maxsize=16384)
def _has(data: bytes | None, sign: str) -> bool:
    if sign.isspace() or unicodedata.category(sign) in ("Cf", "Mn", "Cc"):
        return True
    return bytes(_opened(data, BIG).getmask(sign)) not in (_box(data), b"")


@cache
def _box(data: bytes | None) -> bytes:
    return bytes(_opened(data, BIG).getmask("\uffff"))


def font_for(texts: Iterable[str], wanted: bytes | None) -> Face:
    """A font for all the texts. Raises `JobFailure` where none has their signs, and says which are lacking."""
    signs = sorted(set("".join(texts)))
    if any(first <= ord(sign) <= last for sign in signs for first, last in SHAPED) and not features.check("raqm"):
        raise JobFailure("these captions need Raqm to join their letters, which this Pillow lacks; install libraqm")
    if wanted is not None:
        return _checked(_given(wanted), signs)
    lacking = ""
    for face in _candidates():
        missing = face.lacks(signs)
        if not missing:
            return face
        lacking = missing if not lacking or len(missing) < len(lacking) else lacking
    raise JobFailure(f"no font here has the signs {_some(lacking)} of its captions; {ADVICE}")


def _given(data: bytes) -> Face:
    try:
        _opened(data, BIG)
    except OSError:
        raise JobFailure("what `--font` names is no font (a .ttf, .otf or .ttc file)") from None
    return Face(data)


def _checked(face: Face, signs: Iterable[str]) -> Face:
    missing = face.lacks(signs)
    if missing:
        raise JobFailure(f"the font of `--font` lacks the signs {_some(missing)} of its captions")
    return face


def _some(signs: str) -> str:
    return f"`{signs[:12]}`" + (f" and {len(signs) - 12} more" if len(signs) > 12 else "")


def _candidates() -> Iterator[Face]:
    """Pillow's own font, which is everywhere the same; then the system's."""
    yield Face(None)
    for path in _system():
        try:
            if path.stat().st_size <= LARGEST:
                face = Face(path.read_bytes())
                face.at(BIG)
                yield face
        except OSError:
            continue


@cache
def _system() -> tuple[Path, ...]:
    found: dict[str, Path] = {}
    for folder in FOLDERS.get(sys.platform, ()):
        for path in sorted(Path(folder).rglob("*.[tToO][tT][fFcC]")):
            found.setdefault(path.name, path)
    return tuple(found[name] for name in NAMES if name in found)
