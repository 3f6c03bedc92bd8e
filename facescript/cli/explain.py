"""`facescript explain`: a script to its solved times, or to who owned a channel at a moment, as text or JSON."""

from __future__ import annotations

import argparse
import json

from facescript.cli.moments import asked, told
from facescript.cli.report import refuse, show
from facescript.cli.script import compile_named
from facescript.schedule.explain import as_objects, as_text, explain
from facescript.schedule.score import Score
from facescript.world import WorldFailure


def run(options: argparse.Namespace) -> int:
    """The table, or the accounts asked for, on standard output; 1 where the script has errors. Raises `OptionFault`."""
    wanted = asked(options)
    try:
        compiled, _ = compile_named(options)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    code = show(compiled.diagnostics, hints=False)
    if compiled.score is not None:
        print(told(compiled.score, wanted, options.json) if wanted else _table(compiled.score, options.json))
    return code


def _table(score: Score, as_json: bool) -> str:
    rows = explain(score)
    return json.dumps(as_objects(rows), ensure_ascii=False, indent=2) if as_json else as_text(rows)
