"""The lines of a block to its items: a line that cannot be read is reported and left out, the lines around it stay."""

from __future__ import annotations

from itertools import takewhile
from typing import Any

from facescript.syntax.blocks import MOST_MOVED, Block
from facescript.syntax.builder import TERMINALS, Builder
from facescript.syntax.faults import Faults
from facescript.syntax.lexer import Line
from facescript.syntax.machine import END, Machine, Mark, Rule
from facescript.syntax.mends import mend, report_no_colon
from facescript.syntax.spacing import Token
from facescript.syntax.table import table

GESTURES = frozenset(("nod", "shake", "blink"))
"""Statements of one word that are no face's name."""


class Reader:
    """Reads blocks of one source at a time; `lost` are the names in the lines that were left out."""

    def __init__(self, faults: Faults) -> None:
        self.faults = faults
        self.lost: set[str] = set()
        self.builder = builder = Builder(faults.place)
        self.terminals = {kind: getattr(builder, method) for kind, method in TERMINALS.items()}
        self.rules = [
            Rule(name, length, None if make in ("", "+") else getattr(builder, make), make == "+", kept, chains)
            for name, length, make, kept, chains in table().rules
        ]

    def turn_to(self, faults: Faults) -> None:
        """Read another source, or piece, from now on."""
        self.faults, self.lost, self.builder.place = faults, set(), faults.place

    def items(self, block: Block) -> Any:
        """The items of a top-level block."""
        return _BlockReader(self, self._machine("start")).read(block)

    def cue(self, line: Line) -> Any:
        """The phrases of a line that is no statement of its own; None where it cannot be read."""
        machine = self._machine("cue")
        count = 0 if line.spoilt else machine.run(line.tokens)
        place = line.end
        if line.spoilt or count < len(line.tokens) or not machine.accepts(END):
            if not line.faulty:
                mend([*line.tokens, ("_NL", "", place, place)], count, machine.accepts, self.faults)
            return None
        return machine.finish(place)

    def _machine(self, start: str) -> Machine:
        return Machine(table(), self.rules, self.terminals, start)


