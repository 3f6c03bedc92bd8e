"""`facescript explain`: a script to its solved times, as text or JSON."""

from __future__ import annotations

import argparse
import json

from facescript.cli.report import refuse, show
from facescript.cli.script import compile_named
from facescript.schedule.explain import as_objects, as_text, explain
from facescript.world import WorldFailure


def run(options: argparse.Namespace) -> int:
    """The table on standard output; 1 where the script has errors. Raises `OptionFault`."""
    try:
        compiled, _ = compile_named(options)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    code = show(compiled.diagnostics, hints=False)
    if compiled.score is not None:
        rows = explain(compiled.score)
        print(json.dumps(as_objects(rows), ensure_ascii=False, indent=2) if options.json else as_text(rows))
    return code
