"""A word of a document to what an editor says of it: what it is, and of a statement its solved times."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

from lsprotocol import types

from facescript.diagnostics.model import Diagnostics
from facescript.lsp.completion.before import lexed
from facescript.lsp.describe import code, definition_text, modifier_text, primitive_text, verb_text, word_text
from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, range_of
from facescript.lsp.server import FaceServer
from facescript.lsp.vocabulary import around, labels, project_of
from facescript.lsp.way import way
from facescript.resolve.blocks import ROWS
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.lines import match, segments
from facescript.resolve.lives import ROWS as KNOBS
from facescript.resolve.reader import spelled
from facescript.resolve.words import FACE, FILM, VERBS, Modifier
from facescript.schedule.score import FOREVER, TimedAct
from facescript.syntax import tree
from facescript.syntax.parser import parse_phrases
from facescript.text import Span

MOST_TIMES = 3
"""Times of one statement that are told: an action's are one set a call."""


def hover(analysis: Analysis, place: types.Position) -> types.Hover | None:
    """What is said of the word at a place; None where there is none, or nothing to say."""
    at = offset(analysis.source, place)
    word = _word_at(analysis, at)
    if word is None:
        return None
    nodes = way(analysis.compiled.script, at)
    if nodes and isinstance(nodes[-1], tree.String) and (cue := _cue(nodes[-1], at)) is not None:
        nodes = [*nodes, *cue]
        word = cue[-1].span
    parts = [text for text in (_meaning(analysis, nodes, word), *_times(analysis, nodes, word)) if text]
    if not parts:
        return None
    return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, "\n\n".join(parts)), range_of(word))


def _word_at(analysis: Analysis, at: int) -> Span | None:
    """The token at an offset, or the one that ends there."""
    source = analysis.source
    number, column = source.position(at)
    tokens = lexed(source, at - column + 1, source.line(number))
    inside = [(start, end) for _, _, start, end in tokens if start <= at <= end]
    return Span(source, *inside[-1]) if inside else None


def _cue(text: tree.String, at: int) -> list[Any] | None:
    """The statement in brackets that a place in a text is in, its phrase and its word; None where there is none."""
    source = text.span.source
    start = source.text.rfind("[", text.span.start, at)
    end = source.text.find("]", at, text.span.end)
    if start < 0 or end < 0 or "]" in source.text[start:at]:
        return None
    phrases = parse_phrases(Span(source, start + 1, end), Diagnostics())
    held = [
        (phrase, word) for phrase in phrases or () for word in phrase.words if word.span.start <= at <= word.span.end
    ]
    return [tree.Act(phrases, (), (), Span(source, start, end + 1)), *held[-1]] if phrases and held else None


# ------------------------------------------------------------------------------------------------ what it is


def _meaning(analysis: Analysis, nodes: list[Any], word: Span) -> str | None:
    """What a word is by where it stands: a verb, a modifier, a name, or a word of the language."""
    line = next(
        (node for node in reversed(nodes) if isinstance(node, tree.Act | tree.Declaration | tree.Setting)), None
    )
    text = word.text
    if isinstance(line, tree.Act) and line.phrases[0].words[0].span == word and text in VERBS:
        return verb_text(VERBS[text])
    row = _modifier(line, word) if line is not None else None
    if row is not None:
        return modifier_text(row)
    name = next((node for node in reversed(nodes) if isinstance(node, tree.Name | tree.Dotted)), None)
    if name is not None and name.span == word:
        return _named(analysis, nodes, name)
    return word_text("in turn" if text in ("in", "turn") else text.split()[0]) if text else None


def _modifier(line: Any, word: Span) -> Modifier | None:
    """The modifier of a line that a word introduces; its value is not it."""
    for number, phrase in enumerate(_phrases(line)):
        for place, words in enumerate(segments(phrase.words)):
            held = words[0].span.start <= word.start and word.end <= words[-1].span.end
            if held and (number or place or not isinstance(line, tree.Act)):
                row, value = match(words, _rows(line))
                of_value = any(each.span.start <= word.start < each.span.end for each in value)
                return None if of_value and len(value) < len(words) else row
    return None


def _phrases(line: Any) -> Iterator[tree.Phrase]:
    yield from line.phrases
    if isinstance(line, tree.Declaration):
        for row in line.lines:
            yield from row


def _rows(line: Any) -> dict[str, Modifier]:
    if isinstance(line, tree.Act):
        return dict(ROWS.get(line.phrases[0].words[0].span.text, {}))
    return {"face": FACE, "life": KNOBS, "film": FILM}.get(line.kind, {})


def _named(analysis: Analysis, nodes: list[Any], name: tree.Name | tree.Dotted) -> str | None:
    """What a name stands for: a parameter, a statement, a definition, a muscle or channel, a word of the language."""
    text = spelled(name)
    first = text.partition(".")[0]
    head = nodes[0]
    if isinstance(head, tree.ActionDefinition | tree.ExpressionDefinition):
        for parameter in head.parameters:
            if parameter.name.text == first:
                return f"`{parameter.span.text}`: parameter of `{head.name.text}`"
    for label, act in labels(around(analysis, name.span.start), name.span.start):
        if label == first:
            times = "\n\n".join(_of_act(analysis, act))
            return f"{code(act.span.text.split(chr(10))[0])}\n\n{times}".rstrip()
    if text in PRIMITIVES:
        return primitive_text(text)
    project = project_of(analysis)
    definition = project.names.find(first)
    if definition is not None:
        return definition_text(project, definition)
    return word_text(first)


# ------------------------------------------------------------------------------------------------ when it is


def _times(analysis: Analysis, nodes: list[Any], word: Span) -> Iterator[str]:
    """The solved times of a statement, told at its verb and in its text."""
    act = next((node for node in reversed(nodes) if isinstance(node, tree.Act)), None)
    if act is None:
        return
    first = act.phrases[0].words[0].span
    if first == word or isinstance(nodes[-1], tree.String):
        yield from _of_act(analysis, act)


def _of_act(analysis: Analysis, act: tree.Act) -> Iterator[str]:
    score = analysis.compiled.score
    if score is None:
        return
    acts = [timed for timed in score.acts if timed.span == act.span]
    for timed in islice(acts, MOST_TIMES):
        yield _told(timed)
    if len(acts) > MOST_TIMES:
        yield f"and {len(acts) - MOST_TIMES} times more"
    lines = (line for line in score.lines if line.span == act.span)
    for line in islice(lines, 1):
        about = "about " if score.estimated else ""
        voice = next((face.voice for face in score.faces if face.name == line.face), None)
        spoken = f", voice {' '.join(filter(None, (voice.language, voice.variant)))}" if voice else ""
        yield f"Speaks for {about}{line.end - line.start:.2f} s{spoken}."


def _told(timed: TimedAct) -> str:
    """`starts 2.31 s, settled 2.60 s, ends 4.00 s`; "about" where a line's length is estimated."""
    about = "about " if timed.estimated else ""
    end = "until replaced" if timed.end == FOREVER else f"ends {timed.end:.2f} s"
    return f"starts {about}{timed.start:.2f} s, settled {timed.settled:.2f} s, {end}"


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_HOVER)
    def asked(_: FaceServer, params: types.HoverParams) -> types.Hover | None:
        uri = params.text_document.uri
        return hover(server.desk.analysis(uri), params.position) if uri in server.workspace.text_documents else None
