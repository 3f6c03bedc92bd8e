"""Files to a ZIP archive as EPUB asks for it: its kind first, and nothing of the time or the machine in it."""

from __future__ import annotations

import shutil
from hashlib import sha256
from pathlib import Path
from types import TracebackType
from typing import IO
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile, ZipInfo

KIND = b"application/epub+zip"

OLDEST = (1980, 1, 1, 0, 0, 0)
"""The earliest time that a ZIP archive knows: all its files have it."""

READABLE = 0o644 << 16
"""The rights of a file, as ZIP has those of Unix."""

UNIX = 3

BLOCK = 1 << 20
"""Bytes copied at once."""


class Archive:
    """An EPUB that is being written; `digest` is of all that has been put into it."""

    def __init__(self, path: Path) -> None:
        self._zip = ZipFile(path, "w")
        self._hash = sha256()
        self.put("mimetype", KIND)

    def __enter__(self) -> Archive:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, at: TracebackType | None) -> None:
        self._zip.close()

    def put(self, name: str, data: bytes, packed: bool = False) -> None:
        """A file of these bytes, smaller where it is `packed`."""
        self._hash.update(name.encode() + b"\0" + sha256(data).digest())
        self._zip.writestr(_info(name, packed), data)

    def put_file(self, name: str, file: Path) -> None:
        """A file with the bytes of another."""
        with file.open("rb") as source:
            self._hash.update(name.encode() + b"\0" + _digest(source))
            source.seek(0)
            with self._zip.open(_info(name, False), "w") as out:
                shutil.copyfileobj(source, out, BLOCK)

    def digest(self) -> bytes:
        """32 bytes that stand for all files put so far, their names and their order."""
        return self._hash.digest()


def _info(name: str, packed: bool) -> ZipInfo:
    info = ZipInfo(name, OLDEST)
    info.compress_type = ZIP_DEFLATED if packed else ZIP_STORED
    info.external_attr = READABLE
    info.create_system = UNIX
    return info


def _digest(source: IO[bytes]) -> bytes:
    found = sha256()
    while block := source.read(BLOCK):
        found.update(block)
    return found.digest()
