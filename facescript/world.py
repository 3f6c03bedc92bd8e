"""The one door to the outside: reads the project's files and the library; nothing outside the project's folder."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path

from facescript.resources import folder
from facescript.text import Source

LARGEST_SCRIPT = 4 * 1024 * 1024
"""Bytes of text the compiler reads from one file."""

LARGEST_FILE = 256 * 1024 * 1024
"""Bytes of any other file."""


FRESH = 2.0
"""Seconds in which a file may be written again without another time of writing."""


class WorldFailure(Exception):
    """A file that cannot be read; `args[0]` is a clause for the author ("there is no such file")."""


@dataclass(frozen=True, slots=True)
class World:
    """A project: `root` is its folder; paths in scripts are relative to the script that names them."""

    root: Path

    def source(self, name: str) -> Source:
        """A script of the project by its path relative to the root. Raises `WorldFailure`."""
        return Source(name, decode(self.read(name, LARGEST_SCRIPT)))

    def read(self, name: str, largest: int = LARGEST_FILE) -> bytes:
        """The bytes of a file of the project. Raises `WorldFailure`."""
        path = self.path(name)
        try:
            if not path.is_file():
                raise WorldFailure("it is a folder" if path.is_dir() else "there is no such file")
            if path.stat().st_size > largest:
                raise WorldFailure(f"it is larger than {largest // 1024 // 1024} MiB")
            return path.read_bytes()
        except OSError as fault:
            raise WorldFailure(fault.strerror or "it cannot be read") from None

    def path(self, name: str) -> Path:
        """The real path of a file of the project, links followed. Raises `WorldFailure` where it lies outside."""
        try:
            root = self.root.resolve()
            path = (root / name).resolve()
        except (OSError, RuntimeError, ValueError):
            raise WorldFailure("its path cannot be followed") from None
        if not path.is_relative_to(root):
            raise WorldFailure("it lies outside the project's folder")
        return path

    def exists(self, name: str) -> bool:
        try:
            return self.path(name).is_file()
        except (WorldFailure, OSError):
            return False

    def stamp(self, name: str) -> object:
        """Something that is equal for a file as long as it is as it was, by what the system says of it."""
        try:
            found = (self.root / name).stat()
        except (OSError, ValueError) as fault:
            return str(fault)
        if time.time() - max(found.st_mtime, found.st_ctime) < FRESH:
            return object()
        return found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns, found.st_ctime_ns, found.st_mode

    def library(self) -> tuple[Source, ...]:
        """The scripts of the standard library, in the order of their names."""
        paths = sorted(folder("stdlib").glob("*.face"))
        return tuple(Source(f"stdlib/{path.name}", path.read_text("utf-8")) for path in paths)


@dataclass(frozen=True, slots=True)
class ReadWorld(World):
    """A project that keeps in mind which of its files were read, or looked for."""

    names: set[str] = field(default_factory=set, hash=False, compare=False)

    def read(self, name: str, largest: int = LARGEST_FILE) -> bytes:
        self.names.add(name)
        return World.read(self, name, largest)


def decode(data: bytes) -> str:
    """A script's bytes as text with plain line ends. Raises `WorldFailure` where they are not UTF-8 text."""
    if b"\0" in data:
        raise WorldFailure("it is not text")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        line = data.count(b"\n", 0, fault.start) + 1
        raise WorldFailure(f"it is not UTF-8: byte 0x{data[fault.start]:02x} in line {line}") from None
    return text.replace("\r\n", "\n").replace("\r", "\n")
