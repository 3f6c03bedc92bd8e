"""Coordinates to places: polar and cartesian in the room, percentages in the picture."""

from __future__ import annotations

from math import cos, radians, sin

from facescript.ir.values import PicturePlace, Point
from facescript.resolve.arithmetic import Value, checked
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader
from facescript.resolve.scope import Scope
from facescript.resolve.sums import left_over, primary
from facescript.resolve.units import ANGLE, LENGTH, SHARE
from facescript.syntax import tree

FORMS = "`25deg 10deg 2m` (azimuth, elevation, distance), `10cm -12cm 20cm` (x, y, z) or `-25% 5%` (in the picture)"


def place(project: Project, reader: Reader) -> Point | PicturePlace:
    """The place that all the words of a reader state. Raises `Refused`."""
    values = _values(project, reader)
    kinds = [value.kind for value in values]
    amounts = [_plain(project, value) for value in values]
    if kinds == [SHARE, SHARE]:
        return PicturePlace(amounts[0], amounts[1])
    if kinds == [LENGTH, LENGTH, LENGTH]:
        return Point(*amounts)
    if kinds == [ANGLE, ANGLE, LENGTH]:
        if amounts[2] <= 0.0:
            raise project.refuse("FS304", reader.span, text=reader.span.text, limits="distances above 0cm")
        return polar(*amounts)
    raise project.refuse("FS330", reader.span, text=reader.span.text, forms=FORMS)


def picture_place(project: Project, reader: Reader) -> PicturePlace:
    """A place in the picture: two percentages. Raises `Refused`."""
    found = place(project, reader)
    if isinstance(found, Point):
        raise project.refuse("FS330", reader.span, text=reader.span.text, forms="two percentages of the picture")
    return found


def in_brackets(project: Project, word: tree.Point, scope: Scope) -> Point | PicturePlace:
    return place(project, Reader(word.coordinates, scope, word.span))


def _values(project: Project, reader: Reader) -> list[Value]:
    """Two or three single quantities; sums of them stand in brackets."""
    values: list[Value] = []
    while reader.peek() is not None and len(values) < 3:
        word = reader.peek()
        if isinstance(word, tree.Operator):
            reason = "a sum of coordinates stands in brackets"
            raise project.refuse("FS306", word.span, text=word.span.text, reason=reason)
        values.append(primary(project, reader))
    if len(values) < 2:
        raise project.refuse("FS330", reader.span, text=reader.span.text, forms=FORMS)
    left_over(project, reader)
    return values


def _plain(project: Project, value: Value) -> float:
    amount = checked(project, value, value.kind, None, draws=False)
    assert isinstance(amount, float)
    return amount


def polar(azimuth: float, elevation: float, distance: float) -> Point:
    """The place at an azimuth (deg, + is the viewer's right), an elevation (deg, + up) and a distance (cm) from the
    picture's centre. Rounded to a millionth of a cm."""
    side, up = radians(azimuth), radians(elevation)
    x = distance * cos(up) * sin(side)
    y = distance * sin(up)
    z = distance * cos(up) * cos(side)
    return Point(round(x, 6) + 0.0, round(y, 6) + 0.0, round(z, 6) + 0.0)
