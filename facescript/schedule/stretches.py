"""A scene to its stretches: runs of statements into which nothing reaches from the others, by what is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import accumulate, pairwise
from zlib import crc32

from facescript.ir.acts import Add, At, Choose, Do, Drop, Glance, Look, Node, Say, Scan, Show, Verb, Wait, WaitUntil
from facescript.ir.acts import Sequence as Block
from facescript.ir.play import Crowd, MovingTarget, Target
from facescript.ir.values import AtPerson, AtTarget, Away, Moment
from facescript.schedule.defaults import has_draw
from facescript.schedule.labels import inner
from facescript.schedule.steps import names_of

LONG = 128
"""A scene of fewer statements is solved as one."""

LINES, FAR = 4, 48
"""A stretch ends with a line, one in so many; or with any line or wait after so many statements. What is written says
where: an edit leaves the ends of other stretches where they are."""

Worn = tuple[str | None, str]
"""A face, and the name of what it shows or drops."""


@dataclass(frozen=True, slots=True)
class Trait:
    """What matters of a statement to those around it: the names that it bears, those that it waits for, and by face
    those of the terms that it shows and those that it drops. `bound` is whether it looks at the scene's clock, or at
    what moves by it; `chancy` whether something in it is left to the seed; `size` how many statements it is."""

    node: Node
    bears: frozenset[str]
    waits: frozenset[str]
    shows: frozenset[Worn]
    drops: frozenset[Worn]
    bound: bool
    chancy: bool
    size: int

    @property
    def pauses(self) -> bool:
        """Whether things are likely to be at rest after it."""
        return isinstance(self.node, Do) and isinstance(self.node.verb, (Say, Wait))

    @property
    def ends(self) -> bool:
        """Whether a stretch ends with it wherever it stands: so it does with one line in `LINES`, by its text."""
        line = self.node.verb if isinstance(self.node, Do) else None
        return isinstance(line, Say) and crc32(line.text.encode("utf-8", "replace")) % LINES == 0

    @property
    def is_line(self) -> bool:
        return isinstance(self.node, Do) and isinstance(self.node.verb, Say)


@dataclass(frozen=True, slots=True)
class Stretch:
    """Statements of a scene that follow each other. `called` are what the seed knows them by, if any of the scene are
    `chancy`; `after_line` is whether they follow a line."""

    items: tuple[Node, ...]
    called: tuple[str, ...]
    chancy: bool
    after_line: bool

    @property
    def names(self) -> tuple[str, ...] | None:
        """What the seed knows the statements by, where that matters."""
        return self.called if self.chancy else None


def joined(run: list[Stretch]) -> Stretch:
    """Stretches that follow each other as one."""
    if len(run) == 1:
        return run[0]
    items = tuple(item for one in run for item in one.items)
    called = tuple(name for one in run for name in one.called)
    return Stretch(items, called, any(one.chancy for one in run), run[0].after_line)


def moving(targets: Iterable[Target]) -> frozenset[str]:
    """The names of targets that move, and of crowds with such a one in them."""
    found = {target.name for target in targets if isinstance(target, MovingTarget)}
    crowds = (target for target in targets if isinstance(target, Crowd))
    return frozenset(found | {crowd.name for crowd in crowds if not found.isdisjoint(_members(crowd))})


def _members(crowd: Crowd) -> list[str]:
    return [member for member in crowd.members if isinstance(member, str)]


def trait(node: Node, movers: frozenset[str]) -> Trait:
    """The trait of a statement, where the targets `movers` move."""
    inside = list(_within(node))
    deeds = [one for one, _ in inside if isinstance(one, Do)]
    moments = [(moment, clocked) for one, clocked in inside if (moment := _moment(one)) is not None]
    clock = any(moment.mark is None and not clocked for moment, clocked in moments)
    return Trait(
        node,
        bears=frozenset(one.label for one, _ in inside if one.label is not None),
        waits=frozenset(moment.mark.label for moment, _ in moments if moment.mark is not None),
        shows=frozenset(worn for deed in deeds for worn in _shown(deed)),
        drops=frozenset((deed.face, deed.verb.name) for deed in deeds if isinstance(deed.verb, Drop)),
        bound=clock or any(_follows(deed.verb, movers) for deed in deeds),
        chancy=any(_chancy(one) for one, _ in inside),
        size=len(inside),
    )


def _within(top: Node) -> Iterator[tuple[Node, bool]]:
    """Every statement in one, and whether it stands in a block with a clock of its own."""
    waiting = [(top, False)]
    while waiting:
        node, clocked = waiting.pop()
        yield node, clocked
        inside = clocked or (isinstance(node, Block) and node.clock)
        waiting += [(one, inside) for _, one in inner(node)]


def _moment(node: Node) -> Moment | None:
    """The moment that a statement waits for."""
    if isinstance(node, At):
        return node.moment
    return node.verb.moment if isinstance(node, Do) and isinstance(node.verb, WaitUntil) else None


def _shown(deed: Do) -> Iterator[Worn]:
    """The names by which what is shown may be dropped: a term's, and that of what it is one side of."""
    if isinstance(deed.verb, (Show, Add)):
        for term in deed.verb.mix.terms:
            yield deed.face, term.name
            yield deed.face, term.name.rpartition(".")[0]


