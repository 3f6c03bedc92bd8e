"""Lines to top-level blocks: how deep each line stands, and where one block ends and the next begins."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import takewhile

from facescript.syntax.faults import Faults
from facescript.syntax.lexer import Line

DEEPEST = 32
"""How many blocks, counted by their colons, may stand in each other; brackets likewise."""

MOST_MOVED = 100
"""Lines that a fix of indentation moves."""

Block = list[Line]
"""A line without indentation and those indented below it."""


def cut(lines: list[Line], faults: Faults, odd: dict[int, int] | None = None) -> list[Block]:
    """The top-level blocks of a script, each line's `level` set. Lines nested deeper than `DEEPEST` are left out.

    `odd` are indentations that were reported in lines before, and what they are taken for; those of these lines join
    them.
    """
    _Levels(faults, {} if odd is None else odd).set(lines)
    blocks: list[Block] = []
    for line in _shallow(lines, faults):
        if line.level == 0 or not blocks:
            blocks.append([])
        blocks[-1].append(line)
    return blocks


class _Levels:
    """Gives each line the number of indented blocks it stands in.

    `widths` are the indentations of the blocks open at a line. An indentation between two of them is
    reported once and taken for the nearer one, the inner one if in doubt; `odd` remembers it for the lines beside it.
    """

    def __init__(self, faults: Faults, odd: dict[int, int]) -> None:
        self.faults = faults
        self.widths = [0]
        self.odd = odd

    def set(self, lines: list[Line]) -> None:
        for index, line in enumerate(lines):
            line.level = self._level(lines, index)

    def _level(self, lines: list[Line], index: int) -> int:
        indent, widths = lines[index].indent, self.widths
        inner = indent
        while widths[-1] > indent:
            inner = widths.pop()
        if widths[-1] == indent:
            for odd in [odd for odd, width in self.odd.items() if width > indent]:
                del self.odd[odd]
        elif indent in self.odd:
            self._reopen(self.odd[indent], inner)
        elif inner == indent:
            widths.append(indent)
        else:
            self._between(lines[index : index + MOST_MOVED], widths[-1], inner)
        return len(widths) - 1

    def _between(self, lines: list[Line], outer: int, inner: int) -> None:
        """Report the indentation of the first line; the fix moves those below that have the same one."""
        line = lines[0]
        width = inner if inner - line.indent <= line.indent - outer else outer
        same = [other for other in takewhile(lambda other: other.indent > outer, lines) if other.indent == line.indent]
        edits = [(self._start(other), other.begin, " " * width) for other in same]
        fix = self.faults.fix(f"indent by {width}", *edits)
        self.faults.add("FS107", self._start(line), line.begin, fix, indent=line.indent, outer=outer, inner=inner)
        line.faulty = True
        self.odd[line.indent] = width
        self._reopen(width, inner)

    def _start(self, line: Line) -> int:
        return self.faults.source.text.rfind("\n", 0, line.begin) + 1

    def _reopen(self, width: int, inner: int) -> None:
        if width == inner:
            self.widths.append(inner)


def _shallow(lines: list[Line], faults: Faults) -> Iterator[Line]:
    """The lines without those nested too deep; the first of these stays, spoilt, so that no block lacks a body."""
    depths = [0]
    dropped: int | None = None
    for line in lines:
        if dropped is not None and line.level > dropped:
            continue
        dropped = None
        del depths[line.level + 1 :]
        depth = depths[-1] + max(1, sum(token[0] == "COLON" for token in line.tokens))
        if max(depth, _brackets(line)) > DEEPEST:
            faults.add("FS118", line.begin, line.end, deepest=DEEPEST)
            line.spoilt = line.faulty = True
            dropped = line.level
        depths.append(depth)
        yield line


def _brackets(line: Line) -> int:
    """How deep the brackets of a line stand in each other."""
    deepest = open_ = 0
    for kind, *_ in line.tokens:
        if kind == "RPAR":
            open_ = max(0, open_ - 1)
        elif kind in ("LPAR", "_OPEN"):
            open_ += 1
            deepest = max(deepest, open_)
    return deepest
