"""The tables of shapes to their page: what ARKit, MPEG-4 and VRM have of a face, and the channels that make each."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.shapes.rows import rows, terms
from website.page import Page, table


def pages() -> Iterator[Page]:
    yield Page("reference/shapes.md", "Shapes", HEAD + _arkit() + FAP_HEAD + _fap() + VRM_HEAD + _vrm())


HEAD = """\
# Shapes

What faces elsewhere are made of, and what makes it of [our channels](channels.md): factors of channels that are counted
from their rest, added up, and held between the least and the greatest. [Live](../live.md#6-shapes) says what they are
for, and what is lost on the way back. Besides channels there are measures of lids and lips:

- `shut.left`, `shut.right`: how far a lid is shut beyond what gaze does;
- `lips.raised`, `lips.parted`, `lips.held`: of the gap between the lips, what a raised upper lip makes of it over an
  open jaw, what both lips part further, and by how much they are nearer than the jaw would have them, in mouth-nose
  distances;
- `lips.rise`, `lips.sink`: how far the edge of the upper and the lower lip is from rest, likewise;
- `tongue.out`: how far the tongue is out between the teeth.

## ARKit {#arkit}

The names are those of Live Link Face; Apple writes them with a small letter at the start. Shapes go from 0 to 1,
rotations are in radians. What is not looked at on the way back is told by another row, or a squint, which shuts the lid
by 30 %.

"""

FAP_HEAD = """
## MPEG-4 {#mpeg-4}

Facial animation parameters (FAP 1 to 68) in 1/1024 of the face's own units, `AU` in 1e-5 rad. `IRISD` is the height
of the open eye, `ES` the distance of the eyes, `ENS` from the eyes to the nose, `MNS` from the mouth to the nose, `MW`
the width of the mouth. The factors are measured on [`woman`](kinds.md#woman).

"""

VRM_HEAD = """
## VRM {#vrm}

Here a row says what an expression *makes* at 1: a pose becomes the mixture that is nearest to it.

"""


def _arkit() -> str:
    heads = ("shape", "is made of", "back")
    return table(heads, ((f"`{row['name']}`", sum_of(row["made of"]), _back(row["back"])) for row in rows("arkit")))


def _back(said: str) -> str:
    return "" if said == "yes" else "not looked at"


def _fap() -> str:
    heads = ("", "parameter", "unit", "+ is", "is made of")
    cells = ((row["number"], f"`{row['name']}`", row["unit"], row["positive"], row["made of"]) for row in rows("fap"))
    return table(heads, ((number, *three, sum_of(made)) for number, *three, made in cells))


def _vrm() -> str:
    heads = ("VRM 1", "VRM 0", "makes")
    return table(heads, ((f"`{row['name']}`", f"`{row['vrm 0']}`", sum_of(row["makes"])) for row in rows("vrm")))


def sum_of(text: str) -> str:
    """The factors of a row, those of both sides as one."""
    found = terms(text)
    parts: dict[str, float] = {}
    for name, factor in found.items():
        whole, _, side = name.rpartition(".")
        other = f"{whole}.{'right' if side == 'left' else 'left'}"
        both = side in ("left", "right") and found.get(other) == factor
        parts[f"{whole}, both sides" if both else name] = factor
    told = [f"{factor:.4g} `{name.partition(', ')[0]}`{_both(name)}" for name, factor in parts.items()]
    return " + ".join(told).replace("+ -", "- ")


def _both(name: str) -> str:
    return " (both)" if name.endswith("both sides") else ""
