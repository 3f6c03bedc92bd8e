"""A symbol and a new name to the edits that rename it everywhere, or to the reason why it cannot be renamed so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import zip_longest

from facescript.diagnostics.model import Diagnostic, Diagnostics, Severity
from facescript.lsp.desk import OpenWorld
from facescript.lsp.names.model import Mention
from facescript.lsp.names.script import ScriptNames
from facescript.lsp.names.symbols import MOST_SCRIPTS, ProjectNames, Symbol, library_symbols
from facescript.resolve.kinds.library import kind_names
from facescript.resolve.resolver import resolve
from facescript.resolve.units import article
from facescript.resolve.words import UNSEEN, WORDS
from facescript.syntax.parser import parse, parse_phrases
from facescript.syntax.tree import Name
from facescript.text import Source, Span

LONGEST = 200
"""Characters of a new name."""


class RenameRefused(Exception):
    """A name that cannot be renamed so; `args[0]` is a sentence for the author."""


def check_renamed(names: ProjectNames, symbol: Symbol) -> None:
    """Refuses what no script of the project defines, and what would mean something else without its name."""
    if symbol.library:
        raise RenameRefused(f"`{symbol.name}` is the library's, and cannot be renamed.")
    covered = library_symbols().get(symbol.name)
    if covered is not None and not symbol.is_local and symbol.kind not in ("scene", "viseme", "kind"):
        raise RenameRefused(
            f"`{symbol.name}` covers the library's {covered.kind} of that name, which would count again without it."
        )
    if symbol.kind == "viseme":
        raise RenameRefused("A sound is not a name that could be another.")
    if not names.found[1] and not symbol.is_local:
        raise RenameRefused(f"The project has more than {MOST_SCRIPTS} scripts; not all that may use it can be read.")


def renamed(names: ProjectNames, symbol: Symbol, new: str) -> list[Span]:
    """The places where the new name has to stand. Raises `RenameRefused`."""
    check_renamed(names, symbol)
    _check_new(names, symbol, new)
    spans = list({(span.source.name, span.start): span for span in _spans(names, symbol)}.values())
    if new != symbol.name:
        _Trial(names, symbol, spans, new).check()
    return spans


def _spans(names: ProjectNames, symbol: Symbol) -> Iterator[Span]:
    return (mention.span for mention in names.mentions(symbol))


# ------------------------------------------------------------------------------------------------ the new name


def _check_new(names: ProjectNames, symbol: Symbol, new: str) -> None:
    if not _is_name(new):
        raise RenameRefused(f"`{new[:LONGEST]}` is no name: it has letters, digits, `_` and inner `-`.")
    if new in WORDS:
        raise RenameRefused(f"`{new}` is a word of the language.")
    kinds = (*kind_names(), UNSEEN) if symbol.kind == "kind" else ()
    if new in kinds or (new in library_symbols() and symbol.kind not in ("scene", "parameter")):
        raise RenameRefused(f"`{new}` is a name of the library.")
    if new != symbol.name and symbol.kind not in ("scene", "parameter"):
        _check_free(names, symbol, new)


def _is_name(new: str) -> bool:
    if len(new) > LONGEST or new != new.strip() or "\n" in new:
        return False
    phrases = parse_phrases(Span(Source("", new), 0, len(new)), Diagnostics())
    words = phrases[0].words if phrases is not None and len(phrases) == 1 else ()
    return len(words) == 1 and isinstance(words[0], Name) and words[0].text == new


def _check_free(names: ProjectNames, symbol: Symbol, new: str) -> None:
    for name in names.related(symbol):
        there = names.written(name).get(new)
        if there is not None:
            raise RenameRefused(f"`{new}` is {article(there.kind)} already, {_place(there.span)}.")


def _place(span: Span) -> str:
    return f"in {span.source.name} line {span.source.position(span.start)[0]}"


# ------------------------------------------------------------------------------------------------ a trial


class _Trial:
    """The project as it would be, in which every name must mean what it meant, and no fault be new."""

    def __init__(self, names: ProjectNames, symbol: Symbol, spans: list[Span], new: str) -> None:
        self.names, self.symbol, self.new = names, symbol, new
        self.edits: dict[str, list[Span]] = {}
        for span in sorted(spans, key=lambda span: span.start):
            self.edits.setdefault(span.source.name, []).append(span)
        self.world = self._edited(names.world)
        self.after = ProjectNames(self.world)

    def check(self) -> None:
        related = self.names.related(self.symbol)
        for name in related:
            self._same_meanings(name)
        for name in related:
            if any(other in self.edits for other in self.names.closure(name)):
                self._same_faults(name)

    def _edited(self, world: OpenWorld) -> OpenWorld:
        texts = dict(world.texts)
        for name, spans in self.edits.items():
            texts[world.path(name)] = edited(spans, self.new)
        return replace(world, texts=texts)

    # -------------------------------------------------------------------------------------------- meanings

    def _same_meanings(self, name: str) -> None:
        """Refuses a rename by which a name in a script would mean another thing than before."""
        before, after = self.names.script(name), self.after.script(name)
        if before is None or after is None:
            return
        if name not in self.edits and self.new not in before.source.text:
            return
        for was, now in zip_longest(before.all(), after.all()):
            if was is None or now is None or self._meant(was, name) != self._means(now, name):
                raise RenameRefused(self._clash(was or now, before))

    def _meant(self, mention: Mention, name: str) -> tuple[str, int] | None:
        """What a name means now, at the place where that would be then."""
        symbol = self.names.symbol(mention, name)
        if symbol is None:
            return None
        file, start = symbol.key
        longer = len(self.new) - len(self.symbol.span.text)
        return file, start + longer * sum(span.start < start for span in self.edits.get(file, ()))

    def _means(self, mention: Mention, name: str) -> tuple[str, int] | None:
        symbol = self.after.symbol(mention, name)
        return symbol.key if symbol is not None else None

    def _clash(self, mention: Mention, script: ScriptNames) -> str:
        line = script.source.position(min(mention.span.start, len(script.source.text)))[0]
        return f"`{self.new}` clashes: in {script.source.name} line {line} a name would mean something else."

    # -------------------------------------------------------------------------------------------- faults

    def _same_faults(self, name: str) -> None:
        """Refuses a rename by which a script would have an error that it has not yet."""
        faults = _errors(self.world, name)
        before = Counter(fault.code for fault in _errors(self.names.world, name)) if faults else Counter()
        for fault in faults:
            before[fault.code] -= 1
            if before[fault.code] < 0:
                where = f" {_place(fault.span)}:" if fault.span is not None else ""
                raise RenameRefused(f"With `{self.new}` there would be a fault{where} {fault.message}")


def _errors(world: OpenWorld, name: str) -> list[Diagnostic]:
    """What is wrong with the names of a script."""
    found = Diagnostics()
    resolve(parse(world.source(name), found), world, found)
    return [fault for fault in found.items if fault.severity is Severity.ERROR]


def edited(spans: list[Span], new: str) -> str:
    """The text of a file with another name at these places, which are in order."""
    text = spans[0].source.text
    pieces, at = [], 0
    for span in spans:
        pieces += [text[at : span.start], new]
        at = span.end
    return "".join([*pieces, text[at:]])
