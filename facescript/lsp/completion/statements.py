"""A place in a statement to what may follow: what its verb is about, its modifiers, their values, its arguments."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

from facescript.lsp.completion import offers
from facescript.lsp.completion.here import Here
from facescript.lsp.completion.offers import Offer
from facescript.lsp.completion.values import aimed, anything, argument, in_sum, time_values, value_of
from facescript.lsp.vocabulary import parameters_of
from facescript.resolve.actions import rows_of
from facescript.resolve.blocks import ROWS
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.reader import spelled
from facescript.resolve.units import ANGLE, SHARE, TIME
from facescript.resolve.words import DIRECT, DIRECTIONS, NOTHING, VALUE, VERBS, Modifier
from facescript.syntax import tree
from facescript.syntax.spacing import Token

Words = tuple[str, ...]
Rows = Mapping[str, Modifier]


@dataclass(frozen=True, slots=True)
class Part:
    """A stretch of a line: its words, and whether a comma stands before it."""

    words: Words
    comma: bool


def parts_of(tokens: Iterable[Token]) -> list[Part]:
    """A line cut at its commas and before its direct modifiers; the last part may be empty."""
    parts: list[tuple[list[str], bool]] = [([], False)]
    depth = 0
    for kind, text, _, _ in tokens:
        depth += (kind in ("LPAR", "_OPEN")) - (kind == "RPAR")
        if depth == 0 and kind == "COMMA":
            parts.append(([], True))
            continue
        if depth == 0 and text in DIRECT and kind == "NAME" and parts[-1][0]:
            parts.append(([], False))
        parts[-1][0].append(text)
    return [Part(tuple(words), comma) for words, comma in parts]


def in_verb(here: Here) -> Iterator[Offer]:
    """What may follow in a line that begins with a verb, or with the name of an action."""
    tokens = here.before.tokens
    called = open_call(tokens)
    if called is not None:
        yield from _in_call(here, tokens[called:])
        return
    name = here.before.words[0]
    action = here.project.names.find(name)
    if name in VERBS and name in ROWS:
        yield from _line(here, ROWS[name], _HEADS.get(name, _no_head))
        if tokens[-1][0] in ("QUANTITY", "INTEGER") and here.before.words[-2] != "to":
            yield from offers.plain(("to",))
    elif action is not None and isinstance(action.node, tree.ActionDefinition):
        yield from _line(here, rows_of(action.node), _first_argument)


def settings(here: Here, called: str, rows: Rows, tokens: Iterable[Token]) -> Iterator[Offer]:
    """What may follow in the settings of a face, a film or a life."""
    parts = parts_of(tokens)
    yield from _modifiers(here, rows, parts, parts[-1])


def _line(here: Here, rows: Rows, head: Callable[[Here, Words], Iterator[Offer]]) -> Iterator[Offer]:
    parts = parts_of(here.before.tokens)
    if len(parts) > 1:
        yield from _modifiers(here, rows, parts, parts[-1])
        return
    found = list(head(here, parts[0].words[1:]))
    yield from (offer for offer in found if offer is not WHOLE)
    if WHOLE in found:
        yield from offers.modifiers(rows.values(), (), True)


WHOLE = Offer("", "whole")
"""Among what may follow in a head: it may end here, so that a modifier may follow."""


# ------------------------------------------------------------------------------------------------ modifiers


def _modifiers(here: Here, rows: Rows, parts: list[Part], part: Part) -> Iterator[Offer]:
    """What may follow in the last part of a line, which is a modifier's."""
    taken = set(_taken(rows, parts[:-1]))
    if not part.words:
        yield from offers.modifiers(rows.values(), taken, False)
        if here.before.word[:1].isdecimal():
            yield from offers.units(here.before.word.rstrip("%/abcdefghijklmnopqrstuvwxyz"), "")
        return
    for row in rows.values():
        if not {row.name, row.group} & taken:
            yield from _rest(here, row, part.words)
    found = row_of(rows, part.words)
    if found is not None and found.name != "as" and _is_whole(found, part.words):
        yield from offers.modifiers(rows.values(), taken | {found.name, found.group or found.name}, True)


