"""Words, texts and lines to the names that they mention."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from facescript.diagnostics.model import Diagnostics
from facescript.lsp.names.model import AIM, EVERY, GLOBAL, SPOKEN, TIME, VALUE, Mention, Reach, Sight, Space, first_part
from facescript.resolve.blocks import ROWS
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.lines import match, segments
from facescript.resolve.reader import spelled
from facescript.resolve.words import DIRECT, MODIFIERS, WORDS, Modifier
from facescript.syntax.parser import parse_phrases
from facescript.syntax.tree import Act, Bracket, Call, Dotted, Name, Phrase, String, Word
from facescript.text import Span

HEADS: Mapping[str, Reach] = {
    **dict.fromkeys(("look", "glance", "scan"), AIM),
    **dict.fromkeys(("show", "add", "view", "life"), VALUE),
    **dict.fromkeys(("say", "background", "picture", "link"), SPOKEN),
    **dict.fromkeys(("nod", "shake", "tilt", "blink", "wink", "wait"), TIME),
    "drop": EVERY,
    "play": GLOBAL,
}
"""Which local names the words behind a verb may mean."""

NAMELESS = ("ease", "voice", "look", "gaze", "text", "size", "frame rate")
"""Kinds of values (`Modifier.takes`) whose words are no names of the script."""

_BRACKET = re.compile(r"\\.|\[([^\[\]]*)\]", re.DOTALL)

# ------------------------------------------------------------------------------------------------ words


def read(sight: Sight, words: Iterable[Word], reach: Reach, *, label_first: bool = False) -> None:
    """Notes the names in the words of a value."""
    for word in words:
        if isinstance(word, Name):
            _name(sight, word, reach, label_first)
        elif isinstance(word, Dotted):
            _dotted(sight, word, reach)
        elif isinstance(word, Call):
            call(sight, word)
        elif isinstance(word, Bracket):
            read(sight, word.inner.words, reach)
        elif isinstance(word, String):
            text(sight, word)


def _name(sight: Sight, word: Name, reach: Reach, label_first: bool) -> None:
    if word.text not in PRIMITIVES or sight.local(word.text, reach) is not None:
        sight.mention(word.text, word.span, reach, label_first=label_first)


def _dotted(sight: Sight, word: Dotted, reach: Reach) -> None:
    """`smile.left`, `crowd.2`, `trial.cue`, `hello."cup".2.end`: the first part is the name."""
    if spelled(word) in PRIMITIVES:
        return
    local = sight.mention(str(word.parts[0]), first_part(word.span), reach)
    if local is None:
        return
    rest = _second_part(word.span)
    if local.kind == "label" and word.quoted[1]:
        nth = word.parts[2] if len(word.parts) > 2 else 1
        number = nth if isinstance(nth, int) else 1
        sight.found.append(Mention(str(word.parts[1]), rest, "word", local, nth=number))
    elif local.kind == "row":
        space: Space = "spoken" if "text" in reach else "column"
        sight.found.append(Mention(str(word.parts[1]), rest, space, local))


def _second_part(span: Span) -> Span:
    """The span of what stands between the first point and the second, points in quotes left alone."""
    start = span.text.index(".") + 1
    quoted = span.text.startswith('"', start)
    end = span.text.find('"', start + 1) + 1 if quoted else span.text.find(".", start)
    return Span(span.source, span.start + start, span.start + end if end > 0 else span.end)


def call(sight: Sight, word: Call) -> None:
    """`crooked(lift = 60%)`: an expression of the project, and its parameters by their names."""
    sight.mention(word.name.text, word.name.span, GLOBAL)
    for argument in word.arguments:
        if argument.name is not None:
            _argument(sight, argument.name, word.name.text)
        read(sight, argument.value.words, TIME)


def _argument(sight: Sight, name: Name, owner: str) -> None:
    sight.found.append(Mention(name.text, name.span, "argument", owner=owner))


def path(sight: Sight, word: Word, space: Space = "file") -> None:
    """Notes a file that a script names."""
    if isinstance(word, String):
        sight.found.append(Mention(word.value, word.span, space))


# ------------------------------------------------------------------------------------------------ texts


def text(sight: Sight, string: String) -> None:
    """Notes the names in the brackets of a text."""
    source, start = string.span.source, string.span.start + 1
    for found in _BRACKET.finditer(string.value):
        inner = found[1]
        if inner is None or inner.strip() == "/" or inner.split()[:1] == ["read"]:
            continue
        span = Span(source, start + found.start(1), start + found.end(1))
        phrases = parse_phrases(span, Diagnostics())
        if phrases and phrases[0].words:
            line(sight, phrases)


# ------------------------------------------------------------------------------------------------ lines


def line(sight: Sight, phrases: tuple[Phrase, ...], act: Act | None = None) -> None:
    """Notes the names of a line, or of a bracket in a text (then without `act`)."""
    parts = [words for phrase in phrases for words in segments(phrase.words) if words]
    if not parts:
        return
    first = parts[0][0]
    verb = first.text if isinstance(first, Name) else ""
    if verb in HEADS:
        _head(sight, verb, parts[0][1:])
        for words in parts[1:]:
            modifier(sight, words, ROWS[verb], act)
        return
    read(sight, (first,), GLOBAL)
    read(sight, parts[0][1:], EVERY)
    for words in parts[1:]:
        _given(sight, words, verb, act)


def _head(sight: Sight, verb: str, words: tuple[Word, ...]) -> None:
    first = words[0] if words else None
    if verb == "say" and isinstance(first, Name) and first.text in ("text", "ssml") and len(words) > 1:
        path(sight, words[1], "text" if first.text == "text" else "file")
    elif verb == "say":
        read(sight, words, HEADS[verb])
    else:
        _silent(sight, words, HEADS[verb], verb == "drop")


def _silent(sight: Sight, words: tuple[Word, ...], reach: Reach, label_first: bool = False) -> None:
    """Words of which strings are no texts that are spoken."""
    read(sight, (word for word in words if not isinstance(word, String)), reach, label_first=label_first)


def modifier(sight: Sight, words: tuple[Word, ...], rows: Mapping[str, Modifier], act: Act | None = None) -> None:
    """Notes the names in one modifier of a line."""
    row, value = match(words, rows)
    if row is None:
        _silent(sight, words, EVERY)
    elif row.takes == "name":
        _label(sight, value, act)
    elif row.takes == "file" and value:
        path(sight, value[0])
    elif row.takes not in NAMELESS:
        _silent(sight, value, TIME)


def _given(sight: Sight, words: tuple[Word, ...], owner: str, act: Act | None) -> None:
    """A modifier behind an action's name, which is a parameter's, or behind a sum that stands in a text."""
    first = words[0]
    if not isinstance(first, Name) or first.text in DIRECT:
        modifier(sight, words, MODIFIERS, act)
    elif len(words) > 1 and first.text not in WORDS:
        _argument(sight, first, owner)
        read(sight, words[1:], EVERY)


def _label(sight: Sight, value: tuple[Word, ...], act: Act | None) -> None:
    name = value[0] if value else None
    local = sight.labels.get(name.text) if isinstance(name, Name) else None
    if not isinstance(name, Name) or local is None:
        return
    if local.span == name.span:
        local.act = act
    sight.found.append(Mention(name.text, name.span, local=local, defines="label"))
