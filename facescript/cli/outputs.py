"""Names of outputs to what is made of them and where it is put: files, or standard output."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

from facescript.backends.output import Outputs
from facescript.cli.report import OptionFault
from facescript.project import STANDARD


def targets(options: argparse.Namespace, suffix: str) -> list[str]:
    """The outputs asked for; one beside the script where none is."""
    if options.output:
        return list(options.output)
    return [STANDARD if options.script == STANDARD else str(Path(options.script).with_suffix(suffix))]


def suffix_of(target: str, kind: str | None, known: Iterable[str] = ()) -> str:
    """The suffix that says what an output is: its own, the longest of those `known`; on standard output what `--as`
    says."""
    if target == STANDARD:
        return f".{(kind or '').lstrip('.')}"
    name = Path(target).name.lower()
    return max((suffix for suffix in known if name.endswith(suffix)), key=len, default=Path(name).suffix)


def no_kind(target: str, suffix: str, known: Iterable[str]) -> OptionFault:
    """The fault of an output that is of no known kind."""
    if suffix == ".":
        return OptionFault("FS902", suffix=target, known=", ".join(f"`--as {name[1:]}`" for name in known))
    return OptionFault("FS902", suffix=suffix or target, known=", ".join(known))


def put(target: str, suffix: str, batch: Outputs, write: Callable[[Path], object]) -> None:
    """What `write` makes comes to its place with the batch, or to standard output."""
    if target != STANDARD:
        write(batch.place(Path(target)))
        return
    with batch.aside(suffix) as path:
        write(path)
        sys.stdout.buffer.write(path.read_bytes())
        sys.stdout.buffer.flush()
