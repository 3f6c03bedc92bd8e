"""The 14 pairs of muscles to their page: what each does, its units of FACS, pictures of both sides and each."""

from __future__ import annotations

import re
from collections.abc import Iterator

from facescript.performance.channels import MUSCLES
from facescript.resolve.meanings import MUSCLES_DO
from facescript.resolve.words import UNIT_NAME
from facescript.shapes.rows import rows, terms
from website.library import defined, moves
from website.page import Page, anchor, heading, portrait, row, sentence


def pages() -> Iterator[Page]:
    yield Page("reference/muscles.md", "Muscles", HEAD + "\n".join(_entry(muscle) for muscle in MUSCLES))


HEAD = """\
# Muscles

14 pairs. The name alone is both sides, `.left` and `.right` are the face's own: its left is the viewer's right.
Amounts are from 0 % to 100 %; muscles that several things drive add up and then meet a soft limit ([the blending
law](../language.md#9-the-blending-law)). Tables have a column a side, from 0 to 1.

"""


def _entry(muscle: str) -> str:
    sides = (("", "both sides"), (".left", "its left"), (".right", "its right"))
    shown = (
        f"{portrait(f'show {muscle}{side}', f'A woman: {muscle}, {told}.')}\n`{muscle}{side}`" for side, told in sides
    )
    return "\n".join(
        [heading(muscle), f"{sentence(MUSCLES_DO[muscle])} {_units(muscle)} {_shapes(muscle)}\n", row(shown)]
    )


def _units(muscle: str) -> str:
    """The units of FACS that contract it, those that are nothing else first."""
    found = [
        (moves(each).count(" + "), each.name)
        for each in defined("expression")
        if UNIT_NAME.fullmatch(each.name) and re.search(rf"\b{re.escape(muscle)}\b", moves(each))
    ]
    links = ", ".join(f"[{name}](units.md#{anchor(name)})" for _, name in sorted(found, key=lambda each: each[0]))
    return f"Units of FACS: {links}." if links else "No unit of FACS uses it."


def _shapes(muscle: str) -> str:
    """What ARKit and MPEG-4 call what it does: of its left side."""
    arkit = ", ".join(f"`{row['name']}`" for row in rows("arkit") if f"{muscle}.left" in terms(row["made of"]))
    moved = [row for row in rows("fap") if f"{muscle}.left" in terms(row["made of"])]
    fap = ", ".join(f"{row['number']} `{row['name']}`" for row in moved)
    return f"By its left side go [the shapes](shapes.md) {arkit} of ARKit and the parameters {fap} of MPEG-4."
