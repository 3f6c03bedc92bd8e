"""`facescript plot`: a script to a picture of what is done when, over the curves of what moves."""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path

from facescript.backends.job import Job, JobFailure
from facescript.backends.output import outputs
from facescript.cli.outputs import no_kind, put, suffix_of, targets
from facescript.cli.project import STANDARD
from facescript.cli.report import FAULTS, OptionFault, refuse, show
from facescript.cli.script import compile_named
from facescript.cli.settings import size, stretch
from facescript.plot.channels import PlotFault
from facescript.plot.marks import Drawing
from facescript.plot.picture import Asked, draw
from facescript.plot.png import lacking, write_png
from facescript.plot.svg import write_svg
from facescript.world import WorldFailure

WRITERS = {".svg": write_svg, ".png": write_png}


def run(options: argparse.Namespace) -> int:
    """0 made, 1 faults (nothing is written then). Raises `OptionFault`."""
    wanted = [(target, _suffix(target, options.kind)) for target in targets(options, ".plot.svg")]
    name = "standard input" if options.script == STANDARD else Path(options.script).name
    asked = Asked(name, _names(options.channels), size(options.plot_size) if options.plot_size else None)
    try:
        compiled, world = compile_named(options)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    code = show(compiled.diagnostics, hints=False)
    if compiled.score is None or compiled.play is None:
        return code or FAULTS
    job = Job(compiled.play, compiled.score, world.read, *stretch(options, compiled.score.duration))
    try:
        return _write(draw(job, asked), wanted)
    except PlotFault as fault:
        raise OptionFault(fault.code, **fault.values) from None


def _suffix(target: str, kind: str | None) -> str:
    suffix = suffix_of(target, kind)
    if suffix not in WRITERS:
        raise no_kind(target, suffix, WRITERS)
    return suffix


def _names(text: str | None) -> tuple[str, ...]:
    """The channels of `--channels`."""
    if text is None:
        return ()
    names = tuple(name.strip() for name in text.split(","))
    if not all(names):
        raise OptionFault("FS904", option="--channels", value=text, example="head.yaw,lid.left")
    return names


def _write(drawing: Drawing, wanted: list[tuple[str, str]]) -> int:
    target = ""
    try:
        with outputs() as batch:
            for target, suffix in wanted:
                put(target, suffix, batch, partial(WRITERS[suffix], drawing))
    except JobFailure as fault:
        return refuse("FS907", path=target, reason=fault.args[0])
    except OSError as fault:
        return refuse("FS903", path=target, reason=fault.strerror or "it cannot be written")
    for target, suffix in wanted:
        letters = lacking(drawing) if suffix == ".png" else ""
        if letters:
            refuse("FS924", path=target, letters=_listed(letters))
    return 0


def _listed(letters: str, most: int = 5) -> str:
    more = f" and {len(letters) - most} more letters" if len(letters) > most else ""
    return ", ".join(f"“{letter}”" for letter in letters[:most]) + more
