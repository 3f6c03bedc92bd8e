"""Blocks of a play to the rows of a script, indented; a block with a clock of its own is said as an action."""

from __future__ import annotations

from facescript.ir.acts import At, Choose, Cue, Do, Node, Repeat, Say, Sequence, Together, Voice
from facescript.ir.play import Play
from facescript.resolve.units import SHARE, TIME
from facescript.resolve.words import VERBS
from facescript.text import Span
from facescript.writing.amounts import amount, count, one
from facescript.writing.context import Context, Row
from facescript.writing.labels import Labels
from facescript.writing.sums import Sums
from facescript.writing.texts import Bracket, strings
from facescript.writing.verbs import Verbs

FACTORS = ("rate", "pitch", "range", "volume")


class Nodes:
    """Writes blocks; `several` says whether lines need the name of their face, `actions` are the definitions made."""

    def __init__(self, context: Context, play: Play, sums: Sums) -> None:
        self.context = context
        self.verbs = Verbs(context, sums)
        self.voices = {face.name: face.voice for face in play.faces}
        self.several = False
        self.actions: list[list[Row]] = []

    def body(self, block: Sequence, labels: Labels, depth: int) -> list[Row]:
        """The rows of what a block holds."""
        return [row for node in block.items for row in self.node(node, labels, depth)]

    def node(self, node: Node, labels: Labels, depth: int) -> list[Row]:
        if isinstance(node, Do):
            return self._do(node, labels, depth)
        if isinstance(node, Sequence) and node.clock:
            return [Row(depth, self._call(node, labels) + _named(node.label, labels), node.span)]
        if isinstance(node, At):
            return self._block(f"at {self.verbs.moment(node.moment, labels)}", node.body, labels, depth, node.span)
        if isinstance(node, Repeat):
            inner = labels.repeated().gather(node.body)
            return self._block(_how(node), node.body, inner, depth, node.span)
        word = {Together: "together", Choose: "choose", Sequence: "in turn"}[type(node)]
        return self._block(word, Sequence(node.items, node.span), labels, depth, node.span)

    def _block(self, head: str, body: Sequence, labels: Labels, depth: int, span: Span) -> list[Row]:
        return [Row(depth, f"{head}:", span), *self.body(body, labels, depth + 1)]

    # -------------------------------------------------------------------------------------------- actions

    def _call(self, block: Sequence, labels: Labels) -> str:
        """The call of an action that is made for a block."""
        name = self.context.fresh("part")
        self.context.taken.add(name)
        inner = labels.called(name).gather(block)
        place = len(self.actions)
        self.actions.append([])
        rows = self.body(block, inner, 1)
        given = inner.given()
        parameters = f"({', '.join(parameter for parameter, _ in given)})" if given else ""
        self.actions[place] = [Row(0, f"action {name}{parameters}:", block.span), *rows]
        arguments = [outer if not number else f"{name} {outer}" for number, (name, outer) in enumerate(given)]
        return " ".join([name, *arguments[:1]]) + "".join(f", {argument}" for argument in arguments[1:])

    # -------------------------------------------------------------------------------------------- lines

    def _do(self, node: Do, labels: Labels, depth: int) -> list[Row]:
        who = f"{node.face}: " if self.several and node.face is not None else ""
        if isinstance(node.verb, Say):
            return self._say(node, node.verb, who, labels, depth)
        return [Row(depth, f"{who}{self.verbs.verb(node.verb, labels)}{_named(node.label, labels)}", node.span)]

    def _say(self, node: Do, line: Say, who: str, labels: Labels, depth: int) -> list[Row]:
        brackets = [self._bracket(cue, labels, len(line.text)) for cue in line.cues if cue.word is None]
        first, *more = strings(line, brackets) or [""]
        text = f' "{first}"' if first else ""
        files = "".join(
            f' {word} "{self.context.path(name)}"'
            for word, name in (("from", line.recording), ("timed", line.times))
            if name is not None
        )
        head = f"{who}say{text}{files}{self._voice(node.face, line.voice)}{_named(node.label, labels)}"
        rows = [Row(depth, head, node.span), *(Row(depth + 1, f'"{piece}"', node.span) for piece in more)]
        for cue in line.cues:
            if cue.word is not None:
                nth = f".{cue.nth}" if cue.nth != 1 else ""
                rows += self._block(f'on "{cue.word}"{nth}', cue.body, labels, depth + 1, cue.body.span)
        return rows

    def _voice(self, face: str | None, voice: Voice) -> str:
        """How a line's voice is other than its face's: factors of that."""
        usual = self.voices.get(face or "", Voice())
        return "".join(
            f", {name} {one(own / base, SHARE)}"
            for name in FACTORS
            if (own := getattr(voice, name)) != (base := getattr(usual, name)) and base > 0.0
        )

    def _bracket(self, cue: Cue, labels: Labels, length: int) -> Bracket:
        node = cue.body.items[0] if cue.body.items else None
        at = cue.at or 0
        if isinstance(node, Do) and not isinstance(node.verb, Say):
            text = self.verbs.verb(node.verb, labels)
            bare = text.removeprefix("add ")
            if cue.until is None or bare == text or bare.partition(" ")[0] in {*VERBS, "neutral"}:
                return Bracket(text, at, cue.until)
            return Bracket(bare, at, None if cue.until == length else cue.until)
        text = self._call(node if isinstance(node, Sequence) and node.clock else cue.body, labels)
        return Bracket(text, at, cue.until)


def _named(full: str | None, labels: Labels) -> str:
    return f" as {labels.local(full)}" if full else ""


def _how(node: Repeat) -> str:
    if node.times is not None:
        return f"repeat {count(node.times)} times"
    return "repeat forever" if node.lasting is None else f"repeat for {amount(node.lasting, TIME)}"