def _follows(verb: Verb, movers: frozenset[str]) -> bool:
    """Whether a look's aim depends on the time."""
    if isinstance(verb, Scan):
        return verb.crowd in movers
    aim = verb.aim if isinstance(verb, (Look, Glance)) else None
    return isinstance(aim, AtPerson) or (isinstance(aim, AtTarget) and aim.name in movers)


def _chancy(node: Node) -> bool:
    """Whether the seed has a part in a statement, those inside it aside."""
    if not isinstance(node, Do):
        moment, lasting = getattr(node, "moment", None), getattr(node, "lasting", None)
        return isinstance(node, Choose) or has_draw(moment) or has_draw(lasting)
    verb = node.verb
    if isinstance(verb, Say):
        return False
    if isinstance(verb, Scan) or (isinstance(verb, (Look, Glance)) and isinstance(verb.aim, Away)):
        return True
    return has_draw(verb) or (isinstance(verb, (Show, Add)) and verb.timing.manner == "spontaneous")


# ------------------------------------------------------------------------------------------------ where to cut


def stretches(traits: list[Trait]) -> list[Stretch] | None:
    """The shortest stretches of a scene; None where it is one whole. Each but the last ends in a line or a wait, after
    which things are likely to be at rest."""
    if any(one.bound for one in traits):
        return None
    over = [0] * (len(traits) + 1)
    for first, last in (*_waits(traits), *_drops(traits)):
        over[min(first, last)] += 1
        over[max(first, last)] -= 1
    ends = list(_ends(traits, accumulate(over)))
    if not ends or ends == [len(traits)]:
        return None
    items, chancy = tuple(one.node for one in traits), [one.chancy for one in traits]
    called = names_of(items) if any(chancy) else ()
    borders = [0, *ends] if ends[-1] == len(items) else [0, *ends, len(items)]
    found = []
    for first, last in pairwise(borders):
        after_line = first > 0 and traits[first - 1].is_line
        found.append(Stretch(items[first:last], called[first:last], True in chancy[first:last], after_line))
    return found


def _ends(traits: list[Trait], over: Iterable[int]) -> Iterator[int]:
    """After how many statements stretches end; `over` counts the ties that each end would cut."""
    last = 0
    for number, (one, ties) in enumerate(zip(traits, over, strict=False), 1):
        if not ties and one.pauses and (number - last >= FAR or one.ends):
            last = number
            yield number


def _waits(traits: list[Trait]) -> Iterator[tuple[int, int]]:
    """Each statement that waits for the name of another, with the first and the last that bear it."""
    first: dict[str, int] = {}
    last: dict[str, int] = {}
    for index, one in enumerate(traits):
        for name in one.bears:
            first.setdefault(name, index)
            last[name] = index
    for index, one in enumerate(traits):
        if one.waits or one.drops:
            for name in (*one.waits, *(name for _, name in one.drops)):
                yield index, first.get(name, index)
                yield index, last.get(name, index)


def _drops(traits: list[Trait]) -> Iterator[tuple[int, int]]:
    """Each drop, with the first that shows what it drops after it was dropped before."""
    shown: dict[Worn, int] = {}
    for index, one in enumerate(traits):
        for worn in one.shows:
            shown.setdefault(worn, index)
        for worn in one.drops:
            yield index, shown.get(worn, index)
            if isinstance(one.node, Do):
                shown.pop(worn, None)
