"""The kinds of faces to their page: a picture of each, and one of every choice and colour that it has."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.resolve.kinds.library import kind_names, library_head
from facescript.resolve.meanings import FACES
from facescript.resolve.words import UNSEEN
from website.page import WHOLE, Page, heading, portrait, row, sentence, shown

LOOK = "film 300x300\nface x = {kind}, {look}\n    life still\nwait 1s\n"

AMOUNTS = ("0%", "50%", "100%")


def pages() -> Iterator[Page]:
    parts = [HEAD, _overview(), *(_kind(kind) for kind in kind_names()), UNSEEN_TEXT]
    yield Page("reference/kinds.md", "Kinds of faces", "\n".join(parts))


HEAD = """\
# Kinds of faces

What may stand behind `face NAME =`. Every script plays on every kind. A face chooses among the looks of its kind by
name (`hair bob auburn`, `glasses round tortoise`), may take any colour as `#rrggbb`, and with `seed 12` draws
whatever is not said. A kind of your own is [drawn](../faces.md) in a script.
"""

UNSEEN_TEXT = f"""\
{heading(UNSEEN)}
{sentence(FACES[UNSEEN])}
"""


def _overview() -> str:
    return row(
        f"{portrait('show smile 30%', f'{FACES[kind]}.', kind, near=WHOLE)}\n[`{kind}`](#{kind})"
        for kind in kind_names()
    )


def _kind(kind: str) -> str:
    head = library_head(kind)
    tints = {family: [tint.name for tint in found] for family, found in head.tints}
    parts = [heading(kind), sentence(FACES[kind]) + "\n", _sheet(kind)]
    for name, choices in head.looks:
        parts.append(_choices(kind, name, choices))
    for family, colours in tints.items():
        parts.append(_colours(kind, family, colours))
    parts += [_amount(kind, name, usual) for name, usual in head.amounts]
    return "\n".join(parts)


def _sheet(kind: str) -> str:
    return f"All that it can show is on [its sheet](../pictures/sheets/{kind}.png).\n"


def _choices(kind: str, look: str, choices: tuple[str, ...]) -> str:
    told = f"**{look}**: the first is the usual one.\n"
    return f"{told}\n{row(_look(kind, f'{look} {choice}') for choice in choices)}"


def _colours(kind: str, family: str, colours: list[str]) -> str:
    """Skins and hair change a face so that a picture tells; of other families the names suffice."""
    if family in ("skin", "hair"):
        return f"**Colours of {family}**:\n\n{row(_look(kind, f'{family} {colour}') for colour in colours)}"
    return f"**Colours of {family}**: {', '.join(f'`{colour}`' for colour in colours)}.\n"


def _amount(kind: str, name: str, usual: float) -> str:
    told = f"**{name}**: an amount, {usual:.0%} as drawn.\n"
    return f"{told}\n{row(_look(kind, f'{name} {amount}') for amount in AMOUNTS)}"


def _look(kind: str, look: str) -> str:
    return f"{shown(LOOK.format(kind=kind, look=look), f'A {kind}: {look}.', 120, '0s')}\n`{look}`"
