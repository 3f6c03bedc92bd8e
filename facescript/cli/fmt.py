"""`facescript fmt`: scripts to the one layout, in place; a script that cannot be parsed stays as it is."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from facescript.backends.output import write_whole
from facescript.cli.report import FAULTS, refuse, show
from facescript.diagnostics.model import Diagnostics
from facescript.project import STANDARD, open_script
from facescript.syntax.formatter import format_source
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import WorldFailure


def run(options: argparse.Namespace) -> int:
    """0 done; 1 where a script has faults or, with --check, is not in the layout."""
    return max(_format(name, options.check) for name in options.scripts)


def _format(name: str, check: bool) -> int:
    try:
        source, _ = open_script(name)
    except WorldFailure as fault:
        return refuse("FS901", name=name, reason=fault.args[0])
    diagnostics = Diagnostics()
    parse(source, diagnostics)
    if diagnostics.failed:
        show(diagnostics)
        return FAULTS
    return _put(name, source, format_source(source), check)


def _put(name: str, source: Source, text: str, check: bool) -> int:
    if name == STANDARD:
        sys.stdout.write(text)
        return 0
    if text == source.text:
        return 0
    if check:
        print(f"{name}: not in the layout; `facescript fmt {name}` puts it there", file=sys.stderr)
        return FAULTS
    try:
        write_whole(Path(name), lambda path: path.write_text(text, "utf-8", newline="\n"))
    except OSError as fault:
        return refuse("FS903", path=name, reason=fault.strerror or "it cannot be written")
    return 0
