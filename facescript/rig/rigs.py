"""A declared face -> the rig that draws it, in the face's own looks."""

from __future__ import annotations

from functools import lru_cache

from facescript.ir.kind import Kind
from facescript.ir.play import Face
from facescript.resolve.kinds.library import library_kind
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.cartoon.palette import named, tinted
from facescript.rig.cartoon.style import FaceStyle, style_of

KEPT = 16
"""Rigs that are kept: to lay one out takes a third of a second, and every output of a face asks for it anew."""

Words = tuple[tuple[str, str], ...]
Amounts = tuple[tuple[str, float], ...]


def style(face: Face) -> FaceStyle:
    """How a face is drawn; its looks re-tint whole families of colours. Raises KeyError for an unknown kind."""
    return _rig(face.drawn or library_kind(face.kind), face.looks, face.choices, face.amounts).style


def rig(face: Face) -> CartoonRig:
    """The rig of a face; the same for all faces that look alike. Raises KeyError for an unknown kind."""
    return _rig(face.drawn or library_kind(face.kind), face.looks, face.choices, face.amounts)


@lru_cache(maxsize=KEPT)
def _rig(kind: Kind, looks: Words, choices: Words, amounts: Amounts) -> CartoonRig:
    return CartoonRig(style_of(kind, named(tinted(dict(kind.colours), dict(looks))), dict(choices), dict(amounts)))
