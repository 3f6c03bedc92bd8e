"""A script that has no faults to the expressions it may show: its own and the library's, each with what it drives."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass

from facescript.diagnostics.model import Diagnostics
from facescript.ir.values import Driver
from facescript.resolve.definitions import library_names
from facescript.resolve.mixes import expression_drivers
from facescript.resolve.names import Definition
from facescript.resolve.project import Project, Refused
from facescript.resolve.resolver import define
from facescript.resolve.uses import library
from facescript.resolve.words import UNIT_NAME
from facescript.syntax.tree import Script
from facescript.world import World


@dataclass(frozen=True, slots=True)
class Expression:
    """What `show NAME` drives at 100 %; `own` is whether an author wrote it, `unit` whether it is one of FACS.
    `drivers` are None where it needs a value for a parameter first."""

    name: str
    own: bool
    unit: bool
    drivers: tuple[Driver, ...] | None


def expressions(script: Script, world: World) -> tuple[Expression, ...]:
    """All expressions by name: the author's in the order written, then the library's that they do not cover."""
    project = Project(world, Diagnostics(), library_names(library(world)))
    define(project, script)
    found = project.names.all("expression")
    return tuple(
        Expression(each.name, not each.library, UNIT_NAME.fullmatch(each.name) is not None, _drivers(project, each))
        for each in found
    )


def _drivers(project: Project, definition: Definition) -> tuple[Driver, ...] | None:
    with suppress(Refused):
        return expression_drivers(project, definition, "", definition.span)
    return None
