"""A script to the tokens that an editor colours: each word that was read, by its place in the tree and what it means.

Lines that could not be read are not in the tree. They, and the statements in texts, are read word by word instead.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import accumulate
from typing import Any

from facescript.lsp.desk import Analysis
from facescript.lsp.meanings import DEFINED, OF_KIND, Meaning, Meant, channel_parts, meanings
from facescript.lsp.walk import Node, between
from facescript.syntax import tree
from facescript.syntax.faults import Faults
from facescript.syntax.lexer import LARGEST, lex_piece

Token = tuple[int, int, Meaning, int]
"""Start and end in the source, what it is, and bits; on one line, none inside another."""

Packed = int
"""A token in one number, higher for a later one: ten thousand of these are nothing to Python's collector of garbage."""

MARKS = re.compile(r"\\.|\[[^\[\]]*\]|[*|]")
"""What is no spoken text inside a text."""

PART = re.compile(r'"[^"]*"|[^.]+')

PLAIN: dict[type, Meaning] = {
    tree.Quantity: Meaning.NUMBER,
    tree.Integer: Meaning.NUMBER,
    tree.Size: Meaning.NUMBER,
    tree.Colour: Meaning.COLOUR,
    tree.Operator: Meaning.OPERATOR,
    tree.String: Meaning.STRING,
}
TERMINALS = {
    "QUANTITY": Meaning.NUMBER,
    "INTEGER": Meaning.NUMBER,
    "SIZE": Meaning.NUMBER,
    "NTH": Meaning.NUMBER,
    "COLOUR": Meaning.COLOUR,
    "OPERATOR": Meaning.OPERATOR,
    "STRING": Meaning.STRING,
}
KEYWORD, PARAMETER = (Meaning.KEYWORD, 0), (Meaning.PARAMETER, DEFINED)
LABEL = (Meaning.LABEL, DEFINED)


MEANINGS = tuple(Meaning)


def pack(start: int, end: int, meaning: int, bits: int = 0) -> Packed:
    return start << 40 | (end - start) << 16 | meaning << 8 | bits


def unpack(packed: Packed) -> Token:
    start = packed >> 40
    return start, start + (packed >> 16 & 0xFFFFFF), MEANINGS[packed >> 8 & 0xFF], packed & 0xFF


def tokens(analysis: Analysis, first: int = 0, last: int = LARGEST) -> list[Packed]:
    """The tokens of a document in order, at least those between two offsets; of one that is too large, none."""
    if len(analysis.source.text) > LARGEST:
        return []
    reader = _Reader(analysis, first, last)
    reader.nodes(analysis.compiled.script.items)
    reader.found.sort()
    reader.rest()
    reader.found.sort()
    return reader.found


