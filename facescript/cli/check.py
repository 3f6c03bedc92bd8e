"""`facescript check`: scripts to what is wrong with them. Starts no voice and loads no numpy."""

from __future__ import annotations

import argparse

from facescript.cli.report import show, show_json
from facescript.cli.settings import settings
from facescript.compile import compile_source
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic
from facescript.project import open_script
from facescript.speech.voices.known import KnownTimes
from facescript.world import WorldFailure


def run(options: argparse.Namespace) -> int:
    """0 clean (warnings allowed), 1 errors. Raises `OptionFault`."""
    found: list[Diagnostic] = []
    chosen = settings(options)
    for name in options.scripts:
        try:
            source, world = open_script(name)
        except WorldFailure as fault:
            found.append(diagnose("FS901", None, name=name, reason=fault.args[0]))
            continue
        found.extend(compile_source(source, world, KnownTimes(world), chosen).diagnostics)
    return show_json(found) if options.json else show(found)
