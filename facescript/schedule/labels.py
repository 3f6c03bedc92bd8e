"""Labels to the steps that bear them: a name may be used before its line, and each pass of a repeat has its own."""

from __future__ import annotations

from collections.abc import Generator, Iterator

from facescript.ir.acts import At, Do, Node, Repeat, Say
from facescript.schedule.solver import Need
from facescript.schedule.steps import SETTLED, Step, Time

PASS = -1
"""In a route: the pass of a repeat in which the one who asks stands too."""

Route = tuple[int, ...]
"""From a root to a statement: the index in each block on the way."""


class Labels:
    """Where the labels of each tree of statements are."""

    def __init__(self) -> None:
        self._routes: dict[int, dict[str, list[Route]]] = {}

    def find(self, asking: Step, label: str) -> Generator[Need, Time, Step | None]:
        """The step that bears a label (as `Do.label` spells it); None where the seed chose another branch."""
        top = asking
        passes = []
        while top.parent is not None:
            if isinstance(top.parent.node, Repeat):
                passes.append(top)
            top = top.parent
        for route in self._of(top.node).get(label, ()):
            around = route.count(PASS)
            base = passes[-around] if around else top
            rest = route[_after(route, around) :]
            found = yield from _follow(base, rest)
            if found is not None:
                return found
        return None

    def _of(self, top: Node) -> dict[str, list[Route]]:
        known = self._routes.get(id(top))
        if known is None:
            known = self._routes[id(top)] = {}
            for node, route in nodes(top):
                if node.label is not None:
                    known.setdefault(node.label, []).append(route)
        return known


def nodes(top: Node) -> Iterator[tuple[Node, Route]]:
    """Every statement of a tree with its route."""
    waiting: list[tuple[Node, Route]] = [(top, ())]
    while waiting:
        node, route = waiting.pop()
        yield node, route
        waiting += [(one, (*route, index)) for index, one in inner(node)]


def inner(node: Node) -> list[tuple[int, Node]]:
    """The statements right inside one, each with its index on a route."""
    if isinstance(node, Do):
        cues = node.verb.cues if isinstance(node.verb, Say) else ()
        return [(index, cue.body) for index, cue in enumerate(cues)]
    if isinstance(node, Repeat):
        return [(PASS, node.body)]
    if isinstance(node, At):
        return [(0, node.body)]
    return list(enumerate(node.items))


def _after(route: Route, passes: int) -> int:
    """Where a route goes on after so many passes."""
    index = 0
    for _ in range(passes):
        index = route.index(PASS, index) + 1
    return index


def _follow(base: Step, route: Route) -> Generator[Need, Time, Step | None]:
    step = base
    for index in route:
        if isinstance(step.node, Do):
            yield (step, SETTLED)
        wanted = _last_saying(step, index)
        found = next((child for child in step.inside() if child.index == wanted), None)
        if found is None:
            return None
        step = found
    return step


def _last_saying(step: Step, cue: int) -> int:
    """The index of a cue in the last saying of a line; any other index as it is."""
    if isinstance(step.node, Do) and isinstance(step.node.verb, Say):
        before = step.begun.first if step.begun else 0
        return (before + len(step.sayings) - 1) * len(step.node.verb.cues) + cue
    return cue