def _rest(here: Here, row: Modifier, words: Words) -> Iterator[Offer]:
    """What is missing of a modifier, of which some words are there."""
    lead = row.pattern.index(VALUE) if VALUE in row.pattern else len(row.pattern)
    if len(words) < lead:
        if row.pattern[: len(words)] == words:
            yield Offer(" ".join(row.pattern[len(words) : lead]), "modifier", row.help)
    elif row.pattern[:lead] == words[:lead] and VALUE in row.pattern:
        tail = row.pattern[lead + 1 :]
        if lead or tail:
            yield from value_of(here, row, words[lead:]) if lead else ()
            if tail and len(words) > lead and words[-1][:1].isdecimal():
                yield Offer(" ".join(tail), "modifier", row.help)


def _is_whole(row: Modifier, words: Words) -> bool:
    lead = row.pattern.index(VALUE) if VALUE in row.pattern else len(row.pattern)
    return len(words) > lead if VALUE in row.pattern else words == row.pattern


def _taken(rows: Rows, parts: Iterable[Part]) -> Iterator[str]:
    for part in parts:
        if (row := row_of(rows, part.words)) is not None:
            yield row.name
            yield row.group or row.name


def row_of(rows: Rows, words: Words) -> Modifier | None:
    """The modifier that words begin or end as."""
    for row in sorted(rows.values(), key=lambda row: -len(row.pattern)):
        lead = row.pattern[: row.pattern.index(VALUE)] if VALUE in row.pattern else row.pattern
        tail = row.pattern[len(lead) + 1 :]
        if lead and words[: len(lead)] == lead and (VALUE in row.pattern or words == lead):
            return row
        if not lead and tail and words[-len(tail) :] == tail:
            return row
    return None


# ------------------------------------------------------------------------------------------------ what verbs are about


def _look(here: Here, words: Words) -> Iterator[Offer]:
    if not words:
        yield from offers.plain(("at", *DIRECTIONS, "away"))
    elif words == ("at",):
        yield from aimed(here)
    else:
        yield from _turned(here, words)


def _glance(here: Here, words: Words) -> Iterator[Offer]:
    if not words:
        yield from aimed(here)
        yield from offers.plain((*DIRECTIONS, "away"))
    else:
        yield from _turned(here, words)


def _turned(here: Here, words: Words) -> Iterator[Offer]:
    if words[0] in DIRECTIONS:
        yield from offers.directions(words)
        yield from time_values(here, ANGLE)
    yield WHOLE


def _scan(here: Here, words: Words) -> Iterator[Offer]:
    if not words:
        yield from offers.crowds(here.project, here.people())
        yield from here.bound()
    else:
        yield WHOLE


def _show(here: Here, words: Words) -> Iterator[Offer]:
    yield from in_sum(here)
    if words and words[-1] not in ("+", "-", "*", "/", "to"):
        yield WHOLE


def _drop(here: Here, words: Words) -> Iterator[Offer]:
    if words:
        yield WHOLE
        return
    for name, act in here.labels():
        if _lays(act):
            yield Offer(name, "label", " ".join(act.span.text.split()))
    known = {*PRIMITIVES, *here.project.names.known("expression")}
    for name in sorted(known.intersection(_shown(here.items))):
        yield Offer(name, "expression", "is shown or added")


def _lays(act: tree.Act) -> bool:
    verb = act.phrases[0].words[0]
    return isinstance(verb, tree.Name) and verb.text in ("show", "add", "play")


def _shown(items: Iterable[object]) -> Iterator[str]:
    """The names in what `show` and `add` lay on faces anywhere in the script."""
    for item in items:
        if isinstance(item, tree.Act):
            if _lays(item):
                words = item.phrases[0].words[1:]
                yield from (spelled(word) for word in words if isinstance(word, tree.Name | tree.Dotted))
        elif hasattr(item, "body"):
            yield from _shown(item.body)


