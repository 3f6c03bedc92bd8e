"""The play's statements as they are played: one step for each time a statement is done, made when it is needed."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field

from facescript.ir.acts import At, Choose, Do, Gesture, Node, Repeat, Say, Sequence, Together, Verb
from facescript.ir.random import chance

START, SETTLED, DONE = range(3)
"""What is asked of a step: when it starts, when the next may, and when all in it (what stands beside it too) has."""

NEVER = float("inf")

AHEAD = 256
"""Of a block of a play that goes on so many statements are looked ahead."""

Time = tuple[float, bool]
"""Seconds from the film's start, and whether the duration of a line that was only estimated is in it."""

Key = tuple[int, ...]
"""A step's place in the tree of steps: the same in every round of the solution, in the order written."""


@dataclass(frozen=True, slots=True)
class Begun:
    """A block, a `repeat` or a line of which the `first` so many statements, passes or sayings are over: when the last
    of them was `done`, and whether it was a `line` that moved the sequence on last."""

    first: int
    done: float = 0.0
    line: bool = False


@dataclass(slots=True)
class Past:
    """What is over of a play that goes on, and is not solved again: the blocks that have `begun`, the `starts` of the
    steps that have, how long `looks` take, and the steps that are `awaited` by name, by the block they stand in; all by
    the steps' keys. `voiced` says since when a reaction (its rank) has a face's voice, and how long it waited for it.
    """

    begun: dict[Key, Begun] = field(default_factory=dict)
    starts: dict[Key, float] = field(default_factory=dict)
    looks: dict[Key, float] = field(default_factory=dict)
    awaited: dict[Key, tuple[Step, ...]] = field(default_factory=dict)
    voiced: dict[tuple[int, str], tuple[float, float]] = field(default_factory=dict)

    def resume(self, step: Step) -> None:
        """A step that is made goes on from where it is."""
        key = step.key()
        step.begun = self.begun.get(key)
        start = self.starts.get(key)
        if start is not None:
            step.times[START] = (start, False)


class TooMany(Exception):
    """More steps than a script may have; `step` is one too many."""

    def __init__(self, step: Step) -> None:
        self.step = step


@dataclass(slots=True)
class Maker:
    """What every step is made with: the seed, how many more may be made, what is over already, and the names the seed
    knows them by."""

    seed: int
    left: int
    past: Past | None = None
    _names: dict[int, tuple[str, ...]] = field(default_factory=dict)

    def take(self, step: Step, count: int = 1) -> None:
        """Count a step, and the stops of a scan. Raises `TooMany`."""
        self.left -= count
        if self.left < 0:
            raise TooMany(step)

    def names(self, block: Sequence | Together | Choose) -> tuple[str, ...]:
        """The names of the statements of a block: the label, else what it is; and how many such stand before it."""
        known = self._names.get(id(block))
        if known is None:
            known = self._names[id(block)] = names_of(block.items)
        return known

    def call(self, block: Sequence, names: tuple[str, ...]) -> None:
        """Say how the seed knows the statements of a block that is a part of a longer one."""
        self._names[id(block)] = names


@dataclass(slots=True, eq=False)
class Root:
    """What a tree of steps is of: a run of a scene, or a reaction to an event.

    `rank` orders them (a reaction is "as if written later"), `place` names it to the seed, `start` is from the film's
    start. `persons` are those that the event brought; a reaction that is `afresh` is cut because its event came again.
    What is solved of a scene may begin `after_line`.
    """

    rank: int
    place: tuple[Hashable, ...]
    start: float
    maker: Maker
    reaction: bool = False
    persons: tuple[tuple[str, str], ...] = ()
    afresh: bool = False
    scene: int = 0
    after_line: bool = False
    top: Step = field(init=False)

    def plant(self, body: Sequence, limit: float, rough: bool = False, index: int = 0) -> Step:
        """The step of the whole block; `index` tells the runs of scenes apart."""
        self.top = Step(body, self, None, index, limit)
        self.top.times[START] = (self.start, rough)
        return self.top


