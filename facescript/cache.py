"""What can be made again to and from the user's own cache folder; without a usable folder nothing is kept.

A file holds a line of digests, a line of JSON (its head) and bytes (its body). It is believed where it lies in a folder
that only the user can write to, is a plain file of the user's, and has the digests of its key, head and body.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
import sys
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

LONGEST_HEAD = 1 << 24
"""Bytes of a head."""

SHARE = 32
"""Of what a room may hold, one in so many bytes is written before it is tidied again."""


FLAGS = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_NOFOLLOW", "O_NONBLOCK", "O_BINARY"))
"""Links are not followed, a pipe does not wait for a writer, and Windows leaves the ends of lines as they are."""


class Room:
    """A folder of the cache. `key`s are names of files, made of letters and figures; of one key, one thing is kept.

    `largest` are the bytes of one file, `bound` those of all: what was used longest ago goes first. Builds may run at
    the same time: a file is written beside its place and renamed, so that a reader finds it whole or not at all.
    """

    def __init__(self, name: str, largest: int, bound: int) -> None:
        self._name, self._largest, self._bound = name, largest, bound
        self._untidied: int | None = None

    def head(self, key: str) -> Any:
        """The head of what is kept under `key`, its body unread; None where there is none, or none to be trusted."""
        try:
            with self._opened(key) as file:
                return _head(file, key)[0]
        except (OSError, ValueError):
            return None

    def load(self, key: str) -> tuple[Any, bytes] | None:
        """Head and body of what is kept under `key`; None where there is none, or none to be trusted."""
        try:
            with self._opened(key) as file:
                head, digest = _head(file, key)
                body = file.read()
        except (OSError, ValueError):
            return None
        return (head, body) if _digest(body) == digest else None

    def save(self, key: str, head: Any, body: bytes = b"") -> None:
        """Keep something whose head is plain JSON."""
        text = json.dumps(head, separators=(",", ":")).encode()
        size = len(text) + len(body)
        if len(text) >= LONGEST_HEAD or size > self._largest:
            return
        digests = f"{_digest(key.encode(), _digest(body).encode(), text)} {_digest(body)}\n".encode()
        with suppress(OSError):
            place = self._place(make=True)
            _write(place, key, (digests, text, b"\n", body))
            if self._untidied is None or self._untidied + size > self._bound // SHARE:
                _tidy(place, self._bound)
                self._untidied = 0
            self._untidied += size

    def stamp(self) -> int:
        """A number that is another once something is kept or removed; 0 where there is no usable folder."""
        try:
            return self._place().stat().st_mtime_ns
        except OSError:
            return 0

    def _opened(self, key: str) -> IO[bytes]:
        """The file of a key, marked as used now. Raises OSError, ValueError."""
        path = self._place() / key
        handle = os.open(path, FLAGS)
        file = os.fdopen(handle, "rb")
        state = os.fstat(handle)
        if not stat.S_ISREG(state.st_mode) or not _private(state) or state.st_size > self._largest + LONGEST_HEAD:
            file.close()
            raise ValueError("not to be trusted")
        with suppress(OSError):
            os.utime(path)
        return file

    def _place(self, make: bool = False) -> Path:
        """This room's folder. Raises OSError where there is none that only the user can write to."""
        home = _home()
        place = home / self._name
        if make:
            os.makedirs(home, mode=0o700, exist_ok=True)
            os.makedirs(place, mode=0o700, exist_ok=True)
        if not all(_private(os.stat(folder)) for folder in (home, place)):
            raise OSError("others can write there")
        return place


def _home() -> Path:
    """Where this user's programs keep what they can make again. Raises OSError where no such place is known."""
    named = os.environ.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(named):
        named = os.environ.get("LOCALAPPDATA", "") if sys.platform == "win32" else ""
    if os.path.isabs(named):
        return Path(named) / "facescript"
    try:
        home = Path.home()
    except RuntimeError:
        raise OSError("the user has no home") from None
    if not home.is_absolute():
        raise OSError("the user's home is not an absolute path")
    return home / ("Library/Caches" if sys.platform == "darwin" else ".cache") / "facescript"


def _head(file: IO[bytes], key: str) -> tuple[Any, str]:
    """A file's head and the digest of its body. Raises ValueError where it is not what was kept under `key`."""
    digest, _, body = file.readline(200).decode().rstrip("\n").partition(" ")
    text = file.readline(LONGEST_HEAD)
    if not text.endswith(b"\n") or _digest(key.encode(), body.encode(), text[:-1]) != digest:
        raise ValueError("not to be trusted")
    return json.loads(text), body


def _write(place: Path, key: str, parts: tuple[bytes, ...]) -> None:
    import tempfile  # only who keeps something pays it

    handle, beside = tempfile.mkstemp(dir=place, suffix=".part")
    try:
        with os.fdopen(handle, "wb") as file:
            file.writelines(parts)
        os.replace(beside, place / key)
    except OSError:
        os.unlink(beside)


def _tidy(place: Path, bound: int) -> None:
    """Remove what was used longest ago until at most `bound` bytes are left."""
    with os.scandir(place) as entries:
        states = [(entry.path, entry.stat(follow_symlinks=False)) for entry in entries]
    total = sum(state.st_size for _, state in states)
    for path, state in sorted(states, key=lambda found: found[1].st_mtime_ns):
        if total <= bound:
            return
        with suppress(OSError):  # another build has removed it, or a reader holds it
            os.unlink(path)
            total -= state.st_size


def _private(state: os.stat_result) -> bool:
    """Whether only this user can write there. Windows keeps this by where the folder lies."""
    return os.name != "posix" or (state.st_uid == os.getuid() and not state.st_mode & 0o022)


def _digest(*parts: bytes) -> str:
    return hashlib.sha256(b"".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()
