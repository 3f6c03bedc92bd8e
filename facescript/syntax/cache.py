"""The parse table to and from the user's own cache folder, as JSON; without a usable folder nothing is kept.

A file is believed where it lies in a folder that only the user can write to, is a plain file of the user's, and begins
with the digest of its key and its text. A key covers all that makes the table: the grammar, Lark, Python, its form.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

FORM = 1
"""The number of the table's form; a change of `table.Table` raises it."""

LARGEST = 4 * 1024 * 1024


def key_of(grammar: str) -> str:
    """The name of a table: a digest over the grammar, the versions of Lark and Python, and the table's form."""
    lark = find_spec("lark")
    version = Path(lark.origin).read_bytes() if lark and lark.origin else b""
    parts = (grammar.encode(), version, sys.version.encode(), str(FORM).encode())
    return hashlib.sha256(b"\0".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()[:32]


def load(key: str) -> dict[str, Any] | None:
    """The table kept under `key`; None where there is none, or none to be trusted."""
    place = _folder()
    if place is None:
        return None
    try:
        if not _private(os.stat(place)):
            return None
        digest, _, body = _read(place / f"table-{key}.json").partition(b"\n")
        if digest.decode() != _digest(key, body):
            return None
        kept: dict[str, Any] = json.loads(body)
    except (OSError, ValueError):
        return None
    return kept


def save(key: str, kept: dict[str, Any]) -> None:
    """Keep a table: written beside its place and renamed, so that a reader finds it whole or not at all."""
    place = _folder()
    if place is None:
        return
    import tempfile

    body = json.dumps(kept, separators=(",", ":")).encode()
    try:
        os.makedirs(place, mode=0o700, exist_ok=True)
        if not _private(os.stat(place)):
            return
        handle, beside = tempfile.mkstemp(dir=place, prefix="table-", suffix=".part")
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(_digest(key, body).encode() + b"\n" + body)
            os.replace(beside, place / f"table-{key}.json")
        except OSError:
            os.unlink(beside)
    except OSError:
        return


def _folder() -> Path | None:
    """Where this user's programs keep what they can make again."""
    named = os.environ.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(named):
        named = os.environ.get("LOCALAPPDATA", "") if sys.platform == "win32" else ""
    try:
        home = Path.home()
    except RuntimeError:
        home = None
    if os.path.isabs(named):
        return Path(named) / "facescript"
    if home is None or not home.is_absolute():
        return None
    return home / ("Library/Caches" if sys.platform == "darwin" else ".cache") / "facescript"


def _read(path: Path) -> bytes:
    """The bytes of a private plain file; links are not followed. Raises OSError, ValueError."""
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    with os.fdopen(handle, "rb") as file:
        state = os.fstat(handle)
        if not stat.S_ISREG(state.st_mode) or not _private(state) or state.st_size > LARGEST:
            raise ValueError("not to be trusted")
        return file.read()


def _private(state: os.stat_result) -> bool:
    """Whether only this user can write there. Windows keeps this by where the folder lies."""
    return os.name != "posix" or (state.st_uid == os.getuid() and not state.st_mode & 0o022)


def _digest(key: str, body: bytes) -> str:
    return hashlib.sha256(key.encode() + b"\0" + body).hexdigest()
