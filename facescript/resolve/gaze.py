"""`look`, `glance` and `scan` to acts."""

from __future__ import annotations

from typing import Literal, cast

from facescript.ir.acts import GazeManner, GazeParts, Glance, Look, Scan
from facescript.ir.values import Aim, Amount
from facescript.resolve.aims import read_aim, read_crowd, read_direction
from facescript.resolve.lines import Line
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader
from facescript.resolve.shows import timing
from facescript.resolve.speeds import speed_of
from facescript.resolve.suggest import replace
from facescript.resolve.units import SHARE, TIME
from facescript.space.main_sequence import HURRY

SLOWEST = 0.01
"""The least `speed` of a look; `HURRY` is the greatest."""

PARTS = ("eyes then head", "head then eyes", "eyes only", "head only")
ORDERS = ("in order", "nearest first", "at random")


def look(project: Project, line: Line, place: Place) -> Look:
    reader = line.reader()
    reader.next()
    aim = read_direction(project, reader)
    if aim is None:
        if not reader.word("at"):
            _misses_at(project, reader)
        aim = _aim(project, reader, place)
    line.finish(reader)
    return Look(aim, _manner(line), timing(line))


def glance(project: Project, line: Line, place: Place) -> Glance:
    reader = line.reader()
    reader.next()
    here = reader.here()
    if reader.word("at"):
        raise project.refuse("FS312", here, text="at", advice="it is written `glance TARGET`")
    aim = read_direction(project, reader) or _aim(project, reader, place)
    line.finish(reader)
    return Glance(aim, _manner(line), timing(line))


def scan(project: Project, line: Line, place: Place) -> Scan:
    reader = line.reader()
    reader.next()
    crowd = read_crowd(project, reader)
    line.finish(reader)
    order = next((name for name in ORDERS if name in line.parts), "in order")
    chosen = cast(Literal["in order", "nearest first", "at random"], order)
    return Scan(crowd, line.amount("each", TIME), chosen, _manner(line))


def _misses_at(project: Project, reader: Reader) -> None:
    word = reader.peek()
    fixes = (replace(word.span, f"at {word.span.text}"),) if word is not None else ()
    advice = "it is written `look at TARGET`, `look left 20deg` or `look away`"
    raise project.refuse("FS312", reader.here(), fixes=fixes, text=reader.here().text, advice=advice)


def _aim(project: Project, reader: Reader, place: Place) -> Aim:
    word = reader.peek()
    aim = read_aim(project, reader, place.face)
    face = getattr(aim, "face", None)
    if face is not None and face not in place.cast and word is not None:
        raise project.refuse("FS213", word.span, name=face)
    return aim


def _manner(line: Line) -> GazeManner:
    parts = next((name for name in PARTS if name in line.parts), "eyes then head")
    speed = speed_of(line, SLOWEST, HURRY, "a look has")
    latency = line.amount("latency", TIME)
    share: Amount | None = line.amount("head", SHARE)
    return GazeManner(
        cast(GazeParts, parts),
        share,
        speed,
        0.0 if latency is None else latency,
    )
