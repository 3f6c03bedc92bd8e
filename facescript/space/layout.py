"""Film and faces to where each face stands: in the picture (px) and in the room (cm)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from facescript.ir.play import Face, Film
from facescript.ir.values import PicturePlace

BOX = 720.0
"""Width and height of the art box that all rigs draw in, px."""

EYES = (360.0, 318.0)
"""The middle of the eyes in the art box, px, y down."""

MOUTH = (360.0, 430.0)
"""The middle of the mouth in the art box, px, y down: within 3 px of where each rig has it."""


@dataclass(frozen=True, slots=True)
class Standing:
    """Where a face's art box lies in the picture: its left upper corner (picture px), `scale` in px per art px."""

    left: float
    top: float
    scale: float

    def px(self, art: tuple[float, float]) -> tuple[float, float]:
        """Picture px (y down) of a point of the art box."""
        return self.left + art[0] * self.scale, self.top + art[1] * self.scale

    @property
    def eyes(self) -> tuple[float, float]:
        """Picture px of the middle of the eyes."""
        return self.px(EYES)


@dataclass(frozen=True, slots=True)
class Layout:
    """The seen faces of a film by name, in the order declared."""

    film: Film
    standings: dict[str, Standing]

    def room(self, px: tuple[float, float]) -> tuple[float, float]:
        """Picture px (y down) to cm in the room's plane z = 0: x to the viewer's right, y up, from the centre."""
        cm = self.film.wide_cm / self.film.width
        return (px[0] - self.film.width / 2) * cm, (self.film.height / 2 - px[1]) * cm

    def place(self, at: PicturePlace) -> tuple[float, float]:
        """Cm in the room's plane z = 0 of a place in the picture."""
        tall_cm = self.film.wide_cm * self.film.height / self.film.width
        return at.x * self.film.wide_cm, at.y * tall_cm

    def part(self, face: str, art: tuple[float, float]) -> tuple[float, float]:
        """Cm in the room's plane z = 0 of a point of a face's art box; the picture's centre for an unseen face."""
        standing = self.standings.get(face)
        return self.room(standing.px(art)) if standing else (0.0, 0.0)


def lay_out(film: Film, faces: Sequence[Face]) -> Layout:
    """Stand the seen faces side by side in equal slots from the viewer's left, except those with a place of their own.

    Its art box is as large as its slot and the film allow, times its size, and centred in its slot or at its place.
    """
    seen = [face for face in faces if face.seen]
    row = [face.name for face in seen if face.place is None]
    slot = film.width / max(1, len(row))
    standings = {}
    for face in seen:
        side = min(slot, film.height) * face.size
        if face.place is None:
            centre = (row.index(face.name) + 0.5) * slot, film.height / 2
        else:
            centre = film.width * (0.5 + face.place.x), film.height * (0.5 - face.place.y)
        standings[face.name] = Standing(centre[0] - side / 2, centre[1] - side / 2, side / BOX)
    return Layout(film, standings)
