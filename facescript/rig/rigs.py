"""A declared face -> the rig that draws it, in the face's own looks."""

from __future__ import annotations

from facescript.ir.play import Face
from facescript.resolve.kinds.library import library_kind
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.cartoon.palette import named, tinted
from facescript.rig.cartoon.style import FaceStyle, style_of


def style(face: Face) -> FaceStyle:
    """How a face is drawn; its looks re-tint whole families of colours. Raises KeyError for an unknown kind."""
    kind = face.drawn or library_kind(face.kind)
    return style_of(kind, named(tinted(dict(kind.colours), dict(face.looks))), dict(face.choices), dict(face.amounts))


def rig(face: Face) -> CartoonRig:
    """The rig of a face. Raises KeyError for an unknown kind."""
    return CartoonRig(style(face))
