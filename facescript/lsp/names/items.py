"""The items of a script, definitions and statements, to the names that they mention, each seen from where it stands."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from facescript.lsp.names.model import AIM, EVERY, GLOBAL, TIME, VALUE, Local, Mention, Sight
from facescript.lsp.names.words import line, modifier, path, read
from facescript.resolve.events import TEXTUAL
from facescript.resolve.film import SCREENS
from facescript.resolve.labels import named
from facescript.resolve.lines import segments
from facescript.resolve.lives import ROWS as KNOBS
from facescript.resolve.words import FACE, FILM, WORDS
from facescript.syntax import tree


@dataclass(frozen=True, slots=True)
class Opened:
    """An item as far as its block: the names before it, what can be seen in it, and its statements."""

    head: list[Mention]
    sight: Sight
    body: tuple[tree.Statement, ...] = ()


def opened(item: tree.Item, labels: dict[str, Local]) -> Opened:
    """The names of an item; those of a scene, an action or a reaction as far as its block, which may be long.

    `labels` are those that can be seen from it.
    """
    sight = Sight([], {}, labels)
    open_block = _BLOCKS.get(type(item))
    if open_block is None:
        _READERS[type(item)](sight, item)
        return Opened(sight.found, sight)
    inner = open_block(sight, item)
    assert isinstance(item, tree.Scene | tree.When | tree.ActionDefinition)
    return Opened(sight.found, inner, item.body)


def mentions(block: Opened, number: int) -> list[Mention]:
    """The names in one statement of a block."""
    statement = block.body[number]
    sight = replace(block.sight, found=[])
    _READERS[type(statement)](sight, statement)
    return sight.found


def labels_of(body: Iterable[tree.Statement]) -> dict[str, Local]:
    """The labels of a scene, an action, a reaction or a pass of a repeat; of two of one name the first."""
    found: dict[str, Local] = {}
    for name in named(tuple(body)):
        found.setdefault(name.text, Local("label", name.text, name.span))
    return found


# ------------------------------------------------------------------------------------------------ statements


def _body(sight: Sight, body: tuple[tree.Statement, ...]) -> None:
    for statement in body:
        _READERS[type(statement)](sight, statement)


def _act(sight: Sight, act: tree.Act) -> None:
    line(sight, act.phrases, act)
    read(sight, act.more, EVERY)
    for on in act.ons:
        sight.found.append(Mention(on.word.value, on.word.span, "word", act=act, nth=on.nth))
        _body(sight, on.body)


def _cast(sight: Sight, statement: tree.Cast) -> None:
    sight.mention(statement.face.text, statement.face.span, GLOBAL)
    _body(sight, statement.body)


def _group(sight: Sight, statement: tree.Group) -> None:
    _body(sight, statement.body)


def _moment(sight: Sight, statement: tree.Moment) -> None:
    read(sight, statement.time.words, TIME)
    _body(sight, statement.body)


def _repeat(sight: Sight, statement: tree.Repeat) -> None:
    words = statement.how.words
    bindings: dict[str, Local] = {}
    if (
        len(words) >= 3
        and isinstance(words[0], tree.Name)
        and isinstance(words[1], tree.Name)
        and words[1].text == "in"
    ):
        table = words[2] if isinstance(words[2], tree.String) else None
        bindings = {words[0].text: Local("row", words[0].text, words[0].span, table=table)}
        sight.bind(bindings[words[0].text])
        _over(sight, words[2:])
    else:
        read(sight, words, VALUE)
    _body(sight.within(bindings, labels_of(statement.body)), statement.body)


def _over(sight: Sight, words: tuple[tree.Word, ...]) -> None:
    """What a repeat has a pass for: the members of a crowd, or the rows of a table."""
    for word in words:
        path(sight, word)
    read(sight, (word for word in words if not isinstance(word, tree.String)), AIM)


# ------------------------------------------------------------------------------------------------ definitions


def _parameters(sight: Sight, owner: tree.Name, parameters: tuple[tree.Parameter, ...]) -> dict[str, Local]:
    bindings: dict[str, Local] = {}
    for parameter in parameters:
        name = parameter.name
        local = bindings.setdefault(name.text, Local("parameter", name.text, name.span, owner.text))
        sight.bind(local)
        if parameter.default is not None:
            read(sight.outside(), parameter.default.words, GLOBAL)
    return bindings


def _expression(sight: Sight, node: tree.ExpressionDefinition) -> None:
    sight.define(node.name, "expression")
    bindings = _parameters(sight, node.name, node.parameters)
    read(Sight(sight.found, bindings), node.value.words, VALUE)


def _action(sight: Sight, node: tree.ActionDefinition) -> Sight:
    sight.define(node.name, "action")
    bindings = _parameters(sight, node.name, node.parameters)
    return Sight(sight.found, bindings, labels_of(node.body))


def _let(sight: Sight, node: tree.LetDefinition) -> None:
    sight.define(node.name, "let")
    read(sight.outside(), node.value.words, VALUE)


def _viseme(sight: Sight, node: tree.VisemeDefinition) -> None:
    sight.found.append(Mention(node.sound.value, node.sound.span, "sound", defines="viseme"))
    _values(sight, node.value.words)


def _use(sight: Sight, node: tree.Use) -> None:
    path(sight, node.path)


def _scene(sight: Sight, node: tree.Scene) -> Sight:
    sight.define(node.name, "scene", "scene")
    for face in node.faces:
        sight.mention(face.text, face.span, GLOBAL)
    return Sight(sight.found, {}, labels_of(node.body))


def _when(sight: Sight, node: tree.When) -> Sight:
    words = node.event.words
    bindings: dict[str, Local] = {}
    person = words[-1] if len(words) > 2 else None
    opener, before = words[0] if words else None, words[-2] if len(words) > 2 else None
    if isinstance(person, tree.Name) and _is(opener, "person") and _is(before, "as"):
        bindings[person.text] = Local("person", person.text, person.span)
        sight.bind(bindings[person.text])
    return Sight(sight.found, bindings, labels_of(node.body))


def _is(word: tree.Word | None, text: str) -> bool:
    return isinstance(word, tree.Name) and word.text == text


def _setting(sight: Sight, node: tree.Setting) -> None:
    if node.kind == "event":
        _event(sight, tuple(word for phrase in node.phrases for word in phrase.words))
        return
    for phrase in node.phrases:
        for words in segments(phrase.words):
            if not (_is(words[0], "screen") and any(_is(words[-1], screen) for screen in SCREENS)):
                modifier(sight.outside(), words, FILM)


def _event(sight: Sight, words: tuple[tree.Word, ...]) -> None:
    """`ann arrives at 2s`, `heard "no" at 3s`."""
    first = words[0] if words else None
    cut = next((index for index, word in enumerate(words) if _is(word, "at")), len(words))
    if isinstance(first, tree.Name) and first.text not in TEXTUAL:
        sight.mention(first.text, first.span, GLOBAL)
    _values(sight, words[cut + 1 :])


def _values(sight: Sight, words: Iterable[tree.Word]) -> None:
    """Values outside of all blocks, of which strings are no texts that are spoken."""
    read(sight.outside(), (word for word in words if not isinstance(word, tree.String)), VALUE)


# ------------------------------------------------------------------------------------------------ declarations


def _declaration(sight: Sight, node: tree.Declaration) -> None:
    sight.define(node.name, node.kind)
    _DECLARED[node.kind](sight, node)


def _face(sight: Sight, node: tree.Declaration) -> None:
    words = node.phrases[0].words if node.phrases else ()
    if words and isinstance(words[0], tree.Name):
        sight.found.append(Mention(words[0].text, words[0].span, "kind"))
    phrases = [words[1:], *(phrase.words for phrase in node.phrases[1:])]
    _settings(sight, [*phrases, *(phrase.words for row in node.lines for phrase in row)])


def _settings(sight: Sight, phrases: Iterable[tuple[tree.Word, ...]]) -> None:
    for words in phrases:
        for part in segments(words):
            if part:
                modifier(sight.outside(), part, FACE)


def _kind(sight: Sight, node: tree.Declaration) -> None:
    """Only the voice of a kind is of other definitions' values: all else is named in the kind itself."""
    voices = [row for row in node.lines if row and row[0].words and _is(row[0].words[0], "voice")]
    _settings(sight, [phrase.words for row in voices for phrase in row])


