"""Full names of statements to the names that they bear where they stand.

Names are gathered scope by scope, as `resolve/labels.py` does: a scene, a reaction, a pass of a counted repeat, and
each block with a clock of its own, which a script says as an action. From an action nothing outside is seen: what it
needs of there, names of statements and persons, is given to it as a parameter of the same name.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from facescript.ir.acts import At, Choose, Do, Node, Repeat, Say, Sequence, Together
from facescript.ir.values import Mark
from facescript.writing.context import Context


@dataclass(slots=True)
class Labels:
    """The names of one scope by full name; `prefix` stands before them. An action (`closed`) has `needs`: what it uses
    of outside, in the order in which it is met."""

    context: Context
    prefix: str
    outer: Labels | None = None
    closed: bool = False
    names: dict[str, str] = field(default_factory=dict)
    persons: set[str] = field(default_factory=set)
    needs: dict[str, str] = field(default_factory=dict)
    calls: dict[str, int] = field(default_factory=dict)

    def gather(self, body: Sequence) -> Labels:
        """Sees the names in a block, but for those of scopes inside it."""
        used: set[str] = set()
        for node in _named(body):
            full = node.label or ""
            local = self.names[full] = self.context.fresh(full.rpartition(".")[2], used)
            used.add(local)
            if self.prefix + local != full:
                self.context.renamed[full] = (self.prefix + local, node.span)
        return self

    def local(self, full: str) -> str | None:
        """What a full name is called here; None for what is no statement's name."""
        if full in self.names:
            return self.names[full]
        found = self.outer.local(full) if self.outer is not None else None
        return self._needed(full, found) if self.closed and found is not None else found

    def person(self, name: str) -> str:
        """Whom an event brought, as he is called here."""
        return self._needed(f"person {name}", name) if self.closed and self._binds(name) else name

    def mark(self, mark: Mark) -> str:
        """`hello.end`, `hello."cup".2`."""
        name = self.local(mark.label) or mark.label
        word = "" if mark.word is None else f'."{mark.word}"' + (f".{mark.nth}" if mark.nth != 1 else "")
        edge = "" if word and mark.edge == "start" else f".{mark.edge}"
        return f"{name}{word}{edge}"

    def repeated(self) -> Labels:
        """The scope of a pass of a counted repeat in this one."""
        number = self.numbered("repeat")
        before = self.prefix if number == 1 else f"{self.prefix}repeat{number}."
        return Labels(self.context, f"{before}*.", self)

    def called(self, action: str) -> Labels:
        """The scope of an action that is called here."""
        return Labels(self.context, f"{self.prefix}{action}.{self.numbered(action)}.", self, closed=True)

    def numbered(self, name: str) -> int:
        self.calls[name] = self.calls.get(name, 0) + 1
        return self.calls[name]

    def given(self) -> list[tuple[str, str]]:
        """What this action needs of outside: the parameter, and what the scope around calls it."""
        outer = self.outer
        assert outer is not None
        return [
            (parameter, outer.person(full[7:]) if full.startswith("person ") else outer.local(full) or parameter)
            for full, parameter in self.needs.items()
        ]

    def _binds(self, name: str) -> bool:
        return name in self.persons or (self.outer is not None and self.outer._binds(name))

    def _needed(self, full: str, name: str) -> str:
        if full not in self.needs:
            others = {*self.names.values(), *self.needs.values()}
            self.needs[full] = self.context.fresh(name, others)
        return self.needs[full]


def _named(body: Sequence) -> Iterator[Do | Sequence]:
    """The statements with names in a block, in the order written."""
    for node in body.items:
        yield from _of(node)


def _of(node: Node) -> Iterator[Do | Sequence]:
    if isinstance(node, Do):
        if node.label:
            yield node
        for cue in node.verb.cues if isinstance(node.verb, Say) else ():
            yield from _named(cue.body)
    elif isinstance(node, Sequence) and node.clock:
        if node.label:
            yield node
    elif isinstance(node, Sequence | Together | Choose):
        for item in node.items:
            yield from _of(item)
    elif isinstance(node, At):
        yield from _named(node.body)
    elif isinstance(node, Repeat):
        return
