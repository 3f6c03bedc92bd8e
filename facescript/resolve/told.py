"""Statements that are told to a script while it runs, by its names, to reactions of their own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import EventPattern, Play, Reaction
from facescript.resolve.events import reacting
from facescript.resolve.marks import check_marks
from facescript.resolve.memo import Memo
from facescript.resolve.notes import Notes
from facescript.resolve.project import Project, Refused, TooMuch
from facescript.resolve.resolver import NOTHING, begun, play_of
from facescript.syntax import tree
from facescript.syntax.parser import parse
from facescript.text import Source, Span
from facescript.world import World

TOLD, HUSHED = "told", "hushed"
"""The kinds of event that statements come by, and that ends what a face was told to say."""

LONGEST, MOST = 4_000, 200
"""Characters, and statements once its actions are unfolded, of what is told at once."""

STATEMENTS = (tree.Act, tree.Cast, tree.Group, tree.Repeat, tree.Moment)


class OwnFiles(Memo):
    """The files that a script names itself; what is told to it names no others."""

    def __init__(self) -> None:
        self._names: set[str] = set()
        self.told: Span | None = None

    def file(self, project: Project, name: str) -> None:
        if self.told is None:
            self._names.add(name)
        elif name not in self._names:
            raise project.refuse("FS990", self.told, path=name)


class Prompter:
    """Resolves what is told to a script. `play` is that of the script, None where an error stands in the way.

    What was told before is not known to what is told later: each has names of its own.
    """

    def __init__(
        self, script: tree.Script, world: World, diagnostics: Diagnostics, overrides: Mapping[str, str] = NOTHING
    ) -> None:
        self._files = OwnFiles()
        self._project = begun(script, world, diagnostics, self._files)
        self.play: Play | None = play_of(self._project, script, overrides)

    def reaction(self, text: str, diagnostics: Diagnostics) -> Reaction | None:
        """The reaction that statements are, their faces being all of the script; None where `diagnostics` say what is
        wrong with them."""
        source = Source("told", text)
        whole = Span(source, 0, len(text))
        if len(text) > LONGEST:
            diagnostics.add(diagnose("FS992", Span(source, LONGEST, len(text)), longest=LONGEST))
            return None
        items = parse(source, diagnostics).items
        block = tuple(item for item in items if isinstance(item, STATEMENTS))
        for item in items:
            if not isinstance(item, STATEMENTS):
                diagnostics.add(diagnose("FS991", item.span))
        found = None if diagnostics.failed else self._resolved(block, whole, diagnostics)
        return None if diagnostics.failed else found

    def _resolved(self, block: tuple[tree.Statement, ...], whole: Span, diagnostics: Diagnostics) -> Reaction | None:
        project = self._afresh(diagnostics)
        self._files.told = whole
        try:
            found = reacting(project, EventPattern(TOLD, whole.text), block, whole, tuple(project.faces), "told.")
            check_marks(project)
            return found
        except Refused:
            return None
        except TooMuch as fault:
            span, most, what = fault.args
            diagnostics.add(diagnose("FS322", span, most=most, what=what))
            return None
        finally:
            self._files.told = None

    def _afresh(self, diagnostics: Diagnostics) -> Project:
        """The script's names, and nothing of what was counted or told before."""
        return replace(
            self._project,
            diagnostics=diagnostics,
            notes=Notes(),
            most=MOST,
            weight=0,
            stood_for=0,
            depth=0,
            deepest=0,
            lines={},
            marks=[],
            open=[],
            cells=[],
            circled=set(),
            refused=set(),
            done=dict(self._project.done),
        )
