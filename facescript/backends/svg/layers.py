"""Shapes in motion to the groups of the document: one a face, in it what plays and, where asked for, what stands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from lxml import etree

from facescript.backends.svg.animation import Animation
from facescript.backends.svg.ground import photo_element
from facescript.backends.svg.paint import Paints
from facescript.backends.svg.shade import shade
from facescript.backends.svg.track import Carried, Clock, Track, animate, carry, svg
from facescript.rig.picture import Linear, Radial, Shape
from facescript.stage.actor import BACKDROP
from facescript.stage.ground import Backdrop, Photo
from facescript.stage.stage import Stage

PLAYED, STOOD = "played", "stood"
"""Classes: the moving picture, and the still one for those who want no motion."""


@dataclass(frozen=True, slots=True)
class Showing:
    """One way the same shapes are shown: its class, and what is appended to ids, which are there once."""

    name: str
    moving: Animation
    mark: str


def showings(played: Animation, stood: Animation | None) -> tuple[Showing, ...]:
    """The moving picture, and the still one where there is one."""
    return (Showing(PLAYED, played, ""), *([Showing(STOOD, stood, "-stood")] if stood else []))


def named_shapes(stage: Stage) -> tuple[Shape, ...]:
    """The stage's shapes with ids that carry their face's name, also where there is only one face."""
    if len(set(stage.owners)) > 1:
        return stage.shapes
    return tuple(
        replace(shape, id=f"{owner}-{shape.id}", clip=tuple(f"{owner}-{name}" for name in shape.clip))
        for shape, owner in zip(stage.shapes, stage.owners, strict=True)
    )


def picture_groups(stage: Stage, shown: Sequence[Showing], clock: Clock, rules: list[str]) -> Iterator[etree._Element]:
    """What lies behind all faces in one group, then a group a face.

    Browsers keep what is behind as a picture of its own, if it stands still, and paint the faces alone in each frame.
    """
    ground = _ground_group(stage, shown, clock, rules)
    groups = [*_face_groups(stage, shown, clock, rules)]
    stands = len(shown) > 1 and not any(shape.moving for shape in stage.shapes if shape.group == BACKDROP)
    behind = svg("g", class_="behind", **({"style": "will-change:opacity"} if stands else {}))
    behind.extend([ground, *(group for group in groups if group.get("class") == "backdrop")])
    yield behind
    yield from (group for group in groups if group.get("class") != "backdrop")


def _ground_group(stage: Stage, shown: Sequence[Showing], clock: Clock, rules: list[str]) -> etree._Element:
    """What lies behind all."""
    size = stage.width, stage.height
    layers = [layer for showing in shown for layer in showing.moving.behind.layers]
    fills = [layer.paint if isinstance(layer, Backdrop) else layer for layer in layers if not isinstance(layer, Photo)]
    gradients = dict.fromkeys(fill for fill in fills if isinstance(fill, Linear | Radial))
    paints = Paints("", [Shape(f"ground-{number}", "", (), fill) for number, fill in enumerate(gradients, 1)])
    group = svg("g", class_="ground")
    parts = [_part(showing, showing.moving.behind.elements(size, paints, clock)) for showing in shown]
    photos = dict.fromkeys(layer for layer in layers if isinstance(layer, Photo))
    kept = [photo_element(photo, stage.pictures(photo.path), size) for photo in photos]
    _define(group, [*paints.elements(), *kept])
    group.extend(parts)
    rules += paints.rules()
    return group


def _face_groups(stage: Stage, shown: Sequence[Showing], clock: Clock, rules: list[str]) -> Iterator[etree._Element]:
    """A group a face's backdrop and one a face; in it a group a showing, in that a group a layer, a path a shape."""
    shapes = named_shapes(stage)
    rows = enumerate(zip(stage.owners, shapes, strict=True))
    for (owner, back), part in groupby(rows, key=lambda row: (row[1][0], row[1][1].group == BACKDROP)):
        places = [place for place, _ in part]
        mine = [shapes[place] for place in places]
        name, kind = (f"{owner}-backdrop", "backdrop") if back else (owner, "figure")
        group = svg("g", id=name, class_=kind, data_face=owner)
        paints = Paints(owner, mine)
        parts = [_part(showing, _layers(showing, shapes, places, paints, clock)) for showing in shown]
        clips = [
            _clip(clip, showing.mark)
            for showing in shown
            for clip in _clips([shapes[place] for place in places if showing.moving.cut[place]])
        ]
        _define(group, [*paints.elements(), *clips])
        group.extend(parts)
        rules += paints.rules()
        yield group


def _part(showing: Showing, elements: Iterable[etree._Element]) -> etree._Element:
    """A showing's share of a group; programs without style sheets see what plays alone."""
    part = svg("g", class_=showing.name, **({} if showing.name == PLAYED else {"display": "none"}))
    part.extend(elements)
    return part


def _define(group: etree._Element, elements: Sequence[etree._Element]) -> None:
    if elements:
        definitions = svg("defs")
        definitions.extend(elements)
        group.append(definitions)


def _clips(shapes: Sequence[Shape]) -> list[tuple[str, ...]]:
    return list(dict.fromkeys(shape.clip for shape in shapes if shape.clip))


def _clip(clip: tuple[str, ...], mark: str) -> etree._Element:
    element = svg("clipPath", id=_clip_name(clip, mark))
    element.extend(svg("use", href=f"#{name}{mark}") for name in clip)
    return element


def _clip_name(clip: tuple[str, ...], mark: str) -> str:
    return f"{'-'.join(clip)}-clip{mark}"


def _layers(
    showing: Showing, shapes: Sequence[Shape], places: Sequence[int], paints: Paints, clock: Clock
) -> Iterator[etree._Element]:
    """A group a carrier, in it a group a layer."""
    bounds = {name for shape in shapes for name in shape.clip}
    moving = showing.moving
    whole = svg("g", transform=f"scale({moving.quantum:g})")
    for number, carried in groupby(places, key=lambda place: moving.carried[place]):
        carrier = svg("g")
        carry(carrier, moving.carriers[number], clock)
        for layer, part in groupby(carried, key=lambda place: shapes[place].group):
            element = svg("g", class_=layer)
            drawn = [place for place in part if shapes[place].id in bounds or not _never(moving.opacities[place])]
            for clip, run in groupby(drawn, key=lambda place: shapes[place].clip):
                together = list(run)
                paths = [_path(shapes[place], place, showing, paints, clock) for place in together]
                cut = any(moving.cut[place] for place in together)
                element.extend([_clipped(paths, clip, showing.mark)] if cut else paths)
            carrier.append(element)
        whole.append(carrier)
    yield whole


def _clipped(paths: Sequence[etree._Element], clip: tuple[str, ...], mark: str) -> etree._Element:
    """Paths in a row that share a clip, in a group that is clipped: a browser need cut it out once."""
    group = svg("g", clip_path=f"url(#{_clip_name(clip, mark)})")
    group.extend(paths)
    return group


def _never(opacity: Track) -> bool:
    """Whether nothing of a shape is ever seen."""
    return opacity.still and opacity.values[0] == "0"


def _path(shape: Shape, place: int, showing: Showing, paints: Paints, clock: Clock) -> etree._Element:
    moving = showing.moving
    path = svg("path", id=shape.id + showing.mark, **paints.fill(shape.fill))
    animate(path, "d", moving.outlines[place], clock)
    slide = moving.slides[place]
    if slide is not None:
        carry(path, [Carried("translate", slide)], clock)
    shade(path, moving.opacities[place])
    return path
