"""A script's tree to where each of its statements stands: in which blocks, before and after what."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from facescript.syntax import tree
from facescript.text import Source

Block = (
    tree.Scene
    | tree.When
    | tree.ActionDefinition
    | tree.Cast
    | tree.Group
    | tree.Repeat
    | tree.Moment
    | tree.On
    | tree.Script
)
Unit = tree.Item | tree.On
"""What stands in a block."""

MOVING = (tree.Act, tree.Cast, tree.Group, tree.Repeat)
"""What moves a sequence on."""


@dataclass(frozen=True, slots=True)
class Level:
    """A statement, or a block around one, in the block that it stands in."""

    block: Block
    index: int

    @property
    def body(self) -> Sequence[Unit]:
        return self.block.items if isinstance(self.block, tree.Script) else self.block.body

    @property
    def unit(self) -> Unit:
        return self.body[self.index]

    @property
    def before(self) -> Unit | None:
        """What it follows in its sequence; what stands at a moment moves nothing on."""
        return self._next(range(self.index - 1, -1, -1))

    @property
    def after(self) -> Unit | None:
        """What follows it in its sequence."""
        return self._next(range(self.index + 1, len(self.body)))

    @property
    def apart(self) -> bool:
        """Whether it follows none of its block: it starts with the others, or the seed chooses one."""
        return isinstance(self.block, tree.Group) and self.block.kind != "in turn"

    @property
    def beside(self) -> bool:
        """Whether it starts with all others of its block."""
        return isinstance(self.block, tree.Group) and self.block.kind == "together"

    def _next(self, indexes: Iterable[int]) -> Unit | None:
        if self.apart:
            return None
        return next((self.body[index] for index in indexes if isinstance(self.body[index], MOVING)), None)


@dataclass(frozen=True, slots=True)
class Standing:
    """A statement with the blocks around it, innermost first."""

    act: tree.Act
    levels: tuple[Level, ...]


def standings(script: tree.Script) -> dict[tuple[int, int], Standing]:
    """Every line that does something, by where it stands in the text."""
    found: dict[tuple[int, int], Standing] = {}
    _gather(script, (), found)
    return found


def _gather(block: Block, around: tuple[Level, ...], found: dict[tuple[int, int], Standing]) -> None:
    for index, unit in enumerate(block.items if isinstance(block, tree.Script) else block.body):
        levels = (Level(block, index), *around)
        if isinstance(unit, tree.Act):
            found[unit.span.start, unit.span.end] = Standing(unit, levels)
            for on in unit.ons:
                _gather(on, levels, found)
        elif isinstance(unit, Block):
            _gather(unit, levels, found)


# ------------------------------------------------------------------------------------------------ lines of text


def margin(source: Source, unit: Unit) -> str | None:
    """The spaces before a statement that begins its line; None for one that stands behind a colon."""
    line, column = source.position(unit.span.start)
    before = source.line(line)[: column - 1]
    return before if not before.strip() else None


def above(source: Source, unit: Unit) -> int:
    """The offset at which the line of a statement begins, or of the comments above it that belong to it."""
    number, column = source.position(unit.span.start)
    comment = " " * (column - 1) + "#"
    while number > 1 and source.line(number - 1).startswith(comment):
        number -= 1
    return source.offset(number) or 0


def last_line(source: Source, unit: Unit) -> int:
    """The number of the last line with a word of a statement."""
    return source.position(unit.span.start + len(unit.span.text.rstrip()))[0]


def row(source: Source, unit: Unit) -> tuple[int, int]:
    """The offsets between which the whole lines of a statement stand, with the last one's end."""
    first, last = source.position(unit.span.start)[0], last_line(source, unit)
    end = source.offset(last + 1)
    return source.offset(first) or 0, len(source.text) if end is None else end


def commented(source: Source, unit: Unit) -> bool:
    """Whether a comment stands behind a statement of one line."""
    line = last_line(source, unit)
    offset = source.offset(line) or 0
    return bool(source.text[unit.span.start + len(unit.span.text.rstrip()) : offset + len(source.line(line))].strip())
