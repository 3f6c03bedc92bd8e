"""The library's expressions to a page, its units of FACS to another: recipe, what moves in the end, pictures."""

from __future__ import annotations

import re
from collections.abc import Iterator

from facescript.performance.channels import MUSCLES
from facescript.resolve.names import Definition
from facescript.resolve.shows import POSES
from facescript.resolve.words import UNDRAWABLE, UNIT_NAME
from website.library import comment, defined, moves, written
from website.page import Page, anchor, block, heading, portrait, row, sentence


def pages() -> Iterator[Page]:
    units = [each for each in defined("expression") if UNIT_NAME.fullmatch(each.name)]
    others = [each for each in defined("expression") if each not in units]
    yield Page(
        "reference/expressions.md", "Expressions", HEAD + _shown("neutral", "show neutral", "at rest") + _all(others)
    )
    undrawn = ", ".join(f"AU{number}" for number in sorted(UNDRAWABLE))
    yield Page("reference/units.md", "Units of FACS", UNIT_HEAD.format(undrawn=undrawn) + _all(units))


HEAD = """\
# Expressions

What a sum may name, at 100 %: as strong as it looks natural. A degree says how much of it (`smile 40%`), a side
which half of the face (`smile.left`). Scripts [define](definitions.md#expression) their own; a definition of yours
covers the library's of the same name. [The language](../language.md#7-muscles-sums-and-the-library) says how they
add up.

## `neutral` {#neutral}

A sum of nothing: the face at rest. It is a word of the language.

"""

UNIT_HEAD = """\
# Units of FACS

The units of the Facial Action Coding System over [muscles](muscles.md), lids and [channels](channels.md). 100 % is
the strongest contraction (intensity E); A to D may be written as lower degrees. Left and right are the face's own.
These faces cannot draw {undrawn} and the codes above AU64: they are refused by name (FS219).

"""


def _all(definitions: list[Definition]) -> str:
    return "\n".join(_entry(each) for each in definitions)


def _entry(each: Definition) -> str:
    parts = [heading(each.name)]
    if UNIT_NAME.fullmatch(each.name):
        parts.append(f"{sentence(comment(each))}\n")
    if each.name in GESTURES:
        verb = GESTURES[each.name]
        parts.append(f"The far pose of [`{verb}`](statements/{verb}.md).\n")
    parts += [block(written(each), "face-part"), f"Moves {_linked(moves(each))}.\n"]
    return "\n".join([*parts, _shown(each.name, f"show {each.name}", each.name)])


GESTURES = {pose: verb for verb, pose in POSES.items()}


def _shown(name: str, line: str, what: str) -> str:
    """On people; an expression on the dog too, whose ears and muzzle take part."""
    kinds = ("woman", "man") if UNIT_NAME.fullmatch(name) else ("woman", "man", "dog")
    return row(portrait(line, f"A {kind}: {what}.", kind) for kind in kinds) + "\n"


def _linked(recipe: str) -> str:
    """Each name of a recipe as a link to what it is."""
    return " + ".join(_link(*part.split(" ", 1)) for part in recipe.split(" + "))


def _link(name: str, amount: str) -> str:
    base = re.sub(r"\.(left|right)\b", "", name)
    return f"[`{name} {amount}`]({_page(base)})"


def _page(base: str) -> str:
    return f"muscles.md#{anchor(base)}" if base in MUSCLES else f"channels.md#{anchor(base)}"
