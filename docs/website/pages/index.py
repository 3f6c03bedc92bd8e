"""The first page of the reference: every page of it, and all the words of the language."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.resolve.words import VERBS, WORDS
from website.page import Page


def pages() -> Iterator[Page]:
    verbs = ", ".join(f"[`{verb}`](statements/{verb}.md)" for verb in VERBS)
    words = " ".join(f"`{word}`" for word in sorted(WORDS))
    yield Page("reference/index.md", "Overview", TEXT.format(verbs=verbs, words=words))


TEXT = """\
# Reference

All that a script may say, made from the tables that the compiler reads. Pictures are drawn by the same build.

| to find | look at |
|---|---|
| what a face does | [statements](statements/index.md): {verbs} |
| what holds statements | [blocks](blocks.md) |
| what is said more closely | [modifiers](modifiers.md) |
| what stands outside of all blocks | [definitions](definitions.md), [film](film.md), [face](face.md) |
| quantities, units, sums, colours | [values and words](values.md) |
| what can be looked at | [targets](targets.md) |
| what a face can show | [expressions](expressions.md), [units of FACS](units.md) |
| what that moves | [muscles](muscles.md), [channels](channels.md) |
| what that is elsewhere | [shapes](shapes.md) of ARKit, MPEG-4 and VRM |
| what it does unasked | [lives](lives.md) |
| verbs of the library | [actions](actions.md) |
| faces and how they look | [kinds of faces](kinds.md) |
| who speaks | [voices](voices.md) |
| what is made of a script | [outputs](outputs.md) |
| whole scripts | [examples](../examples/index.md), [the gallery](../gallery.md) |
| what a message means | [diagnostics](../diagnostics.md) |

The language's own words are not names of anything else: {words}.
"""
