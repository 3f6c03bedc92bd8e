"""Files put in their places whole: each is written beside its place and renamed when all are done."""

from __future__ import annotations

import os
import secrets
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

BOM = "\ufeff".encode()


@dataclass(slots=True)
class Outputs:
    """The files of one build. `place` gives a path to write to; they appear together at `commit`, or not at all."""

    pending: list[tuple[Path, Path]] = field(default_factory=list)
    made: list[Path] = field(default_factory=list)

    def place(self, target: Path) -> Path:
        """A free path in the target's folder with the target's suffix. Raises `OSError` where that is not possible."""
        target = _real(target)
        if target.is_dir():
            raise IsADirectoryError(21, "a folder stands there")
        if not target.parent.is_dir():
            raise FileNotFoundError(2, "the folder does not exist")
        if target.exists() and not os.access(target, os.W_OK):
            raise PermissionError(13, "it is write-protected")
        beside = target.with_name(f".{target.stem[:80]}.{secrets.token_hex(6)}{target.suffix}")
        self.pending.append((beside, target))  # before it is there: an interrupt may come as it is made
        beside.touch(exist_ok=False)
        return beside

    def folder(self, target: Path) -> Path:
        """A folder to place files in, made where there is none, and gone again where none comes to it. Raises
        `OSError`."""
        if not target.is_dir():
            target.mkdir()
            self.made.append(target)
        return target

    @contextmanager
    def aside(self, suffix: str) -> Iterator[Path]:
        """A file of its own for output that goes elsewhere; gone after the block."""
        with tempfile.TemporaryDirectory() as folder:
            yield Path(folder) / f"output{suffix}"

    def commit(self) -> None:
        """Everything written comes to its place."""
        while self.pending:
            beside, target = self.pending[0]
            if beside.exists():
                if target.exists():
                    shutil.copymode(target, beside)
                os.replace(beside, target)
            self.pending.pop(0)

    def discard(self) -> None:
        """Nothing written stays."""
        for beside, _ in self.pending:
            beside.unlink(missing_ok=True)
        self.pending.clear()
        for folder in self.made:
            with suppress(OSError):  # there is something in it
                folder.rmdir()


@contextmanager
def outputs() -> Iterator[Outputs]:
    """Commit at the end of the block, or discard where it is left by a fault or an interrupt."""
    batch = Outputs()
    try:
        yield batch
        batch.commit()
    finally:
        batch.discard()


def write_whole(target: Path, write: Callable[[Path], object]) -> None:
    """One file written by `write` and put in its place."""
    with outputs() as batch:
        write(batch.place(target))


def write_script(path: Path, text: str) -> None:
    """A script written in its place, with the line ends and the mark at its start that it had. Raises `OSError`."""
    data = path.read_bytes()
    newline = "\r\n" if b"\r\n" in data else "\n"
    encoding = "utf-8-sig" if data.startswith(BOM) else "utf-8"
    write_whole(path, lambda beside: beside.write_text(text, encoding, newline=newline))


def _real(target: Path) -> Path:
    """A link's own target, so that a link stays a link."""
    return target.resolve() if target.is_symlink() else target
