"""A place in a document to what may be written there: which list belongs where, by the words before it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import pairwise

from facescript.lsp.completion import offers
from facescript.lsp.completion.here import Here
from facescript.lsp.completion.offers import Offer
from facescript.lsp.completion.statements import in_verb, settings
from facescript.lsp.completion.values import SUFFIXES, anything, in_sum, time_values
from facescript.lsp.vocabulary import crowd_size
from facescript.resolve.blocks import HANDLERS
from facescript.resolve.events import PERSONAL, TEXTUAL
from facescript.resolve.kinds.library import kind_names
from facescript.resolve.kinds.words import ROWS as KIND_ROWS
from facescript.resolve.lives import ROWS as KNOBS
from facescript.resolve.place import FACELESS
from facescript.resolve.units import TIME
from facescript.resolve.words import BLOCKS, DEFINITIONS, ENDINGS, FACE, FILM, UNSEEN

OUTSIDE = ("background", "view", "life")
"""Statements that may stand before the scenes."""

Words = tuple[str, ...]


def offered(here: Here) -> list[Offer]:
    """All that may be written at a place, each thing once."""
    found = list(_offered(here))
    number = here.before.word.rstrip("/%abcdefghijklmnopqrstuvwxyz")
    if number.replace(".", "", 1).isdecimal():
        return [offer for offer in found if offer.kind == "unit"] or list(offers.units(number, ""))
    return list({offer.name: offer for offer in found if offer.kind != "unit"}.values())


def _offered(here: Here) -> Iterable[Offer]:
    words = here.before.words
    if here.before.label:
        return here.moments()
    if here.before.text is not None and not here.before.cue:
        return _quoted(here, words)
    if here.before.cue:
        return (*in_sum(here), *_cues(here)) if not words else in_verb(here)
    if not words:
        return _beginnings(here)
    if words[0] in _LINES and not _is_statement(here, words):
        return _LINES[words[0]](here, words)
    return _in_block(here) or in_verb(here)


def _is_statement(here: Here, words: Words) -> bool:
    return words[0] == "life" and "=" not in words


# ------------------------------------------------------------------------------------------------ beginnings


def _beginnings(here: Here) -> Iterator[Offer]:
    """What a line may begin with."""
    block = _declared(here)
    if block:
        yield from _in_block(here)
        return
    if _says(here):
        yield from (Offer(f'on "{word}":', "word", "when it is spoken") for word in here.words_above())
        return
    top = not here.blocks
    if top:
        yield from offers.openers(DEFINITIONS)
    if top and here.scripted:
        yield from offers.verbs(OUTSIDE[:2] if here.nameless() else OUTSIDE)
        return
    yield from _statements(here)


def _statements(here: Here) -> Iterator[Offer]:
    """What a statement may begin with: verbs where it is said who acts, else who."""
    faces = [each for each in here.project.names.all("face") if each.name in here.faces()]
    if not here.looker() and len(faces) > 1:
        yield from (offers.defined_as(each, f"{each.name}:") for each in faces)
    nameless = here.nameless()
    yield from offers.verbs(verb for verb in (*HANDLERS, "say") if verb in FACELESS or not nameless)
    yield from offers.openers({name: row for name, row in BLOCKS.items() if name != "on"})
    if not nameless:
        yield from offers.defined(here.project, "action")
    if "when" in here.first_words():
        yield from offers.openers(ENDINGS)


def _cues(here: Here) -> Iterator[Offer]:
    """What may stand in the brackets of a text beside a sum."""
    yield from offers.verbs(verb for verb in HANDLERS if verb not in FACELESS or verb == "wait")


def _says(here: Here) -> bool:
    return bool(here.blocks) and here.blocks[0][:1] != () and here.blocks[0][0][1] == "say"


def _declared(here: Here) -> str:
    """The word that the definition begins with whose rows are written here: face, target, life, kind; else ""."""
    first = next(here.first_words(), "")
    words = [token[1] for token in here.blocks[0]] if here.blocks else []
    is_life = first == "life" and "=" in words
    return first if first in ("face", "target", "kind") or is_life else ""


def _in_block(here: Here) -> list[Offer]:
    """What a row below a definition may say."""
    block = _declared(here)
    if block == "face":
        return list(settings(here, "face", FACE, here.before.tokens))
    if block == "life":
        return list(settings(here, "life", KNOBS, here.before.tokens))
    if block == "kind" and not here.before.words:
        return [Offer(name, "setting", form) for name, form in KIND_ROWS.items()]
    return []


# ------------------------------------------------------------------------------------------------ texts


def _quoted(here: Here, words: Words) -> Iterator[Offer]:
    """What may stand in a text: names of files behind the words that take one, words of the line behind `on`."""
    last = words[-1] if words else ""
    if words == ("on",):
        yield from (Offer(word, "label") for word in here.words_above())
    elif (last == "in" and words[0] == "repeat") or (words[0:1] == ("target",) and last == "from"):
        yield from _files(here, (".csv",))
    elif last in SUFFIXES and (len(words) == 1 or words[0] == "say"):
        yield from _files(here, SUFFIXES[last])
    elif "voice" in words[:-1]:
        said = words[len(words) - words[::-1].index("voice") :]
        for offer in offers.voices(said):
            if offer.name.startswith('"'):
                yield Offer(offer.name.strip('"'), offer.kind, offer.says)


def _files(here: Here, suffixes: tuple[str, ...]) -> Iterator[Offer]:
    return offers.files(here.analysis.world, here.analysis.source.name, suffixes)


# ------------------------------------------------------------------------------------------------ lines of their own


def _face(here: Here, words: Words) -> Iterator[Offer]:
    if "=" not in words:
        return
    behind = words[words.index("=") + 1 :]
    if behind:
        yield from settings(here, "face", FACE, here.before.tokens[words.index("=") + 2 :])
        return
    yield from offers.plain((*kind_names(), UNSEEN), "kind")
    yield from offers.defined(here.project, "kind")


def _life(here: Here, words: Words) -> Iterator[Offer]:
    behind = here.before.tokens[words.index("=") + 1 :]
    if not behind:
        yield from offers.defined(here.project, "life")
        yield from offers.modifiers(KNOBS.values(), (), False)
    else:
        yield from settings(here, "life", KNOBS, behind)


def _film(here: Here, words: Words) -> Iterator[Offer]:
    yield from settings(here, "film", FILM, here.before.tokens[1:])


def _sum(here: Here, words: Words) -> Iterator[Offer]:
    if "=" not in words:
        return
    if words[0] == "expression" and "(" in words and ")" not in words:
        return
    yield from in_sum(here)
    if words[0] == "expression":
        inside = here.before.tokens[2 : words.index("=")]
        names = (token[1] for before, token in pairwise(inside) if before[1] in "(,")
        yield from (Offer(name, "parameter", f"parameter of {words[1]}") for name in names)


def _target(here: Here, words: Words) -> Iterator[Offer]:
    if len(words) == 2:
        yield from offers.plain(("at", "moves", "from", "of"))
    elif words[2:3] == ("of",):
        yield from (
            offers.defined_as(each, each.name)
            for each in here.project.names.all("target")
            if each.name != words[1] and not crowd_size(each)
        )


def _scene(here: Here, words: Words) -> Iterator[Offer]:
    if "with" in words:
        known = here.project.names.all("face")
        yield from (offers.defined_as(each, each.name) for each in known if each.name not in words[2:])
    elif len(words) >= 2:
        yield from offers.plain(("with",))


def _when(here: Here, words: Words) -> Iterator[Offer]:
    if len(words) == 1:
        yield from offers.plain((*TEXTUAL, "person"))
    elif words[1:] == ("person",):
        yield from offers.plain(PERSONAL)
    elif words[1] == "person" and len(words) == 3:
        yield from offers.plain(("as",))


def _event(here: Here, words: Words) -> Iterator[Offer]:
    if len(words) == 1:
        yield from offers.plain(TEXTUAL)
        yield from offers.defined(here.project, "target")
    elif len(words) == 2 and words[1] not in TEXTUAL:
        yield from offers.plain(("arrives", "leaves"))
    elif len(words) == 3:
        yield from offers.plain(("at",))


def _repeat(here: Here, words: Words) -> Iterator[Offer]:
    if len(words) == 1:
        yield from offers.plain(("forever", "for"))
    elif len(words) == 2 and words[1].isdecimal():
        yield from offers.plain(("times",))
    elif len(words) == 2 and words[1] != "forever":
        yield from time_values(here, TIME) if words[1] == "for" else offers.plain(("in",))
    elif words[2:] == ("in",):
        yield from offers.crowds(here.project, here.people())


def _at(here: Here, words: Words) -> Iterator[Offer]:
    yield from here.moments()
    yield from time_values(here, TIME)


def _nothing(here: Here, words: Words) -> Iterator[Offer]:
    return iter(())


def _let(here: Here, words: Words) -> Iterator[Offer]:
    return anything(here) if "=" in words else iter(())


_LINES: Mapping[str, Callable[[Here, Words], Iterator[Offer]]] = {
    "face": _face,
    "life": _life,
    "film": _film,
    "expression": _sum,
    "viseme": _sum,
    "let": _let,
    "target": _target,
    "scene": _scene,
    "when": _when,
    "event": _event,
    "repeat": _repeat,
    "at": _at,
    "use": _nothing,
    "on": _nothing,
    "kind": _nothing,
    "action": _nothing,
    "together": _nothing,
    "choose": _nothing,
    "in": _nothing,
}
"""What follows a line's first word where that is no verb."""
