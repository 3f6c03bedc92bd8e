"""`facescript sheet`: a kind of face, or the faces of a script, to a picture of all that they can show."""

from __future__ import annotations

import argparse
from pathlib import Path

from facescript.cli.drawings import wanted, write
from facescript.cli.report import FAULTS, OptionFault, refuse, show
from facescript.cli.settings import count
from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Face
from facescript.project import STANDARD, open_script
from facescript.resolve.expressions import Expression, expressions
from facescript.resolve.faces import ONLY
from facescript.resolve.kinds.library import kind_names
from facescript.resolve.resolver import resolve
from facescript.resolve.suggest import nearest
from facescript.sheet.cells import sections
from facescript.sheet.html import write_html
from facescript.sheet.page import BIGGEST, CELL, SMALLEST, Page, SheetFault, lay_out
from facescript.sheet.png import write_png
from facescript.sheet.svg import write_svg
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World, WorldFailure

WRITERS = {".png": write_png, ".svg": write_svg, ".html": write_html}


def run(options: argparse.Namespace) -> int:
    """0 made, 1 faults (nothing is written then). Raises `OptionFault`."""
    outs = wanted(options, ".sheet.png", WRITERS)
    side = _side(options.cell)
    try:
        source, world = _opened(options.script)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    diagnostics = Diagnostics()
    script = parse(source, diagnostics)
    play = resolve(script, world, diagnostics)
    code = show(diagnostics, hints=False)
    if play is None:
        return code or FAULTS
    page = _page(options, source, play.faces, expressions(script, world), side)
    return write(page, page.drawing, outs, WRITERS)


def _page(
    options: argparse.Namespace, source: Source, faces: tuple[Face, ...], known: tuple[Expression, ...], side: int
) -> Page:
    """The page, and what is said of expressions that are not on it. Raises `OptionFault`."""
    try:
        page = lay_out(Path(source.name).name, _chosen(options, faces), sections(known, options.units), side)
    except SheetFault as fault:
        raise OptionFault(fault.code, **fault.values) from None
    for each in known:
        if each.drivers is None:
            refuse("FS935", name=each.name)
    return page


def _side(text: str | None) -> int:
    side = CELL if text is None else count("--cell", text, str(CELL))
    if not SMALLEST <= side <= BIGGEST:
        raise OptionFault("FS934", side=side, least=SMALLEST, most=BIGGEST)
    return side


def _opened(name: str) -> tuple[Source, World]:
    """The script, or one with a single face of the kind named. Raises `WorldFailure`, `OptionFault`."""
    if name in kind_names():
        return Source(name, f"face {ONLY} = {name}\n"), World(Path.cwd())
    if name == STANDARD or Path(name).suffix or Path(name).exists():
        return open_script(name)
    near = nearest(name, kind_names())
    meant = f"did you mean `{near}`?" if near else f"there is {', '.join(f'`{kind}`' for kind in kind_names())}."
    raise OptionFault("FS930", name=name, meant=meant)


def _chosen(options: argparse.Namespace, faces: tuple[Face, ...]) -> list[Face]:
    """The faces that are seen, or those of them that `--face` asks for, in the script's order."""
    seen = [face for face in faces if face.seen]
    if not seen:
        raise OptionFault("FS932", name=options.script)
    names = [face.name for face in seen]
    for name in options.face:
        if name not in names:
            raise OptionFault("FS931", name=name, known=", ".join(f"`{each}`" for each in names))
    return [face for face in seen if not options.face or face.name in options.face]
