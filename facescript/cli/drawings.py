"""A drawing and its writers to the files asked for, and what is told of letters that a picture lacks."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TypeVar

from facescript.backends.job import JobFailure
from facescript.backends.output import outputs
from facescript.cli.outputs import no_kind, put, suffix_of, targets
from facescript.cli.report import refuse
from facescript.plot.marks import Drawing
from facescript.plot.png import lacking

Kind = TypeVar("Kind")
Writers = Mapping[str, Callable[[Kind, Path], None]]
"""By suffix."""


def wanted(options: argparse.Namespace, usual: str, writers: Writers[Kind]) -> list[tuple[str, str]]:
    """The outputs asked for, or one `usual` beside the script, each with its suffix. Raises `OptionFault`."""
    found = [(target, suffix_of(target, options.kind)) for target in targets(options, usual)]
    for target, suffix in found:
        if suffix not in writers:
            raise no_kind(target, suffix, writers)
    return found


def write(made: Kind, drawing: Drawing, outs: list[tuple[str, str]], writers: Writers[Kind]) -> int:
    """What is made, whose texts `drawing` has, as all the files or none; 0 made, 1 not."""
    target = ""
    try:
        with outputs() as batch:
            for target, suffix in outs:
                put(target, suffix, batch, partial(writers[suffix], made))
    except JobFailure as fault:
        return refuse("FS907", path=target, reason=fault.args[0])
    except OSError as fault:
        return refuse("FS903", path=target, reason=fault.strerror or "it cannot be written")
    for target, suffix in outs:
        letters = lacking(drawing) if suffix == ".png" else ""
        if letters:
            refuse("FS924", path=target, letters=_listed(letters))
    return 0


def _listed(letters: str, most: int = 5) -> str:
    more = f" and {len(letters) - most} more letters" if len(letters) > most else ""
    return ", ".join(f"“{letter}”" for letter in letters[:most]) + more
