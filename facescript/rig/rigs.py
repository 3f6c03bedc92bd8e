"""A declared face -> the rig that draws it, in the face's own looks."""

from __future__ import annotations

from facescript.ir.play import Face
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.cartoon.man import MAN
from facescript.rig.cartoon.palette import tinted
from facescript.rig.cartoon.style import FaceStyle
from facescript.rig.cartoon.woman import WOMAN
from facescript.rig.picture import Rig

STYLES: dict[str, FaceStyle] = {style.name: style for style in (WOMAN, MAN)}
"""The faces that can be drawn, by kind."""

LOOKS = ("hair", "skin", "eyes", "lips", "clothes")
"""What of a face takes a colour."""


def rig(face: Face) -> Rig:
    """The rig of a face; its looks re-tint whole families of colours. Raises KeyError for an unknown kind."""
    style = STYLES[face.kind]
    looks = {name: colour for name, colour in face.looks if name in LOOKS}
    return CartoonRig(style, tinted(style.palette, looks))
