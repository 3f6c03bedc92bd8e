"""`facescript check`: scripts to what is wrong with them, and with `--fix` to scripts without what has a fix.

Starts no voice and loads no numpy.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from facescript.backends.output import write_script
from facescript.cli.fixing import fixed
from facescript.cli.report import OptionFault, in_order, show, show_json
from facescript.cli.settings import settings
from facescript.compile import Settings
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic
from facescript.project import STANDARD, compile_any, is_play, open_script
from facescript.speech.voices.known import KnownTimes
from facescript.text import Source
from facescript.world import World, WorldFailure


def run(options: argparse.Namespace) -> int:
    """0 clean (warnings allowed), 1 errors. Raises `OptionFault`."""
    if options.fix and options.json and STANDARD in options.scripts:
        raise OptionFault("FS965")
    found: list[Diagnostic] = []
    chosen = settings(options)
    for name in options.scripts:
        try:
            source, world = open_script(name)
        except WorldFailure as fault:
            found.append(diagnose("FS901", None, name=name, reason=fault.args[0]))
            continue
        found += _fix(name, source, world, chosen) if options.fix else _told(source, world, chosen)
    return show_json(found) if options.json else show(found)


def _told(source: Source, world: World, chosen: Settings) -> list[Diagnostic]:
    return in_order(compile_any(source, world, KnownTimes(world), chosen).diagnostics)


def _fix(name: str, source: Source, world: World, chosen: Settings) -> list[Diagnostic]:
    """Makes the fixes of one script, and tells of each; what is left of what was wrong."""
    made = fixed(source, lambda text: _told(text, world, chosen))
    if name == STANDARD:
        sys.stdout.write(made.source.text)
    elif made.done and not is_play(source):
        try:
            write_script(Path(name), made.source.text)
        except OSError as fault:
            reason = fault.strerror or "it cannot be written"
            return [*_told(source, world, chosen), diagnose("FS903", None, path=name, reason=reason)]
    for line in made.done:
        print(f"fixed {line}", file=sys.stderr)
    return made.left