def _life(sight: Sight, node: tree.Declaration) -> None:
    for number, phrase in enumerate(node.phrases):
        first = phrase.words[0] if phrase.words else None
        if number == 0 and isinstance(first, tree.Name) and first.text not in KNOBS:
            sight.mention(first.text, first.span, GLOBAL)
        else:
            modifier(sight.outside(), phrase.words, KNOBS)


def _target(sight: Sight, node: tree.Declaration) -> None:
    words = node.phrases[0].words if node.phrases else ()
    if _is(words[0] if words else None, "from"):
        for word in words[1:]:
            path(sight, word)
        return
    _values(sight, (word for word in words if not (isinstance(word, tree.Name) and word.text in (*WORDS, "moves"))))
    for row in node.lines:
        _values(sight, (word for phrase in row for word in phrase.words))


_DECLARED: dict[str, Callable[[Sight, tree.Declaration], None]] = {
    "face": _face,
    "kind": _kind,
    "life": _life,
    "target": _target,
}

_READERS: dict[type, Callable[[Sight, Any], None]] = {
    tree.Act: _act,
    tree.Cast: _cast,
    tree.Group: _group,
    tree.Repeat: _repeat,
    tree.Moment: _moment,
    tree.ExpressionDefinition: _expression,
    tree.LetDefinition: _let,
    tree.VisemeDefinition: _viseme,
    tree.Declaration: _declaration,
    tree.Setting: _setting,
    tree.Use: _use,
}

_BLOCKS: dict[type, Callable[[Sight, Any], Sight]] = {
    tree.ActionDefinition: _action,
    tree.Scene: _scene,
    tree.When: _when,
}
"""What has a block of its own: each reads what stands before it, and gives what can be seen in it."""
