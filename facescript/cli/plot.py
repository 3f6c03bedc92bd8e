"""`facescript plot`: a script to a picture of what is done when, over the curves of what moves."""

from __future__ import annotations

import argparse
from pathlib import Path

from facescript.backends.job import Job
from facescript.cli.drawings import wanted, write
from facescript.cli.report import FAULTS, OptionFault, refuse, show
from facescript.cli.script import compile_named
from facescript.cli.settings import size, stretch
from facescript.plot.channels import PlotFault
from facescript.plot.picture import Asked, draw
from facescript.plot.png import write_png
from facescript.plot.svg import write_svg
from facescript.project import STANDARD
from facescript.world import WorldFailure

WRITERS = {".svg": write_svg, ".png": write_png}


def run(options: argparse.Namespace) -> int:
    """0 made, 1 faults (nothing is written then). Raises `OptionFault`."""
    outs = wanted(options, ".plot.svg", WRITERS)
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
        drawing = draw(job, asked)
    except PlotFault as fault:
        raise OptionFault(fault.code, **fault.values) from None
    return write(drawing, drawing, outs, WRITERS)


def _names(text: str | None) -> tuple[str, ...]:
    """The channels of `--channels`."""
    if text is None:
        return ()
    names = tuple(name.strip() for name in text.split(","))
    if not all(names):
        raise OptionFault("FS904", option="--channels", value=text, example="head.yaw,lid.left")
    return names
