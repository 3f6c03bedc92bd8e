"""Names of numbered pictures: `frame-%04d.png` stands for one file a frame."""

from __future__ import annotations

import re

PATTERN = re.compile(r"^[^%]*%(0[1-9])?d[^%]*$")


def is_numbered(name: str) -> bool:
    """Whether a name holds exactly one number sign `%d` or `%04d`."""
    return PATTERN.match(name) is not None
