"""A solved round and a moment to the past: what is over by then, and need not be solved again."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from facescript.ir.acts import At, Do, Repeat, Say, WaitUntil
from facescript.ir.acts import Sequence as Block
from facescript.schedule.deeds import Deed
from facescript.schedule.facts import Hold
from facescript.schedule.labels import nodes
from facescript.schedule.round import Begin, Round
from facescript.schedule.steps import DONE, NEVER, SETTLED, START, Begun, Past, Root, Step, ends_in_line
from facescript.schedule.voices import CLOSE

DONE_AT = NEVER, False
"""Stands for a time that nobody asked for."""


@dataclass(slots=True)
class Forgetting:
    """Goes through the trees of a round. Of what began before `time` the `past` keeps what the rest hangs on; `live`
    are the steps that will be solved again (by `id`), `said` from when on the lines among them are."""

    time: float
    past: Past = field(default_factory=Past)
    live: set[int] = field(default_factory=set)
    said: dict[int, float] = field(default_factory=dict)

    def tree(self, root: Root) -> None:
        """What is over of one tree."""
        self._step(root.top, frozenset(_awaited(root.top)))

    def _step(self, step: Step, awaited: frozenset[str]) -> None:
        self.live.add(id(step))
        start = step.times[START]
        if start is not None and start[0] < self.time:
            self.past.starts[step.key()] = start[0]
        if isinstance(step.node, Block):
            self._block(step, awaited)
        elif isinstance(step.node, Repeat):
            self._passes(step, awaited)
        elif isinstance(step.node, Do) and isinstance(step.node.verb, Say):
            self._line(step, step.node.verb, awaited)
        else:
            for child in step.children or ():
                self._step(child, awaited)

    def _over(self, step: Step) -> bool:
        """Whether nothing in a step begins or settles from the time on."""
        done = step.times[DONE] or step.times[SETTLED] or DONE_AT
        return min(done[0], step.limit) < self.time

    def _block(self, step: Step, awaited: frozenset[str]) -> None:
        """The first statements of a block are over; those that others wait for by name can still be asked."""
        asked = [child for child in step.children or () if child.over]
        rest = [child for child in step.children or () if not child.over]
        count = self._leading(rest)
        before = step.begun or Begun(0)
        gone, rest = rest[:count], rest[count:]
        for child in gone:
            if not awaited.isdisjoint(_labels(child)):
                child.over = True
                asked.append(child)
        if asked:
            self.past.awaited[step.key()] = tuple(asked)
        self._begin(step, before, before.first + count, gone)
        for child in rest:
            self._step(child, awaited)

    def _passes(self, step: Step, awaited: frozenset[str]) -> None:
        rest = step.children or []
        count = self._leading(rest)
        before = step.begun or Begun(0, step.time(START))
        self._begin(step, before, before.first + count, rest[:count])
        for child in rest[count:]:
            self._step(child, awaited)

    def _leading(self, steps: Sequence[Step]) -> int:
        """How many of the steps are over before the first that is not."""
        return next((number for number, step in enumerate(steps) if not self._over(step)), len(steps))

    def _begin(self, step: Step, before: Begun, first: int, gone: Sequence[Step]) -> None:
        """Note that so many of the parts of a step are over, of which these are `gone` now."""
        if not first:
            return
        done = max((child.time(DONE if child.times[DONE] else SETTLED) for child in gone), default=before.done)
        moved = [child for child in gone if not isinstance(child.node, At)]
        line = ends_in_line(moved[-1]) if moved else before.line
        self.past.begun[step.key()] = Begun(first, max(done, before.done), line)

    def _line(self, step: Step, say: Say, awaited: frozenset[str]) -> None:
        """A line goes on with the saying that has begun last."""
        begun = [start for start, _ in step.sayings if start < self.time]
        cues = step.children or []
        if begun:
            self.said[id(step)] = self.past.starts[step.key()] = begun[-1]
            before = step.begun or Begun(0)
            first = before.first + len(begun) - 1
            if first:
                self.past.begun[step.key()] = Begun(first)
            cues = [cue for cue in cues if cue.index >= first * len(say.cues)]
        for cue in cues:
            self._step(cue, awaited)


def reactions_over(solved: Round, numbers: Mapping[int, int], forgetting: Forgetting) -> set[int]:
    """The ranks of the reactions that nothing hangs on any more. `numbers` say by the ranks of which of the play's they
    are: one is not forgotten before another run of it that is cut by it."""
    over: set[int] = set()
    kept: set[int] = set()
    for root in solved.reactions:
        holds = [hold for hold in solved.holds().all if hold.rank == root.rank]
        ends = [min(root.top.time(DONE), root.top.limit), *(hold.end for hold in holds)]
        waited = any(_waits(deed, hold, forgetting) for hold in holds for deed in solved.done)
        if max(ends) < forgetting.time and not waited and numbers[root.rank] not in kept:
            over.add(root.rank)
        else:
            kept.add(numbers[root.rank])
    return over


def _waits(deed: Deed, hold: Hold, forgetting: Forgetting) -> bool:
    """Whether a line that is solved again waits for a voice that a reaction has, or was broken off by it."""
    if not isinstance(deed.verb, Say) or id(deed.step) not in forgetting.live or deed.face != hold.face:
        return False
    until = hold.end + hold.gap + CLOSE  # a line that has waited begins then
    return deed.root.rank < hold.rank and forgetting.said.get(id(deed.step), deed.start) < until


def begin_of(solved: Round, time: float) -> Begin:
    """The scene that plays at a time, as the one that all begins with."""
    index = max((i for i, played in enumerate(solved.scenes) if played.root.start <= time), default=0)
    played = solved.scenes[index]
    limit = played.root.top.limit
    return Begin(
        played.scene,
        played.root.start,
        solved.begin.played + index,
        tuple(solved.first.items()),
        limit if limit < time else NEVER,
    )


def _labels(top: Step) -> Iterator[str]:
    """The names in a step."""
    waiting = [top]
    while waiting:
        step = waiting.pop()
        if step.node.label is not None:
            yield step.node.label
        waiting += step.children or ()


def _awaited(top: Step) -> Iterable[str]:
    """The names that statements of a tree wait for."""
    for node, _ in nodes(top.node):
        moment = node.moment if isinstance(node, At) else None
        if isinstance(node, Do) and isinstance(node.verb, WaitUntil):
            moment = node.verb.moment
        if moment is not None and moment.mark is not None:
            yield moment.mark.label
