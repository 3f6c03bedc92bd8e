"""A script's tree to the statements in it: what stands in a block, and the lines between two places."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence

from facescript.resolve.labels import label
from facescript.syntax import tree

Node = tree.Item | tree.On

BLOCKS = (
    tree.Scene,
    tree.When,
    tree.ActionDefinition,
    tree.Cast,
    tree.Group,
    tree.Repeat,
    tree.Moment,
    tree.On,
)


def inside(node: Node) -> Sequence[Node]:
    """What stands in a block; under a line of speech, its `on`s."""
    if isinstance(node, tree.Act):
        return node.ons
    return node.body if isinstance(node, BLOCKS) else ()


def between(nodes: Sequence[Node], start: int, end: int) -> Iterator[Node]:
    """The nodes that have a part of the stretch of offsets from `start` to `end`; the nodes are in order."""
    first = max(0, bisect_right(nodes, start, key=lambda node: node.span.start) - 1)
    for node in nodes[first:]:
        if node.span.start > end:
            return
        if node.span.end >= start:
            yield node


def acts(nodes: Sequence[Node], start: int, end: int) -> Iterator[tree.Act]:
    """The lines that do something, however deep they stand, of which a part stands between two offsets."""
    for node in between(nodes, start, end):
        if isinstance(node, tree.Act):
            yield node
        yield from acts(inside(node), start, end)


def phrases(node: Node) -> Iterator[tree.Phrase]:
    """The phrases of a node's own line, and of the lines of a declaration; not what stands in its block."""
    match node:
        case tree.Act() | tree.Setting():
            yield from node.phrases
        case tree.Declaration():
            yield from node.phrases
            for line in node.lines:
                yield from line
        case tree.ExpressionDefinition() | tree.LetDefinition() | tree.VisemeDefinition():
            yield node.value
        case tree.Repeat():
            yield node.how
        case tree.Moment():
            yield node.time
        case tree.When():
            yield node.event


def name_of(act: tree.Act) -> tree.Name | None:
    """The name that a line gives itself."""
    return next(label(act.phrases), None)
