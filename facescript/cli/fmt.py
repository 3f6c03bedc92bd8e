"""`facescript fmt`: scripts to the one layout, in place; a script that cannot be parsed stays as it is.

With `-o` the result goes elsewhere; that is how a play in JSON becomes a script.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from facescript.backends.output import write_whole
from facescript.cli.report import FAULTS, OptionFault, refuse, show
from facescript.diagnostics.model import Diagnostics
from facescript.project import STANDARD, is_play, open_script
from facescript.syntax.formatter import format_source
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World, WorldFailure


def run(options: argparse.Namespace) -> int:
    """0 done; 1 where a script has faults or, with --check, is not in the layout."""
    if options.output and (options.check or len(options.scripts) > 1):
        raise OptionFault("FS964", reason="`-o` goes with one script, and without `--check`")
    return max(_format(name, options.check, options.output) for name in options.scripts)


def _format(name: str, check: bool, output: str | None) -> int:
    try:
        source, world = open_script(name)
    except WorldFailure as fault:
        return refuse("FS901", name=name, reason=fault.args[0])
    if is_play(source):
        return _script(name, source, world, output)
    diagnostics = Diagnostics()
    parse(source, diagnostics)
    if diagnostics.failed:
        show(diagnostics)
        return FAULTS
    if output is not None:
        return _write(output, format_source(source))
    return _put(name, source, format_source(source), check)


def _script(name: str, source: Source, world: World, output: str | None) -> int:
    """The script of a play. Raises `OptionFault` where it is not said where to."""
    from facescript.plays import renaming, script_of  # pydantic: only plays pay it

    if output is None:
        raise OptionFault("FS964", reason=f"a play is no script; `facescript fmt {name} -o SCRIPT` writes one")
    diagnostics = Diagnostics()
    target = "script.face" if output == STANDARD else _inside(output, world)
    found = script_of(source, world, target, diagnostics)
    renamed = renaming(found.written) if found is not None else None
    if renamed is not None:
        diagnostics.add(renamed)
    code = show(diagnostics, hints=False)
    return code if found is None else _write(output, format_source(Source(target, found.written.text)))


def _inside(output: str, world: World) -> str:
    """The path of an output in the project; its name where it lies outside."""
    path, root = Path(output).absolute(), world.root.resolve()
    folder = path.parent.resolve()
    return (folder / path.name).relative_to(root).as_posix() if folder.is_relative_to(root) else path.name


def _put(name: str, source: Source, text: str, check: bool) -> int:
    if name == STANDARD:
        return _write(name, text)
    if text == source.text:
        return 0
    if check:
        print(f"{name}: not in the layout; `facescript fmt {name}` puts it there", file=sys.stderr)
        return FAULTS
    return _write(name, text)


def _write(name: str, text: str) -> int:
    if name == STANDARD:
        sys.stdout.write(text)
        return 0
    try:
        write_whole(Path(name), lambda path: path.write_text(text, "utf-8", newline="\n"))
    except OSError as fault:
        return refuse("FS903", path=name, reason=fault.strerror or "it cannot be written")
    return 0
