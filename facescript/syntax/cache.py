"""The parse table to and from the user's cache folder, as JSON.

A key covers all that makes the table: the grammar, Lark, Python, its form.
"""

from __future__ import annotations

import hashlib
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from facescript.cache import Room

FORM = 1
"""The number of the table's form; a change of `table.Table` raises it."""

ROOM = Room("tables", largest=4 << 20, bound=32 << 20)


def key_of(grammar: str) -> str:
    """The name of a table: a digest over the grammar, the versions of Lark and Python, and the table's form."""
    lark = find_spec("lark")
    version = Path(lark.origin).read_bytes() if lark and lark.origin else b""
    parts = (grammar.encode(), version, sys.version.encode(), str(FORM).encode())
    return hashlib.sha256(b"\0".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()[:32]


def load(key: str) -> dict[str, Any] | None:
    """The table kept under `key`; None where there is none, or none to be trusted."""
    kept: dict[str, Any] | None = ROOM.head(key)
    return kept


def save(key: str, kept: dict[str, Any]) -> None:
    """Keep a table."""
    ROOM.save(key, kept)
