"""A tree as authors punctuate it to the tree as the language does, with a hint for each comma too many or too few.

Modifiers that begin with `over for back ease from timed to as` follow directly, all others after a comma; `as` is last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TypeVar

from facescript.diagnostics.model import Fix
from facescript.syntax.faults import Faults
from facescript.syntax.tree import (
    Act,
    ActionDefinition,
    Cast,
    Declaration,
    Group,
    Item,
    Moment,
    Name,
    On,
    Operator,
    Phrase,
    Quantity,
    Repeat,
    Scene,
    Setting,
    Statement,
    When,
    Word,
)

DIRECT = frozenset(("over", "for", "back", "ease", "from", "timed", "to", "as"))
"""What begins a modifier that follows directly."""

_GAZE = frozenset(("eyes", "head", "speed", "latency", "nearest"))
_VOICE = frozenset(("rate", "pitch", "range", "volume"))
_KNOBS = frozenset(("blink", "brows", "sway", "nods", "saccades", "avert"))
_MANNERS = frozenset(("posed", "spontaneous"))
_BEGIN = {
    "show": _MANNERS,
    "add": _MANNERS,
    "look": _GAZE,
    "glance": _GAZE,
    "scan": _GAZE,
    "say": _VOICE,
    "play": frozenset(("speed",)),
    "life": _KNOBS,
    "background": frozenset(("left", "top", "towards", "round")),
    "film": frozenset(("seed", "screen")),
    "face": frozenset(("voice", "size", "life", "gaze", "hair")) | _VOICE | _KNOBS,
}
"""What begins a modifier that follows after a comma, by the verb or the kind of definition."""

_JOINS = frozenset(("then", "at", "only"))
"""After these a word goes on what stands before it: `eyes then head`."""

_Block = Scene | When | ActionDefinition | Cast | Group | Repeat | Moment | On
_Node = TypeVar("_Node", bound=Item)
_Bearer = TypeVar("_Bearer", bound=_Block)


def settle(items: Sequence[_Node], faults: Faults) -> tuple[_Node, ...]:
    """The items with their phrases as the language cuts them; what is cut already is the same object."""
    return tuple(_item(item, faults) for item in items)  # type: ignore[misc]


def comma_missing(before: Word, word: Word, faults: Faults) -> None:
    """The hint that a comma stands between two words."""
    end = before.span.end
    faults.add("FS141", word.span.start, word.span.end, faults.fix("write `,`", (end, end, ",")), word=word.span.text)


def _item(item: Item, faults: Faults) -> Item:
    if isinstance(item, Act):
        return _act(item, faults)
    if isinstance(item, Scene | When | ActionDefinition | Cast | Group | Repeat | Moment):
        return _block(item, faults)
    if isinstance(item, Declaration):
        phrases = _cut(item.phrases, item.kind, faults)
        lines = tuple(_cut(line, item.kind, faults) for line in item.lines) if item.kind != "target" else item.lines
        return item if (phrases, lines) == (item.phrases, item.lines) else replace(item, phrases=phrases, lines=lines)
    if isinstance(item, Setting) and item.kind == "film":
        phrases = _cut(item.phrases, "film", faults)
        return item if phrases is item.phrases else replace(item, phrases=phrases)
    return item


def _block(block: _Bearer, faults: Faults) -> _Bearer:
    body: tuple[Statement, ...] = settle(block.body, faults)
    same = all(new is old for new, old in zip(body, block.body, strict=True))
    return block if same else replace(block, body=body)


def _act(act: Act, faults: Faults) -> Act:
    verb = act.phrases[0].words[0]
    phrases = _as_last(_cut(act.phrases, verb.text if isinstance(verb, Name) else "", faults), faults)
    ons = tuple(_block(on, faults) for on in act.ons)
    same = phrases is act.phrases and all(new is old for new, old in zip(ons, act.ons, strict=True))
    return act if same else replace(act, phrases=phrases, ons=ons)


# ------------------------------------------------------------------------------------------------ commas


def _cut(phrases: tuple[Phrase, ...], kind: str, faults: Faults) -> tuple[Phrase, ...]:
    """The phrases of a line joined where a comma is too many, cut where one is too few; the same object if neither."""
    begin = _BEGIN.get(kind, frozenset())
    cut: list[Phrase] = []
    for phrase in phrases:
        first = phrase.words[0]
        if cut and type(first) is Name and first.text in DIRECT and kind not in ("film", "face", "life"):
            _comma_extra(cut[-1], phrase, faults)
            cut[-1] = Phrase(cut[-1].words + phrase.words, cut[-1].span.to(phrase.span))
        else:
            cut.append(phrase)
        if begin:
            cut[-1:] = _parts(cut[-1], kind, begin, faults)
    same = len(cut) == len(phrases) and all(new is old for new, old in zip(cut, phrases, strict=True))
    return phrases if same else tuple(cut)


def _parts(phrase: Phrase, kind: str, begin: frozenset[str], faults: Faults) -> list[Phrase]:
    words = phrase.words
    starts = [index for index in range(1, len(words)) if _begins(words, index, kind, begin)]
    for index in starts:
        comma_missing(words[index - 1], words[index], faults)
    borders = [0, *starts, len(words)]
    if not starts:
        return [phrase]
    return [_piece(words[start:end]) for start, end in pairwise(borders)]


def _begins(words: tuple[Word, ...], index: int, kind: str, begin: frozenset[str]) -> bool:
    """Whether a modifier that needs a comma begins at a word."""
    word, before = words[index], words[index - 1]
    if isinstance(before, Operator) or (isinstance(before, Name) and before.text in _JOINS | DIRECT):
        return False
    if type(word) is Name:
        return word.text in begin and (index > 1 or begin is not _MANNERS)
    if type(word) is not Quantity:
        return False
    after = words[index + 1] if index + 1 < len(words) else None
    follows = after.text if isinstance(after, Name) else ""
    if kind == "film":
        return word.unit == "fps" or follows in ("long", "wide")
    return kind == "scan" and follows == "each"


def _piece(words: tuple[Word, ...]) -> Phrase:
    return Phrase(words, words[0].span.to(words[-1].span))


def _comma_extra(before: Phrase, phrase: Phrase, faults: Faults) -> None:
    start, end = before.words[-1].span.end, phrase.span.start
    word = phrase.words[0].span
    faults.add("FS140", word.start, word.end, _fix(faults, "remove the comma", (start, end, " ")), word=word.text)


# ------------------------------------------------------------------------------------------------ names of statements


def _as_last(phrases: tuple[Phrase, ...], faults: Faults) -> tuple[Phrase, ...]:
    """The phrases with `as NAME` at their end; the same object where it is there or nowhere. Of two names
    the first stays where it is."""
    if _is_named(phrases[-1].words[-2:]):
        return phrases
    for number, phrase in enumerate(phrases):
        for index in range(1, len(phrase.words) - 1):
            if _is_named(phrase.words[index : index + 2]):
                return _move_as(phrases, number, index, faults)
    return phrases


def _is_named(words: tuple[Word, ...]) -> bool:
    """Whether two words are `as NAME`."""
    return len(words) == 2 and type(words[0]) is Name and words[0].text == "as" and type(words[1]) is Name


def _move_as(phrases: tuple[Phrase, ...], number: int, index: int, faults: Faults) -> tuple[Phrase, ...]:
    words = phrases[number].words
    word, name = words[index : index + 2]
    end = phrases[-1].words[-1].span.end
    away = (words[index - 1].span.end, name.span.end, "")
    fix = _fix(faults, "move it to the end", away, (end, end, f" as {name.span.text}"))
    faults.add("FS142", word.span.start, name.span.end, fix, name=name.span.text)
    moved = list(phrases)
    moved[number] = Phrase(words[:index] + words[index + 2 :], phrases[number].span)
    moved[-1] = Phrase((*moved[-1].words, word, name), phrases[-1].span)
    return tuple(moved)


def _fix(faults: Faults, title: str, away: tuple[int, int, str], *edits: tuple[int, int, str]) -> Fix | None:
    """A fix that takes something away; none where a comment would go with it."""
    comment = "#" in faults.source.text[away[0] : away[1]]
    return None if comment else faults.fix(title, away, *edits)