class _BlockReader:
    """`open` says of each level of indentation whether the grammar knows of it; one that opens no block is ignored."""

    def __init__(self, reader: Reader, machine: Machine) -> None:
        self.lost, self.faults, self.machine = reader.lost, reader.faults, machine
        self.open: list[bool] = []
        self.before: tuple[Line, Mark] | None = None
        self.lost_level: int | None = None
        self.place = 0

    def read(self, block: Block) -> Any:
        self.place = block[0].begin
        for index, line in enumerate(block):
            self._close(line.level)
            if line.level > len(self.open):
                self._open(block[index : index + MOST_MOVED])
            elif self.machine.hungry:
                self._no_body()
            if self.lost_level is not None and line.level > self.lost_level:
                self._lose(line)
            else:
                self.lost_level = None
            self._line(line)
        self._close(0)
        if self.machine.hungry:
            self._no_body()
        return self.machine.finish(self.place)

    def _line(self, line: Line) -> None:
        """Read a line: as it is, else as it is meant, else leave it out. Of what is wrong only the first is told."""
        mark = self.machine.mark()
        tokens = self._left_out(line) if line.spoilt else self._ended(line.tokens)
        count = self.machine.run(tokens)
        if count < len(tokens) and not line.faulty:
            line.faulty = True
            mended = mend(tokens, count, self.machine.accepts, self.faults)
            if mended:
                self.machine.restore(mark)
                tokens = mended
                count = self.machine.run(tokens)
        if count < len(tokens):
            self.machine.restore(mark)
            tokens = self._left_out(line)
            self.machine.run(tokens)
        self.before = line, mark
        self.place = line.end

    def _left_out(self, line: Line) -> list[Token]:
        """What stands for a line that cannot be read; the lines below it are lost with it."""
        self._lose(line)
        self.lost_level = line.level if self.lost_level is None else self.lost_level
        return self._ended([("FAULT", "", line.begin, line.end)])

    def _lose(self, line: Line) -> None:
        self.lost.update(token[1].split(".")[0] for token in line.tokens if token[0] in ("NAME", "DOTTED"))

    def _ended(self, tokens: list[Token]) -> list[Token]:
        end = tokens[-1][3]
        return [*tokens, ("_NL", "", end, end)]

    def _mark(self, kind: str) -> Token:
        """A token that the author sees as indentation."""
        return kind, "", self.place, self.place

    def _close(self, level: int) -> None:
        while len(self.open) > level:
            if self.machine.hungry:
                self._no_body()
            if self.open.pop():
                self.machine.run([self._mark("_DEDENT")])

    def _open(self, lines: list[Line]) -> None:
        """Enter the block that the first of some lines begins by its indentation, where there is one."""
        line = lines[0]
        must = self.machine.hungry
        mark = self.machine.mark()
        if self.machine.run([self._mark("_INDENT")]):
            first = "FAULT" if line.spoilt else line.tokens[0][0]
            if must or self.machine.accepts("NAME") or self.machine.accepts(first):
                self.open.append(True)
                return
        self.machine.restore(mark)
        if self.before and _lacks_colon(self.before[0]) and self._add_colon(*self.before):
            self.open.append(True)
            return
        self.open.append(False)
        if not line.faulty:
            line.faulty = True
            self._unexpected(lines)

    def _unexpected(self, lines: list[Line]) -> None:
        """Report the indentation of the first line; the fix moves all that stand as deep as it."""
        margin = self.before[0].indent if self.before else 0
        run = takewhile(lambda line: line.level >= lines[0].level, lines)
        edits = [(*self._margin(line), " " * (line.indent - lines[0].indent + margin)) for line in run]
        self.faults.add("FS108", *self._margin(lines[0]), self.faults.fix("indent it like the line above", *edits))

    def _margin(self, line: Line) -> tuple[int, int]:
        return self.faults.source.text.rfind("\n", 0, line.begin) + 1, line.begin

    def _add_colon(self, header: Line, mark: Mark) -> bool:
        """Read the line above again with the colon that it lacks; whether it can be read so."""
        end = header.end
        now = self.machine.mark()
        self.machine.restore(mark)
        tokens = header.tokens
        if [token[1] for token in tokens[-2:]] == ["in", "turn"]:
            tokens = [*tokens[:-2], ("IN_TURN", "in turn", tokens[-2][2], end)]
        tokens = [*self._ended([*tokens, ("COLON", ":", end, end)]), self._mark("_INDENT")]
        if self.machine.run(tokens) < len(tokens):
            self.machine.restore(now)
            return False
        if not header.faulty:
            report_no_colon(_after_colon(header)[0], header.tokens[-1], self.faults)
            header.faulty = True
        return True

    def _no_body(self) -> None:
        """Report a colon with nothing below it, and have the machine believe that there was a line."""
        if self.before and not self.before[0].faulty:
            line = self.before[0]
            self.faults.add("FS122", line.end - 1, line.end, header=line.tokens[0][1])
            line.faulty = True
        self.machine.run([self._mark(kind) for kind in ("_INDENT", "FAULT", "_NL", "_DEDENT")])


def _lacks_colon(line: Line) -> bool:
    """Whether a line that opens no block looks as if it should: it ends in a name alone, or in `in turn`."""
    words = [token[1] for token in _after_colon(line)]
    return words == ["in", "turn"] or (len(words) == 1 and line.tokens[-1][0] == "NAME" and words[0] not in GESTURES)


def _after_colon(line: Line) -> list[Token]:
    """The tokens of a line after its last colon: its last statement."""
    colons = [index for index, token in enumerate(line.tokens) if token[0] == "COLON"]
    return line.tokens[colons[-1] + 1 if colons else 0 :]
