"""A script's tree to the names in it, item by item as they are asked for."""

from __future__ import annotations

from bisect import bisect_right
from collections import OrderedDict
from collections.abc import Iterator

from facescript.diagnostics.model import Diagnostics
from facescript.lsp.names.items import labels_of, mentions
from facescript.lsp.names.model import Local, Mention
from facescript.resolve.scenes import STATEMENTS
from facescript.syntax import tree
from facescript.syntax.parser import parse
from facescript.text import Source

KEPT = 256
"""Files whose names are kept."""


class ScriptNames:
    """The names of one script."""

    def __init__(self, script: tree.Script) -> None:
        self.script = script
        self._starts = [item.span.start for item in script.items]
        self._found: dict[int, list[Mention]] = {}
        self._labels: dict[str, Local] | None = None

    @property
    def source(self) -> Source:
        return self.script.source

    def at(self, offset: int) -> Mention | None:
        """The name at an offset, or just before it."""
        index = bisect_right(self._starts, offset) - 1
        around = (
            [found for found in self.of(index) if found.span.start <= offset <= found.span.end] if index >= 0 else []
        )
        return max(around, key=lambda found: (offset < found.span.end, found.span.start), default=None)

    def of(self, index: int) -> list[Mention]:
        """The names in the item with this number, in the order in which they are looked up."""
        if index not in self._found:
            item = self.script.items[index]
            seen = self.labels if isinstance(item, STATEMENTS) else {}
            self._found[index] = mentions(item, seen)
        return self._found[index]

    @property
    def labels(self) -> dict[str, Local]:
        """The labels of a script without scenes, which its lines share."""
        if self._labels is None:
            scenes = any(isinstance(item, tree.Scene) for item in self.script.items)
            body = () if scenes else (item for item in self.script.items if isinstance(item, STATEMENTS))
            self._labels = labels_of(body)
        return self._labels

    def named(self, name: str) -> Iterator[Mention]:
        """All mentions of a name, whatever it means."""
        text = self.source.text
        for index, item in enumerate(self.script.items):
            if not name.isascii() or text.find(name, item.span.start, item.span.end) >= 0:
                yield from (found for found in self.of(index) if found.name == name)

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
