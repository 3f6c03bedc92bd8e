"""A script's tree to the names in it, item by item as they are asked for."""

from __future__ import annotations

from bisect import bisect_right
from collections import OrderedDict
from collections.abc import Iterator

from facescript.diagnostics.model import Diagnostics
from facescript.lsp.names.items import Opened, labels_of, mentions, opened
from facescript.lsp.names.model import Local, Mention
from facescript.resolve.scenes import STATEMENTS
from facescript.syntax import tree
from facescript.syntax.parser import parse
from facescript.text import Source, Span

KEPT = 256
"""Files whose names are kept."""


class ScriptNames:
    """The names of one script."""

    def __init__(self, script: tree.Script) -> None:
        self.script = script
        self._starts = [item.span.start for item in script.items]
        self._opened: dict[int, Opened] = {}
        self._found: dict[tuple[int, int], list[Mention]] = {}
        self._labels: dict[str, Local] | None = None

    @property
    def source(self) -> Source:
        return self.script.source

    def at(self, offset: int) -> Mention | None:
        """The name at an offset, or just before it."""
        index = bisect_right(self._starts, offset) - 1
        if index < 0:
            return None
        block = self._open(index)
        number = bisect_right(block.body, offset, key=lambda statement: statement.span.start) - 1
        near = self._in(index, number) if number >= 0 else block.head
        around = [found for found in near if found.span.start <= offset <= found.span.end]
        return max(around, key=lambda found: (offset < found.span.end, found.span.start), default=None)

    def of(self, index: int) -> Iterator[Mention]:
        """The names in the item with this number."""
        block = self._open(index)
        yield from block.head
        for number in range(len(block.body)):
            yield from self._in(index, number)

    def _open(self, index: int) -> Opened:
        if index not in self._opened:
            item = self.script.items[index]
            self._opened[index] = opened(item, self.labels if isinstance(item, STATEMENTS) else {})
        return self._opened[index]

    def _in(self, index: int, number: int) -> list[Mention]:
        if (index, number) not in self._found:
            self._found[index, number] = mentions(self._opened[index], number)
        return self._found[index, number]

    @property
    def labels(self) -> dict[str, Local]:
        """The labels of a script without scenes, which its lines share."""
        if self._labels is None:
            scenes = any(isinstance(item, tree.Scene) for item in self.script.items)
            body = () if scenes else (item for item in self.script.items if isinstance(item, STATEMENTS))
            self._labels = labels_of(body)
        return self._labels

    def named(self, name: str) -> Iterator[Mention]:
        """All mentions of a name, whatever it means; only statements with its letters are looked at."""
        for index, item in enumerate(self.script.items):
            if self._has(item.span, name):
                block = self._open(index)
                yield from (found for found in block.head if found.name == name)
                for number, statement in enumerate(block.body):
                    if self._has(statement.span, name):
                        yield from (found for found in self._in(index, number) if found.name == name)

    def _has(self, span: Span, name: str) -> bool:
        """Whether a stretch may have a name, which beyond ASCII may be written in another form."""
        return not name.isascii() or self.source.text.find(name, span.start, span.end) >= 0

    def all(self) -> Iterator[Mention]:
        for index in range(len(self.script.items)):
            yield from self.of(index)


_KEPT: OrderedDict[str, ScriptNames] = OrderedDict()
_FILES: OrderedDict[str, ScriptNames] = OrderedDict()


def names_of(script: tree.Script) -> ScriptNames:
    """The names of a script; kept until another tree of a file of that name comes."""
    found = _KEPT.get(script.source.name)
    return found if found is not None and found.script is script else _keep(_KEPT, ScriptNames(script))


def names_in(source: Source) -> ScriptNames:
    """The names of a file as it is, parsed once for the same text; what is wrong with it is told elsewhere."""
    found = _FILES.get(source.name)
    if found is not None and found.source.text == source.text:
        return found
    return _keep(_FILES, ScriptNames(parse(source, Diagnostics())))


def _keep(kept: OrderedDict[str, ScriptNames], names: ScriptNames) -> ScriptNames:
    """One state of a file each, so that edits do not pile up."""
    kept.pop(names.source.name, None)
    kept[names.source.name] = names
    while len(kept) > KEPT:
        kept.popitem(last=False)
    return names
