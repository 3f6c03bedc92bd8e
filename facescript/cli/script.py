"""A command's options to a compiled script, spoken by the real voice."""

from __future__ import annotations

import argparse

from facescript.cli.settings import settings
from facescript.compile import Compiled
from facescript.project import compile_any, open_script
from facescript.speech.studio import open_studio
from facescript.world import World


def compile_named(options: argparse.Namespace) -> tuple[Compiled, World]:
    """The script `options.script` as far as its score. Raises `WorldFailure`, `OptionFault`."""
    chosen = settings(options)
    source, world = open_script(options.script)
    return compile_any(source, world, open_studio(world), chosen), world