def _gesture(here: Here, words: Words) -> Iterator[Offer]:
    yield from time_values(here, SHARE)
    yield WHOLE


def _sided(here: Here, words: Words) -> Iterator[Offer]:
    yield from offers.plain(DIRECTIONS[:2]) if not words else _gesture(here, words)


def _say(here: Here, words: Words) -> Iterator[Offer]:
    if not words:
        yield from offers.plain(("text", "ssml", "from", "timed"))
        yield from here.bound()
    else:
        yield WHOLE


def _play(here: Here, words: Words) -> Iterator[Offer]:
    if words:
        yield WHOLE
    else:
        yield from here.bound()


def _wait(here: Here, words: Words) -> Iterator[Offer]:
    if not words:
        yield from offers.plain(("until",))
    elif words[0] == "until":
        yield from here.moments()
    else:
        yield WHOLE
    yield from time_values(here, TIME)


def _background(here: Here, words: Words) -> Iterator[Offer]:
    if not words or words[-1] == "to":
        yield from offers.plain((NOTHING,)) if not words else ()
        for each in here.project.names.all("let"):
            node = each.node
            if isinstance(node, tree.LetDefinition) and isinstance(node.value.words[0], tree.Colour):
                yield offers.defined_as(each, each.name)
    else:
        yield from offers.plain(("to",))
        yield WHOLE


def _view(here: Here, words: Words) -> Iterator[Offer]:
    if words:
        yield from time_values(here, SHARE)
        yield WHOLE
        return
    yield from offers.plain(("all",))
    for each in here.project.names.all("face"):
        if each.name in here.faces():
            yield offers.defined_as(each, each.name)


def _life(here: Here, words: Words) -> Iterator[Offer]:
    if words:
        yield WHOLE
    else:
        yield from offers.defined(here.project, "life")


def _picture(here: Here, words: Words) -> Iterator[Offer]:
    yield from offers.plain((NOTHING,)) if not words else (WHOLE,)


def _no_head(here: Here, words: Words) -> Iterator[Offer]:
    yield WHOLE


_HEADS: Mapping[str, Callable[[Here, Words], Iterator[Offer]]] = {
    "look": _look,
    "glance": _glance,
    "scan": _scan,
    "show": _show,
    "add": _show,
    "drop": _drop,
    "nod": _gesture,
    "shake": _gesture,
    "blink": _gesture,
    "tilt": _sided,
    "wink": _sided,
    "say": _say,
    "play": _play,
    "wait": _wait,
    "background": _background,
    "view": _view,
    "life": _life,
    "picture": _picture,
}


# ------------------------------------------------------------------------------------------------ arguments


def _first_argument(here: Here, words: Words) -> Iterator[Offer]:
    action = here.project.names.find(here.before.words[0])
    if action is None or words or not parameters_of(action):
        yield WHOLE
        return
    yield from argument(here, action, parameters_of(action)[0].name.text)


def open_call(tokens: Collection[Token]) -> int | None:
    """The place of the name whose bracket is still open, the innermost; None where there is none."""
    opened: list[int] = []
    for place, (kind, *_) in enumerate(tokens):
        if kind in ("_OPEN", "LPAR"):
            opened.append(place if kind == "LPAR" else place - 1)
        elif kind == "RPAR" and opened:
            opened.pop()
    return opened[-1] if opened else None


def _in_call(here: Here, tokens: tuple[Token, ...]) -> Iterator[Offer]:
    """What may stand in the brackets of a call, or in brackets of a sum."""
    if tokens[0][0] == "LPAR":
        yield from anything(here)
        return
    expression = here.project.names.find(tokens[0][1])
    last = tokens[-1][1]
    if last in ("(", ",") and expression is not None:
        given = {token[1] for token in tokens}
        for each in parameters_of(expression):
            if each.name.text not in given:
                yield Offer(f"{each.name.text} =", "parameter", each.span.text)
    yield from time_values(here, SHARE)