class _Reader:
    """Walks a tree. `known` says what names mean where it stands."""

    def __init__(self, analysis: Analysis, first: int, last: int) -> None:
        self.first, self.last = first, last
        self.text = analysis.source.text
        self.source = analysis.source
        self.known = meanings(analysis)
        self.found: list[Packed] = []

    def add(self, start: int, end: int, meant: Meant | None) -> None:
        if meant is not None:
            self.found.append(pack(start, end, *meant))

    @contextmanager
    def binding(self, names: Iterable[str]) -> Iterator[None]:
        """While names stand for what is given to them."""
        before = self.known
        self.known = {**before, **dict.fromkeys(names, (Meaning.PARAMETER, 0))}
        yield
        self.known = before

    # -------------------------------------------------------------------------------------------- words

    def phrase(self, phrase: tree.Phrase, as_: Meant = LABEL, spoken: bool = False) -> None:
        naming = False
        for word in phrase.words:
            kind, span = type(word), word.span
            if isinstance(word, tree.Name):
                meant = as_ if naming else self.known.get(word.text)
                if meant is not None:
                    self.found.append(pack(span.start, span.end, *meant))
                naming = word.text == "as"
            elif spoken and kind is tree.String:
                self.spoken(span.start, span.end)
            elif kind in PLAIN:
                self.found.append(pack(span.start, span.end, PLAIN[kind]))
            else:
                self.compound(word)

    def compound(self, word: tree.Word) -> None:
        """A word that is made of words."""
        if isinstance(word, tree.Dotted):
            self.dotted(word.span.start, word.span.end, str(word.parts[0]))
        elif isinstance(word, tree.Bracket):
            self.phrase(word.inner)
        elif isinstance(word, tree.Point):
            for one in word.coordinates:
                self.found.append(pack(one.span.start, one.span.end, Meaning.NUMBER))
        elif isinstance(word, tree.Call):
            self.name(word.name)
            for argument in word.arguments:
                if argument.name is not None:
                    self.add(argument.name.span.start, argument.name.span.end, (Meaning.PARAMETER, 0))
                self.phrase(argument.value)

    def name(self, name: tree.Name, meant: Meant | None = None) -> None:
        self.add(name.span.start, name.span.end, meant or self.known.get(name.text))

    def dotted(self, start: int, end: int, first: str) -> None:
        """`smile.left`; a channel is one token, parts of other names are their own."""
        meant = self.known.get(first)
        if first in channel_parts() and (meant is None or meant[0] in (Meaning.KEYWORD, Meaning.PROPERTY)):
            self.add(start, end, (Meaning.PROPERTY, 0))
            return
        for part in PART.finditer(self.text, start, end):
            if part.start() > start:
                sign = part[0][0]
                quoted = Meaning.STRING if sign == '"' else Meaning.PROPERTY
                meant = (Meaning.NUMBER if sign.isdigit() else quoted), 0
            self.add(*part.span(), meant)

    # -------------------------------------------------------------------------------------------- texts

    def spoken(self, start: int, end: int) -> None:
        """A text with marks; what stands between brackets is read as the statement that it is."""
        at = start
        for mark in MARKS.finditer(self.text, start + 1, end - 1):
            if mark.start() > at:
                self.found.append(pack(at, mark.start(), Meaning.STRING))
            at = mark.end()
            if mark[0][0] == "[" and mark[0] != "[/]":
                self.cue(mark.start(), at)
            else:
                self.found.append(pack(mark.start(), at, Meaning.OPERATOR))
        self.found.append(pack(at, end, Meaning.STRING))

    def cue(self, start: int, end: int) -> None:
        self.found.append(pack(start, start + 1, Meaning.OPERATOR))
        if self.text.startswith("read ", start + 1):
            self.found.append(pack(start + 1, start + 5, Meaning.KEYWORD))
            if start + 6 < end - 1:
                self.found.append(pack(start + 6, end - 1, Meaning.STRING))
        else:
            self.loose(start + 1, end - 1)
        self.found.append(pack(end - 1, end, Meaning.OPERATOR))

    def loose(self, start: int, end: int) -> int:
        """The words of a piece of a line, by themselves; where the last one ends."""
        found = lex_piece(self.text[start:end], start, Faults(self.source)).tokens
        speaks = any(token[1] == "say" for token in found)
        for kind, text, begin, stop in found:
            if kind == "DOTTED":
                self.dotted(begin, stop, text.partition(".")[0])
            elif kind == "STRING" and speaks:
                self.spoken(begin, stop)
            elif kind in TERMINALS:
                self.found.append(pack(begin, stop, TERMINALS[kind]))
            elif text[:1].isalpha():
                self.add(begin, stop, self.known.get(text, KEYWORD if kind == "IN_TURN" else None))
        return found[-1][3] if found else start

    # -------------------------------------------------------------------------------------------- statements

    def nodes(self, nodes: Sequence[Node]) -> None:
        for node in between(nodes, self.first, self.last):
            READERS[type(node)](self, node)

    def word(self, node: Node, length: int) -> None:
        """The keyword that a statement begins with."""
        self.add(node.span.start, node.span.start + length, KEYWORD)

    def act(self, act: tree.Act) -> None:
        first = act.phrases[0].words[0]
        verb = first.text if isinstance(first, tree.Name) else ""
        called = self.known.get(verb, KEYWORD)[0] is Meaning.ACTION
        self.phrase(act.phrases[0], spoken=verb == "say")
        for phrase in act.phrases[1:]:
            if called and isinstance(argument := phrase.words[0], tree.Name):
                self.name(argument, (Meaning.PARAMETER, 0))
                phrase = tree.Phrase(phrase.words[1:], phrase.span)
            self.phrase(phrase, spoken=verb == "say")
        for more in act.more:
            self.spoken(more.span.start, more.span.end)
        self.nodes(act.ons)

    def on(self, on: tree.On) -> None:
        self.word(on, len("on"))
        end = on.word.span.end
        self.add(on.word.span.start, end, (Meaning.STRING, 0))
        if self.text.startswith(".", end):
            self.add(end + 1, end + 1 + len(str(on.nth)), (Meaning.NUMBER, 0))
        self.nodes(on.body)

    def cast(self, cast: tree.Cast) -> None:
        self.name(cast.face)
        self.nodes(cast.body)

    def group(self, group: tree.Group) -> None:
        last = group.kind.split()[-1]
        self.word(group, self.text.index(last, group.span.start) + len(last) - group.span.start)
        self.nodes(group.body)

    def repeat(self, repeat: tree.Repeat) -> None:
        self.word(repeat, len("repeat"))
        first, *others = repeat.how.words
        if isinstance(first, tree.Name) and others and isinstance(others[0], tree.Name) and others[0].text == "in":
            self.name(first, PARAMETER)
            self.phrase(tree.Phrase(tuple(others), repeat.how.span))
            with self.binding((first.text,)):
                self.nodes(repeat.body)
        else:
            self.phrase(repeat.how)
            self.nodes(repeat.body)

    def moment(self, moment: tree.Moment) -> None:
        self.word(moment, len("at"))
        self.phrase(moment.time)
        self.nodes(moment.body)

    # -------------------------------------------------------------------------------------------- definitions

    def scene(self, scene: tree.Scene) -> None:
        self.word(scene, len("scene"))
        self.name(scene.name, (Meaning.SCENE, DEFINED))
        before = scene.title.span.end if scene.title else scene.name.span.end
        if scene.title:
            self.add(scene.title.span.start, before, (Meaning.STRING, 0))
        if scene.faces:
            at = self.text.index("with", before)
            self.add(at, at + len("with"), KEYWORD)
        for face in scene.faces:
            self.name(face)
        self.nodes(scene.body)

    def when(self, when: tree.When) -> None:
        self.word(when, len("when"))
        self.phrase(when.event, PARAMETER)
        names = [word.text for word in when.event.words[-1:] if isinstance(word, tree.Name)]
        with self.binding(names if "as" in when.event.span.text.split() else ()):
            self.nodes(when.body)

    def expression(self, node: tree.ExpressionDefinition) -> None:
        with self.heading(node, "expression", node.parameters):
            self.phrase(node.value)

    def action(self, node: tree.ActionDefinition) -> None:
        with self.heading(node, "action", node.parameters):
            self.nodes(node.body)

    @contextmanager
    def heading(
        self,
        node: tree.ExpressionDefinition | tree.ActionDefinition | tree.LetDefinition | tree.Declaration,
        kind: str,
        parameters: tuple[tree.Parameter, ...] = (),
    ) -> Iterator[None]:
        """The head of a definition, and then what its parameters are known in."""
        self.word(node, len(kind))
        meaning, bits = OF_KIND[kind]
        self.name(node.name, (meaning, bits | DEFINED))
        for parameter in parameters:
            self.name(parameter.name, PARAMETER)
            if parameter.default is not None:
                self.phrase(parameter.default)
        with self.binding(parameter.name.text for parameter in parameters):
            yield

    def let(self, node: tree.LetDefinition) -> None:
        with self.heading(node, "let"):
            self.phrase(node.value)

    def viseme(self, node: tree.VisemeDefinition) -> None:
        self.word(node, len("viseme"))
        self.add(node.sound.span.start, node.sound.span.end, (Meaning.STRING, 0))
        self.phrase(node.value)

    def declaration(self, node: tree.Declaration) -> None:
        with self.heading(node, node.kind):
            for phrase in (*node.phrases, *(phrase for line in node.lines for phrase in line)):
                self.phrase(phrase)

    def setting(self, node: tree.Setting) -> None:
        self.word(node, len(node.kind))
        for phrase in node.phrases:
            self.phrase(phrase)

    def use(self, node: tree.Use) -> None:
        self.word(node, len("use"))
        self.add(node.path.span.start, node.path.span.end, (Meaning.STRING, 0))

    # -------------------------------------------------------------------------------------------- the rest

    def rest(self) -> None:
        """Comments, and the lines of which nothing is in the tree."""
        lines = self.text.split("\n")
        starts = [0, *accumulate(len(line) + 1 for line in lines)]
        places = iter([packed >> 40 for packed in self.found])
        place = next(places, len(self.text) + 1)
        for line, start, after in zip(lines, starts, starts[1:], strict=False):
            read = place < after
            while place < after:
                place = next(places, len(self.text) + 1)
            if (not read or "#" in line) and self.first < after and start <= self.last:
                self.line(line, start, read)

    def line(self, line: str, start: int, read: bool) -> None:
        """One line: its comment, and its words where it is not read yet."""
        bare = line.strip()
        at = 0
        if bare and not (bare[0] == "#" and bare[1:2] in ("", " ", "\t", "!")):
            if not read:
                at = self.loose(start, start + len(line.rstrip())) - start
            elif '"' in line:
                at = lex_piece(line.rstrip(), 0, Faults(self.source)).end
        found = COMMENT.search(line, at)
        if found is not None:
            self.add(start + found.start(), start + len(line.rstrip()), (Meaning.COMMENT, 0))


COMMENT = re.compile(r"#(?=[ \t!]|$)")

READERS: dict[type, Callable[[_Reader, Any], None]] = {
    tree.Act: _Reader.act,
    tree.On: _Reader.on,
    tree.Cast: _Reader.cast,
    tree.Group: _Reader.group,
    tree.Repeat: _Reader.repeat,
    tree.Moment: _Reader.moment,
    tree.Scene: _Reader.scene,
    tree.When: _Reader.when,
    tree.ExpressionDefinition: _Reader.expression,
    tree.ActionDefinition: _Reader.action,
    tree.LetDefinition: _Reader.let,
    tree.VisemeDefinition: _Reader.viseme,
    tree.Declaration: _Reader.declaration,
    tree.Setting: _Reader.setting,
    tree.Use: _Reader.use,
}
