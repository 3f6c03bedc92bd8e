"""Statements to nodes: lines by their verbs, blocks by their kinds, actions and tables unfolded on the way."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

from facescript.ir.acts import At, Choose, Cue, Do, Node, Say, Sequence, Together, Verb
from facescript.resolve import background, beside, gaze, shows, speech, stage, takes
from facescript.resolve.actions import call
from facescript.resolve.lines import Line
from facescript.resolve.marks import check_word
from facescript.resolve.mixes import is_shown
from facescript.resolve.place import Place, doer, face_named
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import spelled
from facescript.resolve.repeats import repeat
from facescript.resolve.suggest import replace
from facescript.resolve.sums import moment
from facescript.resolve.texts import Inline
from facescript.resolve.words import ENDINGS, MODIFIERS, SYNONYMS, VERBS, Modifier
from facescript.syntax import tree
from facescript.text import Span

Handler = Callable[[Project, Line, Place], Verb]

HANDLERS: dict[str, Handler] = {
    "look": gaze.look,
    "glance": gaze.glance,
    "scan": gaze.scan,
    "show": shows.show,
    "add": shows.add,
    "drop": shows.drop,
    **dict.fromkeys(shows.POSES, shows.gesture),
    "play": takes.play,
    "wait": stage.wait,
    "background": background.background,
    "view": stage.view,
    "life": stage.life,
    "picture": beside.picture,
    "link": beside.link,
}

ROWS: dict[str, Mapping[str, Modifier]] = {
    verb.name: {name: MODIFIERS[name] for name in verb.modifiers} for verb in VERBS.values()
}


def statements(project: Project, body: tuple[tree.Statement, ...], place: Place) -> tuple[Node, ...]:
    """The nodes of a block. A statement with a fault is left out, its fault reported."""
    nodes = []
    for statement in body:
        project.spend(statement.span, _length(statement))
        with suppress(Refused), project.deeper(statement.span):
            nodes.append(_READERS[type(statement)](project, statement, place))
    return tuple(nodes)


def _length(statement: tree.Statement) -> int:
    """Characters of a line, with what hangs under it; what a block holds is counted by itself."""
    return statement.span.end - statement.span.start if isinstance(statement, tree.Act) else 0


def block(project: Project, body: tuple[tree.Statement, ...], place: Place, span: Span) -> Sequence:
    return Sequence(statements(project, body, place), span)


# ------------------------------------------------------------------------------------------------ blocks


def _cast(project: Project, statement: tree.Cast, place: Place) -> Node:
    face = face_named(project, statement.face, place.cast, ("together", "choose", "repeat", "at", "in", "on", "when"))
    inner = statements(project, statement.body, place.by(face))
    if len(inner) == len(statement.body) == 1:
        return inner[0]
    return Sequence(inner, statement.span)


def _group(project: Project, statement: tree.Group, place: Place) -> Node:
    items = statements(project, statement.body, place)
    if statement.kind == "together":
        return Together(items, statement.span)
    if statement.kind == "choose":
        return Choose(items, statement.span)
    return Sequence(items, statement.span)


def _repeat(project: Project, statement: tree.Repeat, place: Place) -> Node:
    return repeat(project, statement, place, statements)


def _moment(project: Project, statement: tree.Moment, place: Place) -> Node:
    time = None
    with suppress(Refused):
        time = moment(project, statement.time.words, place.scope, statement.time.span)
    body = block(project, statement.body, place, statement.span)
    if time is None:
        raise Refused
    return At(time, body, statement.span)


# ------------------------------------------------------------------------------------------------ lines


def _act(project: Project, act: tree.Act, place: Place) -> Node:
    return _line(project, act.phrases, act.span, place, act)


def _line(
    project: Project, phrases: tuple[tree.Phrase, ...], span: Span, place: Place, act: tree.Act | None = None
) -> Node:
    """A line, or the words of a bracket inside a text (then without `act`)."""
    word = phrases[0].words[0]
    verb = word.text if isinstance(word, tree.Name) else ""
    if verb in HANDLERS:
        face = doer(project, verb, place, span)
        line = Line(project, verb, phrases, ROWS[verb], place.scope)
        return _done(project, HANDLERS[verb](project, line, place), face, line, span)
    if verb == "say" and act is not None:
        return _say(project, act, place)
    definition = project.names.find(verb) if verb else None
    if definition is not None and definition.kind == "action":
        return call(project, definition, phrases, span, place, statements)
    raise _no_verb(project, word, phrases, verb)


def _done(project: Project, verb: Verb, face: str | None, line: Line, span: Span) -> Do:
    label = line.name("as")
    full = line.scope.label(label.text) if label is not None else None
    if full is not None:
        project.lines[full] = verb if isinstance(verb, Say) else None
    return Do(verb, face, full, span)


def _say(project: Project, act: tree.Act, place: Place) -> Node:
    face = doer(project, "say", place, act.span)
    line = Line(project, "say", act.phrases, ROWS["say"], place.scope)
    said, inlines = speech.say(project, line, place, act.more)
    cues = _inline_cues(project, inlines, len(said.text), place) + _word_cues(project, act, said, place)
    return _done(project, dataclasses.replace(said, cues=cues), face, line, act.span)


def _inline_cues(project: Project, inlines: tuple[Inline, ...], length: int, place: Place) -> tuple[Cue, ...]:
    cues = []
    for inline in inlines:
        try:
            project.spend(inline.span)
            _nameless(project, inline)
            bare = _is_bare(project, inline)
            phrases = _with_add(inline) if bare else inline.phrases
            node = _line(project, phrases, inline.span, place.within(inline.scope))
        except Refused:
            continue
        until = length if bare and inline.until is None else inline.until
        cues.append(Cue(Sequence((node,), inline.span), at=inline.at, until=until))
    return tuple(cues)


def _nameless(project: Project, inline: Inline) -> None:
    """Refuses a name given inside a text: names are known before texts are read."""
    for phrase in inline.phrases:
        for word in phrase.words:
            if isinstance(word, tree.Name) and word.text == "as":
                advice = 'only a statement of its own is named; write it under the line with `on "word":`'
                raise project.refuse("FS312", word.span, text="as", advice=advice)


def _is_bare(project: Project, inline: Inline) -> bool:
    """Whether a bracket holds a sum without a verb, which is then `add`."""
    word = inline.phrases[0].words[0]
    return not (isinstance(word, tree.Name) and word.text in VERBS) and (
        isinstance(word, tree.Bracket) or is_shown(project, word)
    )


def _with_add(inline: Inline) -> tuple[tree.Phrase, ...]:
    first = inline.phrases[0]
    verb = tree.Name("add", first.span)
    return (tree.Phrase((verb, *first.words), first.span), *inline.phrases[1:])


def _word_cues(project: Project, act: tree.Act, said: Say, place: Place) -> tuple[Cue, ...]:
    cues = []
    spoilt = project.is_spoilt(act.span)
    for on in act.ons:
        fits = spoilt or check_word(project, said, on.word.value, on.nth, on.word.span)
        body = block(project, on.body, place, on.span)
        if fits:
            cues.append(Cue(body, word=on.word.value, nth=on.nth))
    return tuple(cues)


def _no_verb(project: Project, word: tree.Word, phrases: tuple[tree.Phrase, ...], verb: str) -> Refused:
    """Refuses a line that begins with no verb: a sum without `show`, another language's word, a slip."""
    whole = phrases[0].span.to(phrases[-1].span)
    if verb in ENDINGS:
        return project.refuse("FS227", word.span, word=verb)
    if verb == "say":
        return project.refuse("FS312", whole, text=whole.text, advice="a line cannot stand inside a line")
    if is_shown(project, word):
        fix = (replace(word.span, f"show {word.span.text}"),)
        return project.refuse("FS221", whole, fixes=fix, text=whole.text)
    if not isinstance(word, tree.Name | tree.Dotted | tree.Call):
        return project.refuse("FS312", word.span, text=word.span.text, advice="a line begins with a verb")
    name = word.name.text if isinstance(word, tree.Call) else spelled(word)
    known = [*VERBS, *project.names.known("action"), "together", "choose", "repeat", *project.names.known("expression")]
    clause, fixes = project.meant(name, known, word.span)
    if name in SYNONYMS and name not in project.spoilt:
        return project.refuse(
            "FS222", word.span, fixes=(replace(word.span, SYNONYMS[name]),), name=name, verb=SYNONYMS[name]
        )
    if not fixes and project.names.find(name) is not None:
        clause = "; a line begins with what is done."
    if name not in project.spoilt:
        project.report("FS204", word.span, fixes=fixes, name=name, meant=clause)
    return Refused()


_READERS: dict[type, Callable[[Project, Any, Place], Node]] = {
    tree.Act: _act,
    tree.Cast: _cast,
    tree.Group: _group,
    tree.Repeat: _repeat,
    tree.Moment: _moment,
}
