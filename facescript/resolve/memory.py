"""Keeps what the parts of a script that is edited come to, as long as all that they asked is answered as before.

A part is a statement at the top or of a scene, a scene, a reaction or a definition. It is kept by its node, the same
object as long as its lines stay as they are (`syntax/pieces.py`). While a part is worked out its `Notes` are taken. In
the next state of the script it is taken over if no table has another answer for a name that it asked for, and if the
state of the work (what is told, counted and open) lets it come to the same. Then what it did to the project is done
again. What a state of the script does not come to is let go.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any, TypeVar

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Say
from facescript.ir.values import Mark
from facescript.resolve.answers import Answers
from facescript.resolve.memo import Memo
from facescript.resolve.notes import Lean, Notes, Told
from facescript.resolve.project import DEEPEST, MANY, MOST_WORDS, Project, Refused
from facescript.syntax.pieces import Pieces
from facescript.syntax.tree import Script
from facescript.text import Source, Span

T = TypeVar("T")
U = TypeVar("U")
Ids = tuple[int, ...]
Key = tuple[object, int | Ids]
"""Of a part: its kind, or what it is to those who lean on it, and its node; a run of parts is one too."""

Followed = tuple[object, list[Any]]

RUN = 31
"""Parts of a usual run. Runs begin at nodes of certain numbers, so that an edit changes the run that it is in."""


@dataclass(frozen=True, slots=True)
class Kept:
    """What a part came to and what it did: names that it `used`, labels to `lines`, `marks`, how it counted (name,
    count before, count behind).

    `weight` and `words` are what it cost but for what it leans on; `faults` are told at most, `height` is how deep it
    goes. `inner` are the parts inside it.
    """

    node: object
    given: object
    value: Any
    notes: Notes
    used: set[str]
    lines: dict[str, Say | None]
    marks: list[tuple[Mark, Span]]
    counts: list[tuple[str, int, int]]
    weight: int
    words: int
    faults: int
    height: int
    inner: dict[Key, Kept]


@dataclass(frozen=True, slots=True)
class Before:
    """The state of the work before a part."""

    notes: Notes
    used: set[str]
    lines: dict[str, Say | None]
    marks: int
    counts: dict[str, int]
    weight: int
    words: int
    circled: int
    deepest: int


class Memory(Memo):
    """Serves one script, a state of it after the other."""

    def __init__(self) -> None:
        self._whole: tuple[object, ...] = ()
        self.forget()

    def forget(self) -> None:
        self._answers = Answers()
        self._kept: tuple[dict[Key, Kept], dict[Key, Kept]] = {}, {}
        self._followed: tuple[dict[Ids, Followed], dict[Ids, Followed]] = {}, {}
        self._used: tuple[dict[str, Pieces], dict[str, Pieces]] = {}, {}
        self._depth = 0

    def begin(self, project: Project, script: Script) -> None:
        whole = project.world.root, script.source.name, *(each.node for each in project.names.library.values())
        if len(whole) != len(self._whole) or any(map(_differ, whole, self._whole)):
            self.forget()
        self._whole = whole
        self._kept, self._followed = (self._kept[1], {}), (self._followed[1], {})
        self._used = self._used[1], {}
        self._answers.begin(project)

    def table(self, project: Project, name: str) -> dict[str, Any]:
        return self._answers.table(project, name, {})

    def settle(self, *tables: dict[str, Any]) -> None:
        for table in tables:
            self._answers.settle(table)

    def file(self, project: Project, name: str) -> None:
        self._answers.file(project, name)

    def parse(self, source: Source, diagnostics: Diagnostics) -> Script:
        pieces = self._used[1][source.name] = self._used[0].get(source.name) or Pieces()
        return pieces.parse(source, diagnostics)

    def follow(self, nodes: Sequence[T], work: Callable[[T], Iterable[U]]) -> list[U]:
        found: list[U] = []
        for run in _runs(nodes):
            key = tuple(map(id, run))
            known = self._followed[0].get(key) or (run, [each for node in run for each in work(node)])
            self._followed[1][key] = known
            found += known[1]
        return found

    # -------------------------------------------------------------------------------------------- parts

    def part(self, project: Project, kind: str, node: object, given: object, work: Callable[[], T]) -> T:
        return self._part(project, (kind, id(node)), node, given, work, {})

    def parts(
        self,
        project: Project,
        kind: str,
        nodes: Sequence[T],
        given: object,
        work: Callable[[T], U],
        counts: dict[str, int],
    ) -> list[U]:
        found: list[U] = []
        for run in _runs(nodes):
            made = partial(self._run, project, kind, run, given, work, counts)
            take = self._inner if self._depth else self._part
            found += take(project, (kind, tuple(map(id, run))), run, given, made, counts)
        return found

    def _run(
        self,
        project: Project,
        kind: str,
        run: tuple[T, ...],
        given: object,
        work: Callable[[T], U],
        counts: dict[str, int],
    ) -> list[U]:
        """Parts of a run."""
        return [self._inner(project, (kind, id(node)), node, given, partial(work, node), counts) for node in run]

    def _inner(
        self, project: Project, key: Key, node: object, given: object, work: Callable[[], T], counts: dict[str, int]
    ) -> T:
        """A part inside another one, which takes its notes for its own."""
        before, notes = project.stood_for, project.notes
        value = self._part(project, key, node, given, work, counts)
        known = self._kept[1].get(key)
        if known is None:
            notes.passing = True
        else:
            notes.parts.append(key)
            notes.absorb(known.notes)
            notes.inside += project.stood_for - before - known.words - known.notes.inside
        return value

    def _part(
        self, project: Project, key: Key, node: object, given: object, work: Callable[[], T], counts: dict[str, int]
    ) -> T:
        known = self._kept[0].get(key)
        if known is None or known.given != given or not self._holds(project, known, counts):
            return self._anew(project, key, node, given, work, counts)
        self._again(project, key, known, counts)
        value: T = known.value
        return value

    def once(self, project: Project, key: tuple[object, ...], node: object, work: Callable[[], T]) -> T:
        if key not in project.done:
            project.done[key] = self._once(project, (key, id(node)), node, work)
        found: T = project.done[key]
        project.notes.told.append(Lean(key, node, found))
        return found

    def _once(self, project: Project, key: Key, node: object, work: Callable[[], T]) -> T:
        if project.cells:  # what is wrong with it is told of the cell
            project.notes.passing = True
            return work()
        before, known = project.stood_for, self._kept[0].get(key)
        if known is not None and self._holds(project, known, {}):
            self._again(project, key, known, {})
            value: T = known.value
        else:
            value = self._anew(project, key, node, None, work, {})
        project.notes.inside += project.stood_for - before
        return value

    # -------------------------------------------------------------------------------------------- anew

    def _anew(
        self, project: Project, key: Key, node: object, given: object, work: Callable[[], T], counts: dict[str, int]
    ) -> T:
        before = _taken(project, counts)
        self._depth += 1
        try:
            value = work()
        except Refused:
            before.notes.absorb(project.notes)
            raise
        else:
            if _may_be_kept(project, before):
                self._kept[1][key] = self._made(project, before, node, given, value, counts)
            return value
        finally:
            before.lines.update(project.lines)
            before.used.update(project.names.used)
            project.notes, project.lines, project.names.used = before.notes, before.lines, before.used
            project.deepest = max(before.deepest, project.deepest)
            self._depth -= 1

    def _made(
        self, project: Project, before: Before, node: object, given: object, value: Any, counts: dict[str, int]
    ) -> Kept:
        notes = project.notes
        notes.told = _first(notes.told)
        leans = [self._kept[1].get((each.key, id(each.node))) for each in notes.told if isinstance(each, Lean)]
        return Kept(
            node,
            given,
            value,
            notes,
            project.names.used,
            project.lines,
            project.marks[before.marks :],
            [(name, before.counts.get(name, 0), count) for name, count in counts.items()],
            project.weight - before.weight,
            project.stood_for - before.words - notes.inside,
            len(notes.told) + sum(each.faults for each in leans if each is not None),
            project.deepest - project.depth,
            self._within(notes.parts),
        )

    def _within(self, keys: list[Key]) -> dict[Key, Kept]:
        """Parts inside a part, and those inside them."""
        found: dict[Key, Kept] = {}
        for key in keys:
            if (known := self._kept[1].get(key)) is not None:
                found |= {key: known, **known.inner}
        return found

    # -------------------------------------------------------------------------------------------- again

    def _holds(self, project: Project, known: Kept, counts: dict[str, int]) -> bool:
        """Whether the part would come to the same."""
        if known.notes.labelled and any(counts.get(name, 0) != before for name, before, _ in known.counts):
            return False
        words = self._words(project, known)
        return words is not None and project.stood_for + words <= MOST_WORDS

    def _words(self, project: Project, known: Kept) -> int | None:
        """The words that names stand for in a part and what it leans on; None where it may come to something else."""
        notes = known.notes
        if not self._answers.hold(notes.asked) or not _fits(project, known):
            return None
        total = known.words
        for lean in notes.told:
            if isinstance(lean, Lean):
                words = self._leant(project, lean)
                if words is None:
                    return None
                total += words
        return total

    def _leant(self, project: Project, lean: Lean) -> int | None:
        if lean.key in project.done:
            return 0 if project.done[lean.key] == lean.value else None
        known = self._kept[0].get((lean.key, id(lean.node)))
        return None if known is None or known.value != lean.value else self._words(project, known)

    def _again(self, project: Project, key: Key, known: Kept, counts: dict[str, int]) -> None:
        """Do to the project what the part did."""
        self._kept[1][key] = known
        self._kept[1].update(known.inner)
        if known.notes.filed:
            self._answers.files(known.notes.asked)
        for told in known.notes.told:
            if not isinstance(told, Lean):
                project.tell(told)
            elif told.key not in project.done:
                leant = told.key, id(told.node)
                self._again(project, leant, self._kept[0][leant], {})
                project.done[told.key] = told.value
        project.names.used |= known.used
        for name, before, after in known.counts:
            counts[name] = counts.get(name, 0) + after - before
        project.lines.update(known.lines)
        project.marks += known.marks
        project.weight += known.weight
        project.stood_for += known.words
        project.deepest = max(project.deepest, project.depth + known.height)


def _taken(project: Project, counts: dict[str, int]) -> Before:
    """The state of the work; new notes are begun."""
    before = Before(
        project.notes,
        project.names.used,
        project.lines,
        len(project.marks),
        dict(counts),
        project.weight,
        project.stood_for,
        len(project.circled),
        project.deepest,
    )
    project.notes, project.names.used, project.lines = Notes(), set(), {}
    project.deepest = project.depth
    return before


def _first(told: list[Told | Lean]) -> list[Told | Lean]:
    """What was told, and each thing that is leant on where that was done first."""
    found: dict[object, Told | Lean] = {}
    for each in told:
        found.setdefault(id(each) if isinstance(each, Told) else each.key, each)
    return list(found.values())


def _may_be_kept(project: Project, before: Before) -> bool:
    """Whether a part is all that its notes say: not where circles are found, or where so much is wrong that it is not
    sought any more what was meant."""
    notes = project.notes
    circled = len(project.circled) > before.circled or not notes.entered.isdisjoint(project.circled)
    return not (notes.passing or circled or (notes.guessed and len(project.diagnostics.items) >= MANY // 2))


def _fits(project: Project, known: Kept) -> bool:
    """Whether the state of the work lets a part come to the same."""
    notes = known.notes
    return (
        project.weight + known.weight <= project.most
        and project.depth + known.height <= DEEPEST
        and (not notes.guessed or len(project.diagnostics.items) + known.faults < MANY // 2)
        and notes.entered.isdisjoint(project.circled)
        and (not project.open or notes.entered.isdisjoint(each.name for each in project.open))
        and all(question(project, span) == answer for question, span, answer in notes.seen)
    )


def _differ(first: object, second: object) -> bool:
    return first is not second and first != second


def _runs(nodes: Sequence[T]) -> list[tuple[T, ...]]:
    """Nodes in a row, cut before each with a certain number."""
    cuts = [index for index, node in enumerate(nodes) if id(node) // 16 % RUN == 0]
    return [tuple(nodes[first:last]) for first, last in pairwise((0, *cuts, len(nodes))) if first < last]
