"""The tables of blocks, definitions and modifiers to a page each: form, meaning and example of every row."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from facescript.resolve.words import BLOCKS, DEFINITIONS, ENDINGS, MODIFIERS, VERBS, Opener
from website.page import Page, block, examples, heading, sentence


def pages() -> Iterator[Page]:
    yield Page("reference/blocks.md", "Blocks", BLOCK_HEAD + _openers((*BLOCKS.values(), *ENDINGS.values())))
    yield Page("reference/definitions.md", "Definitions", DEFINITION_HEAD + _openers(DEFINITIONS.values()))
    yield Page("reference/modifiers.md", "Modifiers", MODIFIER_HEAD + "\n".join(_modifiers()))


BLOCK_HEAD = """\
# Blocks

What holds statements. After the colon stands one statement, or an indented block. The last three end a reaction
([`when`](definitions.md#when)). [Time](../language.md#4-time) and [repeats](../language.md#15-repeats-and-choices)
say more.

"""

DEFINITION_HEAD = """\
# Definitions

What stands outside of all blocks, in any order. [The language](../language.md#14-definitions) says more.

"""

MODIFIER_HEAD = """\
# Modifiers

What says a statement more closely. Those without a comma follow directly, all others after one; `as NAME` is last.

"""


def _openers(rows: Iterable[Opener]) -> str:
    parts = (
        [heading(row.name), block(row.form, "face-part"), sentence(row.help) + "\n", examples()[row.name]]
        for row in rows
    )
    return "\n".join(part for opener in parts for part in opener)


def _modifiers() -> Iterator[str]:
    for row in MODIFIERS.values():
        takers = [name for name, verb in VERBS.items() if row.name in verb.modifiers]
        links = ", ".join(f"[`{name}`](statements/{name}.md)" for name in takers)
        form = row.form if row.direct else f", {row.form}"
        goes = f"Goes with {links}." if links else "Goes with a face's [life](lives.md)."
        yield "\n".join([heading(row.name), block(form, "face-part"), f"{sentence(row.help)} {goes}\n"])
