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


def name_of(act: tree.Act) -> tree.Name | None:
    """The name that a line gives itself."""
    return next(label(act.phrases), None)
