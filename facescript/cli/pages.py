"""The options `--page` and `--split` to what is wished of a page."""

from __future__ import annotations

import argparse
from pathlib import Path, PurePosixPath

from facescript.backends.page.template import TemplateFault, checked
from facescript.backends.page.wish import TEMPLATES, PageWish
from facescript.cli.report import OptionFault
from facescript.world import LARGEST_SCRIPT, World, WorldFailure, decode


def page_wish(options: argparse.Namespace, world: World, script: str) -> PageWish:
    """What the options ask for of a script with this text; a template of the author's own is read and checked. Raises
    `OptionFault`."""
    name = options.page or TEMPLATES[0]
    if name in TEMPLATES:
        return PageWish(name, split=options.split, script=script)
    try:
        path = _in_project(name, world)
        text = decode(world.read(path, LARGEST_SCRIPT))
        folder = PurePosixPath(path).parent
        return PageWish(name, checked(text, lambda file: world.read(str(folder / file))), options.split, script)
    except WorldFailure as fault:
        raise OptionFault("FS940", name=name, reason=fault.args[0], known=_known()) from None
    except TemplateFault as fault:
        raise OptionFault(fault.code, name=name, **fault.values) from None


def _in_project(name: str, world: World) -> str:
    """A file named on the command line by its path in the project. Raises `WorldFailure`."""
    try:
        return Path(name).absolute().relative_to(world.root.absolute()).as_posix()
    except ValueError:
        raise WorldFailure("it lies outside the project's folder") from None


def _known() -> str:
    return ", ".join(f"`{name}`" for name in TEMPLATES)