@dataclass(slots=True, eq=False)
class Step:
    """One statement, once. `times` are START, SETTLED and DONE as far as they are known.

    `before` is the step it follows in its sequence; `limit` is when it is cut (a `repeat for`, the film's end, a scene
    that is stopped): nothing starts from there on. `until` is the end of the inline cue it belongs to. What is in a
    `quiet` step may be cut without a word. `sayings` are the starts and cuts of a line: the last is whole.
    A step that is under way may have `begun`; one that is `over` is there only to be asked for its times; one that
    `goes_on` has more statements than were made.
    """

    node: Node
    root: Root
    parent: Step | None
    index: int
    limit: float
    before: Step | None = None
    until: float = NEVER
    passes: tuple[int, ...] = ()
    clock: Step | None = None
    quiet: bool = False
    children: list[Step] | None = None
    times: list[Time | None] = field(default_factory=lambda: [None, None, None])
    verb: Verb | None = None
    sayings: tuple[tuple[float, float | None], ...] = ()
    begun: Begun | None = None
    over: bool = False
    goes_on: bool = False

    def __post_init__(self) -> None:
        maker = self.root.maker
        maker.take(self)
        if maker.past is not None:
            maker.past.resume(self)

    def time(self, edge: int) -> float:
        """A time that is solved; NEVER where nobody ever asked for it."""
        known = self.times[edge]
        return NEVER if known is None else known[0]

    def rough(self, edge: int) -> bool:
        """Whether a solved time rests on an estimate."""
        known = self.times[edge]
        return known is not None and known[1]

    @property
    def hushed(self) -> bool:
        """Whether it may be left out without a word, with what it stands in."""
        step: Step | None = self
        while step is not None and not step.quiet:
            step = step.parent
        return step is not None

    def child(self, node: Node, index: int, before: Step | None = None) -> Step:
        """A step inside this one."""
        clock = self if isinstance(self.node, Sequence) and (self.node.clock or self.parent is None) else self.clock
        return Step(node, self.root, self, index, self.limit, before, self.until, self.passes, clock)

    def inside(self) -> list[Step]:
        """The steps inside it; those of a repeat and of a line are made as their times are solved."""
        if self.children is None:
            self.children = list(self._made())
        return self.children

    def _made(self) -> list[Step]:
        node = self.node
        if isinstance(node, Sequence):
            return self._row(node)
        if isinstance(node, Together):
            return [self.child(item, index) for index, item in enumerate(node.items)]
        if isinstance(node, Choose):
            index = int(chance(self.root.maker.seed, *self.place(), "choose") * len(node.items))
            return [self.child(node.items[index], index)]
        return [self.child(node.body, 0)] if isinstance(node, At) else []

    def _row(self, node: Sequence) -> list[Step]:
        past, first = self.root.maker.past, self.begun.first if self.begun else 0
        made: list[Step] = list(past.awaited.get(self.key(), ())) if past is not None else []
        last = len(node.items) if past is None else first + AHEAD
        self.goes_on = last < len(node.items)
        before = None
        for index in range(first, len(node.items)):
            item = node.items[index]
            if index >= last and not isinstance(item, At):
                continue
            made.append(self.child(item, index, before))
            if not isinstance(item, At):
                before = made[-1]
        return made

    def key(self) -> Key:
        """Its place in the tree, root first."""
        indexes = []
        step: Step | None = self
        while step is not None:
            indexes.append(step.index)
            step = step.parent
        return (self.root.rank, *reversed(indexes))

    def place(self) -> tuple[Hashable, ...]:
        """Its place for the seed. What stands elsewhere may change without changing it: in each block a statement is
        named by its label, else by what it is and how many such stand before it."""
        names: list[Hashable] = []
        step = self
        while step.parent is not None:
            parent = step.parent.node
            if isinstance(parent, Repeat):
                names.append(step.index)
            elif isinstance(parent, Do):
                names.append(f"cue {step.index}")
            elif not isinstance(parent, At):
                names.append(self.root.maker.names(parent)[step.index])
            step = step.parent
        return (*self.root.place, *reversed(names))


def names_of(items: tuple[Node, ...]) -> tuple[str, ...]:
    """The names of statements that follow each other: the label, else what it is; and how many such stand before."""
    seen: dict[str, int] = {}
    names = []
    for item in items:
        kind = item.label.rpartition(".")[2] if item.label else _kind(item)
        seen[kind] = seen.get(kind, 0) + 1
        names.append(f"{kind} {seen[kind]}")
    return tuple(names)


def _kind(node: Node) -> str:
    if isinstance(node, Do):
        kind = node.verb.kind if isinstance(node.verb, Gesture) else type(node.verb).__name__
        return f"{kind} {node.face}"
    return type(node).__name__


def ends_in_line(step: Step) -> bool:
    """Whether the last thing that moved a settled step on was a line."""
    while True:
        node = step.node
        if isinstance(node, Do):
            return isinstance(node.verb, Say)
        if isinstance(node, (Together, At)) or (isinstance(node, Repeat) and node.lasting is not None):
            return False
        moved = [child for child in step.children or () if not (isinstance(child.node, At) or child.over)]
        if not moved:
            return step.begun is not None and step.begun.line
        step = moved[-1]


def after_line(step: Step) -> bool:
    """Whether a step directly follows a line; its forerunner has settled."""
    while step.before is None:
        parent = step.parent
        if parent is None:
            return step.root.after_line
        if not isinstance(parent.node, (Sequence, Choose, Repeat)):
            return False
        if parent.begun is not None:
            return parent.begun.line
        step = parent
    return ends_in_line(step.before)
