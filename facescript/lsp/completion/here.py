"""A place in a document to what is around it: who acts, which faces are there, which names a block brings."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice, pairwise

from facescript.lsp.completion.before import Before
from facescript.lsp.completion.offers import Offer
from facescript.lsp.desk import Analysis
from facescript.lsp.vocabulary import around, is_say, labels, project_of, spoken_words
from facescript.resolve.project import Project, Refused
from facescript.resolve.tables import rows
from facescript.syntax import tree
from facescript.syntax.spacing import Token
from facescript.syntax.tree import String
from facescript.text import Span

MOST_LABELS = 50
"""Statements whose names are offered as times, unless more of a name is written."""


@dataclass(frozen=True, slots=True)
class Here:
    """A place in a document that may have changed a little since it was analysed."""

    before: Before
    analysis: Analysis

    @property
    def project(self) -> Project:
        return project_of(self.analysis)

    @property
    def items(self) -> tuple[tree.Item, ...]:
        return self.analysis.compiled.script.items

    # -------------------------------------------------------------------------------------------- who

    @property
    def blocks(self) -> tuple[tuple[Token, ...], ...]:
        """What opens the blocks around, innermost first: on the line itself, then the lines above."""
        above: list[tuple[Token, ...]] = []
        for line in self.before.openers:
            above += reversed(_heads(line))
        return (*reversed(self.before.heads), *above)

    @property
    def scripted(self) -> bool:
        """Whether the script has scenes, in which all its statements then stand."""
        return any(isinstance(item, tree.Scene) for item in self.items)

    def first_words(self) -> Iterator[str]:
        return (block[0][1] for block in self.blocks if block)

    def faces(self) -> list[str]:
        """The faces of the scene around, by name."""
        known = self.project.names.known("face")
        for block in self.blocks:
            words = [token[1] for token in block]
            if words[:1] == ["scene"] and "with" in words:
                return [name for name in words[words.index("with") + 1 :] if name in known]
        return known

    def looker(self) -> str:
        """Who does what is written here; "" where nobody is named."""
        known = self.project.names.known("face")
        named = next((block[0][1] for block in self.blocks if len(block) == 1 and block[0][1] in known), "")
        return named or (known[0] if len(known) == 1 else "")

    def nameless(self) -> bool:
        """Whether a line here needs a face's name in front."""
        return not self.looker() and len(self.project.names.known("face")) > 1 and "action" not in self.first_words()

    def people(self) -> bool:
        """Whether persons come and go."""
        events = (item for item in self.items if isinstance(item, tree.Setting) and item.kind == "event")
        return any(word.span.text == "arrives" for event in events for part in event.phrases for word in part.words)

    # -------------------------------------------------------------------------------------------- names of blocks

    def bound(self) -> Iterator[Offer]:
        """Parameters of the action around, rows of a repeat, persons of a reaction."""
        for block in self.blocks:
            words = [token[1] for token in block]
            if words[:1] in (["action"], ["expression"]):
                yield from (Offer(name, "parameter", f"parameter of {words[1]}") for name in _parameters(block))
            elif words[:1] == ["repeat"] and words[2:3] == ["in"]:
                yield from self._rows(words[1], block[3:4])
            elif words[:1] == ["when"] and "as" in words[:-1]:
                yield Offer(words[words.index("as") + 1], "parameter", "the person of this reaction")

    def _rows(self, name: str, what: tuple[Token, ...]) -> Iterator[Offer]:
        """What the name of a repeat stands for: one of a crowd, or the cells of a table by their columns."""
        for kind, text, start, end in what:
            if kind != "STRING":
                yield Offer(name, "parameter", f"one of {text}")
                continue
            table = String(text[1:-1], Span(self.analysis.source, start, end))
            with suppress(Refused):
                columns = rows(self.project, table)[0].cells if rows(self.project, table) else ()
                yield from (Offer(f"{name}.{column}", "parameter", f"a column of {text}") for column in columns)

    def labels(self) -> list[tuple[str, tree.Act]]:
        """The names of statements that can be seen from here, the nearest first."""
        place = self.before.place
        found = labels(around(self.analysis, place), place)
        return sorted(found, key=lambda each: abs(each[1].span.start - place))

    def moments(self) -> Iterator[Offer]:
        """The times that named statements give; the words of a line where its name and a dot are written."""
        word = self.before.word
        typed = word.partition(".")[0]
        near = (each for each in self.labels() if each[0].startswith(typed))
        for name, act in islice(near, MOST_LABELS):
            says = " ".join(act.span.text.split("\n")[0].split())
            yield Offer(f"{name}.start", "label", says)
            yield Offer(f"{name}.end", "label", says)
            if word.startswith(f"{name}."):
                yield from (Offer(f'{name}."{spoken}"', "label", says) for spoken in spoken_words(self.project, act))

    def words_above(self) -> list[str]:
        """The words of the line of speech in whose block the place stands."""
        opener = self.before.openers[0] if self.before.openers else ()
        start = next((token[2] for token in opener if token[1] == "say"), None)
        body = around(self.analysis, self.before.place)
        return next((spoken_words(self.project, act) for act in _said(body) if act.span.start == start), [])


def _said(body: tuple[tree.Statement, ...]) -> Iterator[tree.Act]:
    """All lines of speech in a block."""
    for statement in body:
        if isinstance(statement, tree.Act):
            if is_say(statement):
                yield statement
            for on in statement.ons:
                yield from _said(on.body)
        else:
            yield from _said(statement.body)


def _heads(line: tuple[Token, ...]) -> list[tuple[Token, ...]]:
    """What stands before each colon of a line, and what behind the last one."""
    parts: list[list[Token]] = [[]]
    for token in line:
        if token[0] == "COLON":
            parts.append([])
        else:
            parts[-1].append(token)
    return [tuple(part) for part in parts if part]


def _parameters(block: tuple[Token, ...]) -> Iterator[str]:
    """The names in the brackets of a definition's head that begin a parameter."""
    for before, token in pairwise(block):
        if token[0] == "NAME" and before[0] in ("_OPEN", "COMMA", "LPAR"):
            yield token[1]
