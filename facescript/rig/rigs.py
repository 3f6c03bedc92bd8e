"""A declared face -> the rig that draws it, in the face's own looks."""

from __future__ import annotations

from functools import lru_cache

from facescript.ir.kind import Kind
from facescript.ir.play import Face
from facescript.resolve.kinds.library import library_kind
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.cartoon.palette import named, tinted
from facescript.rig.cartoon.style import FaceStyle, style_of

KEPT = 32
"""Rigs and styles that are kept: more than the faces of most scripts."""

Pairs = tuple[tuple[str, str], ...]
Amounts = tuple[tuple[str, float], ...]


def style(face: Face) -> FaceStyle:
    """How a face is drawn; its looks re-tint whole families of colours. Raises KeyError for an unknown kind."""
    return _style(face.drawn or library_kind(face.kind), face.looks, face.choices, face.amounts)


@lru_cache(maxsize=KEPT)
def _style(kind: Kind, looks: Pairs, choices: Pairs, amounts: Amounts) -> FaceStyle:
    return style_of(kind, named(tinted(dict(kind.colours), dict(looks))), dict(choices), dict(amounts))


def rig(face: Face) -> CartoonRig:
    """The rig of a face, the same for faces that look the same: laying one out takes a third of a second. Raises
    KeyError for an unknown kind."""
    return _rig(face.drawn or library_kind(face.kind), face.looks, face.choices, face.amounts)


@lru_cache(maxsize=KEPT)
def _rig(kind: Kind, looks: Pairs, choices: Pairs, amounts: Amounts) -> CartoonRig:
    return CartoonRig(_style(kind, looks, choices, amounts))
