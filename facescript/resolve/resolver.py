"""Turns a script's tree into a play: names, units, defaults and the library resolved, faults reported."""

from __future__ import annotations

from collections.abc import Mapping

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Play
from facescript.syntax.tree import Script
from facescript.world import World

NOTHING: Mapping[str, str] = {}


def resolve(
    script: Script, world: World, diagnostics: Diagnostics, overrides: Mapping[str, str] = NOTHING
) -> Play | None:
    """The play of a script, or None where something in it is an error (then `diagnostics` says what).

    `overrides` are values of `let`s by name, as text of the language (`--set NAME=VALUE`).
    """
    return None
