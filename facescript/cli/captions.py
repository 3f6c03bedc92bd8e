"""`--captions` and `--font` to how captions are made, or to why the outputs have none."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from facescript.cli.report import OptionFault

WAYS = ("words", "sentences", "burn")

BURNT, WRITTEN = (".mp4", ".webm", ".gif", ".png"), (".vtt", ".srt")
"""Outputs into which captions can be burned, and those that are captions."""

LARGEST_FONT = 64 * 1024 * 1024
"""Bytes of a font."""


def fit_captions(options: argparse.Namespace, suffixes: Sequence[str]) -> None:
    """`--captions` and `--font` need an output that has them."""
    how = options.captions
    if how not in (None, *WAYS):
        raise OptionFault("FS904", option="--captions", value=how, example="words")
    takes = BURNT if how == "burn" else WRITTEN
    if how is not None and not set(takes) & set(suffixes):
        raise OptionFault("FS905", option=f"--captions {how}", fitting=" and ".join(takes), suffix=suffixes[0])
    if options.font is not None and how != "burn":
        raise OptionFault(
            "FS905", option="--font", fitting="`--captions burn`", suffix=f"--captions {how or 'sentences'}"
        )


def font_named(name: str | None) -> bytes | None:
    """The bytes of the font that `--font` names. Raises `OptionFault`."""
    if name is None:
        return None
    try:
        if Path(name).stat().st_size > LARGEST_FONT:
            raise OptionFault("FS901", name=name, reason=f"it is larger than {LARGEST_FONT >> 20} MiB")
        return Path(name).read_bytes()
    except OSError as fault:
        raise OptionFault("FS901", name=name, reason=fault.strerror or "it cannot be read") from None
