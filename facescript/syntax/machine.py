"""The LALR machine: runs the parse table over the tokens of one block and has the tree built bottom up."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from facescript.syntax.spacing import Token
from facescript.syntax.table import Table

SOFT = frozenset(("LIFE", "AT", "WITH"))
"""Keywords that are plain words where the grammar expects none: `life calm` below a face, `at 10% 20%`."""

END = "$END"

Build = Callable[[list[Any], int, int], Any]
"""What a rule makes of the values of its symbols, and its start and end in the source."""

Make = Callable[[str, int, int], Any]
"""What a terminal makes of its text, start and end."""


class Mark(NamedTuple):
    """A state of the machine to come back to."""

    states: list[int]
    values: list[Any]
    begins: list[int]
    ends: list[int]


class Rule(NamedTuple):
    """`table.Table.rules`, ready to run; `build` is None where the one value passes as it is."""

    name: str
    length: int
    build: Build | None
    chain: bool
    kept: list[int]
    chains: list[int]


class Machine:
    """Parses one block; a chain, the helper of a repeat, is (the chain before or None, values)."""

    def __init__(self, table: Table, rules: list[Rule], terminals: dict[str, Make], start: str) -> None:
        self.rows, self.rules, self.terminals = table.states, rules, terminals
        self.last = table.ends[start]
        self.states = [table.starts[start]]
        self.values: list[Any] = [None]
        self.begins = [0]
        self.ends = [0]

    def run(self, tokens: Iterable[Token]) -> int:
        """Take in tokens; the number taken in before one that cannot stand where it stands."""
        rows, rules, states = self.rows, self.rules, self.states  # `_reduce` changes the stacks in place
        count = 0
        for kind, text, start, end in tokens:
            while True:
                action = rows[states[-1]].get(kind)
                if action is None:
                    if kind not in SOFT:
                        return count
                    kind = "NAME"
                elif action >= 0:
                    break
                else:
                    self._reduce(rules[~action], start)
                    if states[-1] == self.last and kind == END:
                        return count + 1
            states.append(action)
            make = self.terminals.get(kind)
            self.values.append(make(text, start, end) if make else None)
            self.begins.append(start)
            self.ends.append(end)
            count += 1
        return count

    def finish(self, place: int) -> Any:
        """The value of the start rule after the last token, which must have left the machine ready for the end."""
        self.run([(END, "", place, place)])
        return self.values[-1]

    def accepts(self, kind: str) -> bool:
        """Whether a token of this kind can stand next. Changes nothing."""
        states = self.states[:]
        while True:
            action = self.rows[states[-1]].get(kind)
            if action is None or action >= 0:
                return action is not None
            rule = self.rules[~action]
            del states[len(states) - rule.length :]
            states.append(self.rows[states[-1]][rule.name])
            if states[-1] == self.last and kind == END:
                return True

    @property
    def hungry(self) -> bool:
        """Whether an indented block must come next: the line before ended in its colon."""
        return self.rows[self.states[-1]].keys() == {"_INDENT"}

    def mark(self) -> Mark:
        return Mark(self.states[:], self.values[:], self.begins[:], self.ends[:])

    def restore(self, mark: Mark) -> None:
        self.states, self.values, self.begins, self.ends = (part[:] for part in mark)

    def _reduce(self, rule: Rule, place: int) -> None:
        size = len(self.states) - rule.length
        values = self.values[size:]
        begin, end = (self.begins[size], self.ends[-1]) if values else (place, place)
        del self.states[size:], self.values[size:], self.begins[size:], self.ends[size:]
        self.states.append(self.rows[self.states[-1]][rule.name])
        self.values.append(_value(rule, values, begin, end))
        self.begins.append(begin)
        self.ends.append(end)


def _value(rule: Rule, values: list[Any], begin: int, end: int) -> Any:
    if rule.chain:
        own = [values[index] for index in rule.kept if index not in rule.chains]
        return (values[rule.chains[0]] if rule.chains else None, own)
    if rule.build is None:
        return values[rule.kept[0]]
    if not rule.chains:
        return rule.build([values[index] for index in rule.kept], begin, end)
    children: list[Any] = []
    for index in rule.kept:
        if index in rule.chains:
            children += _links(values[index])
        else:
            children.append(values[index])
    return rule.build(children, begin, end)


def _links(chain: Any) -> list[Any]:
    """The values of a chain in their order."""
    parts = []
    while chain is not None:
        chain, own = chain
        parts.append(own)
    return [value for own in reversed(parts) for value in own]
