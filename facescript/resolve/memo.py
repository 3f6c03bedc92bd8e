"""How the parts of a script are worked out: each anew. `memory.py` keeps them for a script that is edited."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from facescript.diagnostics.model import Diagnostics
from facescript.syntax.parser import parse
from facescript.syntax.tree import Script
from facescript.text import Source

if TYPE_CHECKING:
    from facescript.resolve.project import Project

T = TypeVar("T")
U = TypeVar("U")


class Memo:
    """Keeps nothing."""

    def begin(self, project: Project, script: Script) -> None:
        """A script is about to be resolved in a project that knows nothing yet."""

    def table(self, project: Project, name: str) -> dict[str, Any]:
        """A further table by names that parts may ask."""
        return {}

    def settle(self, *tables: dict[str, Any]) -> None:
        """These tables of the project are complete."""

    def file(self, project: Project, name: str) -> None:
        """A part is about to ask for a file of the project."""

    def forget(self) -> None:
        """The work was given up."""

    def parse(self, source: Source, diagnostics: Diagnostics) -> Script:
        """The tree of a script that another one uses."""
        return parse(source, diagnostics)

    def follow(self, nodes: Sequence[T], work: Callable[[T], Iterable[U]]) -> list[U]:
        """What follows from each node alone, in one row."""
        return [each for node in nodes for each in work(node)]

    def part(self, project: Project, kind: str, node: object, given: object, work: Callable[[], T]) -> T:
        """What a part comes to. `given` is what it is worked out from besides its node and what it asks the tables of
        the project."""
        return work()

    def parts(
        self,
        project: Project,
        kind: str,
        nodes: Sequence[T],
        given: object,
        work: Callable[[T], U],
        counts: dict[str, int],
    ) -> list[U]:
        """What many parts come to, one after the other; `counts` are numbers that they go on counting."""
        return [work(node) for node in nodes]

    def once(self, project: Project, key: tuple[object, ...], node: object, work: Callable[[], T]) -> T:
        """What several parts lean on: it is worked out for the first of them, and what is wrong with it is told there.

        It must not depend on who leans on it but for `node`.
        """
        if key not in project.done:
            project.done[key] = work()
        found: T = project.done[key]
        return found
