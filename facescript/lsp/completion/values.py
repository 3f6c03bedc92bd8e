"""A place where a value is written to the values that fit: sums, quantities, what an argument is used for."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.lsp.completion import offers
from facescript.lsp.completion.here import Here
from facescript.lsp.completion.offers import Offer
from facescript.lsp.vocabulary import is_quantity, kind_of_face
from facescript.resolve.faces import GAZES
from facescript.resolve.film import SCREENS
from facescript.resolve.kinds.library import kind_names, library_head
from facescript.resolve.looks import COLOURS
from facescript.resolve.names import Definition
from facescript.resolve.units import ANGLE, COUNT, RATE, SHARE, TIME, UNITS
from facescript.resolve.words import EASES, Modifier
from facescript.syntax import tree

SUFFIXES = {
    "use": (".face",),
    "text": (".txt", ".md"),
    "ssml": (".ssml", ".xml"),
    "from": (".wav", ".mp3", ".flac", ".ogg", ".opus", ".m4a"),
    "timed": (".textgrid", ".json", ".vtt", ".srt", ".csv", ".tsv"),
    "play": (".csv", ".fap"),
    "background": (".png", ".jpg", ".jpeg", ".webp", ".gif", ".bmp"),
    "picture": (".png", ".jpg", ".jpeg", ".webp", ".gif"),
}
"""Files by the word that they stand behind."""

QUANTITIES = (TIME, SHARE, RATE, ANGLE, COUNT)


def in_sum(here: Here) -> Iterator[Offer]:
    """The terms of a sum, where one may begin; behind one, what its degree may be."""
    last = here.before.tokens[-1] if here.before.tokens else None
    if last is None or last[0] in ("OPERATOR", "EQUAL", "LPAR") or last[1] in ("show", "add", "=", "+", "-", "("):
        yield from offers.terms(here.project, here.before.word)
        yield from here.bound()
    else:
        yield from time_values(here, SHARE)


def time_values(here: Here, kind: str) -> Iterator[Offer]:
    """Names of quantities of a kind, and a number that has begun with its units."""
    for each in here.project.names.all("let"):
        if is_quantity(each, kind):
            yield offers.defined_as(each, each.name)
    yield from here.bound()
    number = here.before.word.rstrip("/%abcdefghijklmnopqrstuvwxyz")
    if number:
        yield from offers.units(number, kind)


def anything(here: Here) -> Iterator[Offer]:
    """What may stand where nobody knows what is wanted."""
    yield from offers.terms(here.project, here.before.word)
    yield from offers.defined(here.project, "let")
    yield from here.bound()


def aimed(here: Here) -> Iterator[Offer]:
    yield from offers.aims(here.project, here.faces(), here.looker(), here.people())
    yield from here.bound()


def argument(here: Here, action: Definition, name: str) -> Iterator[Offer]:
    """What an argument of an action may be, by how its body uses it."""
    node = action.node
    assert isinstance(node, tree.ActionDefinition)
    default = next((each.default for each in node.parameters if each.name.text == name), None)
    first = default.words[0] if default is not None and default.words else None
    if isinstance(first, tree.Quantity):
        yield from time_values(here, next((kind for kind in QUANTITIES if _is_of(first, kind)), ""))
        return
    uses = set(_uses(node.body, name))
    if uses & {"at", "glance"}:
        yield from aimed(here)
        yield from offers.directions()
    elif not uses & {"say", "text"}:
        yield from anything(here)


def _is_of(word: tree.Quantity, kind: str) -> bool:
    return word.unit in UNITS and UNITS[word.unit].kind == kind


def _uses(body: tuple[tree.Statement, ...], name: str) -> Iterator[str]:
    """The words directly before a name in the lines of a block."""
    for statement in body:
        if not isinstance(statement, tree.Act):
            yield from _uses(statement.body, name)
            continue
        for phrase in statement.phrases:
            for before, word in zip(phrase.words, phrase.words[1:], strict=False):
                if isinstance(word, tree.Name) and word.text == name:
                    yield before.span.text
        for on in statement.ons:
            yield from _uses(on.body, name)


# ------------------------------------------------------------------------------------------------ modifiers


def value_of(here: Here, row: Modifier, said: tuple[str, ...]) -> Iterator[Offer]:
    """What a modifier's value may be; `said` are the words of it that are there."""
    if row.takes == "voice":
        yield from offers.voices(said)
    elif row.takes == "look":
        yield from _looks(here, row.name, said)
    elif row.takes in QUANTITIES:
        yield from time_values(here, row.takes)
    elif said:
        return
    elif row.takes == "value" and (action := here.project.names.find(here.before.words[0])) is not None:
        yield from argument(here, action, row.name)
    elif row.takes == "life":
        yield from offers.defined(here.project, "life")
    else:
        yield from offers.plain({"ease": EASES, "gaze": GAZES, "screen": tuple(SCREENS)}.get(row.takes, ()))


def _looks(here: Here, name: str, said: tuple[str, ...]) -> Iterator[Offer]:
    """The choices and the colours of a look that the kind of the face around has."""
    kind = _kind_around(here)
    if kind not in kind_names():
        return
    head = library_head(kind)
    choices = dict(head.looks).get(name, ())
    tints = [tint.name for tint in dict(head.tints).get(COLOURS.get(name, name), ())]
    if not said:
        yield from (Offer(choice, "look", f"{name} of a {kind}") for choice in choices)
    if not set(said) & set(tints):
        yield from (Offer(tint, "colour", f"a colour of {name}") for tint in tints if tint not in choices)


def _kind_around(here: Here) -> str:
    """The kind of the face whose definition is written here."""
    line = here.before.tokens if here.before.words[:1] == ("face",) else here.blocks[0] if here.blocks else ()
    words = [token[1] for token in line]
    kind = words[words.index("=") + 1] if "=" in words[:-1] else ""
    found = here.project.names.written.get(kind)
    return kind if found is None or found.kind != "kind" else kind_of_face(found)
