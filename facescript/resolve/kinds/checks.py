"""A kind whose rows are read to faults between them: shapes that are not there, offsets that do not fit."""

from __future__ import annotations

from facescript.diagnostics.model import Related
from facescript.ir.kind import Kind, KindOutline, KindShape, Pull
from facescript.resolve.kinds.words import (
    ASKING,
    FEATURE_SHAPES,
    FEATURES,
    LIVE,
    LOCKS,
    MOST_POINTS,
    MOST_SHAPES,
    NEEDED,
    OUTLINE,
    TOOTHED,
)
from facescript.resolve.project import Project, Refused
from facescript.text import Span


def check(project: Project, kind: Kind) -> None:
    """Report what does not fit together. Raises `Refused` after that."""
    before = len(project.notes.told)
    shapes = _shapes(project, kind)
    _size(project, kind)
    if kind.points or kind.hair:
        _features(project, kind, shapes)
    for name in NEEDED:
        if name not in shapes:
            form = f"shape {name}, fill COLOUR"
            project.report("FS244", kind.span, what=f"shape `{name}`", name=kind.name, form=form)
    for shape in kind.shapes:
        _known(project, shape.clip, shapes, shape.span)
        _measured(project, kind, shape)
    for pull in kind.pulls:
        _known(project, pull.shapes, shapes, pull.span)
        _fits(project, pull, kind)
    for shade in kind.shades:
        _known(project, (shade.shape,), shapes, shade.span)
    if len(project.notes.told) > before:
        raise Refused


def names_of(shape: KindShape) -> tuple[str, ...]:
    """The ids of a shape: its own, and those of its sides."""
    return (shape.id, f"{shape.id}-left", f"{shape.id}-right") if shape.sides else (shape.id,)


def anchors(outline: KindOutline) -> int:
    """How many anchors an outline has once it is drawn; a stroke has two a point, one where it ends in a point."""
    count = len(outline.points)
    if outline.form == "half":
        return 2 * count - 2
    if outline.form == "stroke":
        return 2 * count - sum(point.numbers[2] < POINTED for point in (outline.points[0], outline.points[-1]))
    return 4 if outline.form in ("spot", "disc") else count


POINTED = 0.02
"""A stroke's end narrower than this is a point."""


def _shapes(project: Project, kind: Kind) -> dict[str, KindShape]:
    found: dict[str, KindShape] = {}
    for shape in kind.shapes:
        for name in names_of(shape):
            earlier = found.get(name)
            if earlier is not None and not (earlier.when and shape.when):
                related = (Related(earlier.span, "it is a shape here already"),)
                project.report("FS208", shape.span, related=related, name=name)
            found.setdefault(name, shape)
    return found


def _features(project: Project, kind: Kind, shapes: dict[str, KindShape]) -> None:
    """A face with feature points has all of them."""
    there = dict(kind.points)
    lacks = [f"`point {name}`" for name in FEATURES if name not in there]
    lacks += [f"shape `{name}`" for name in FEATURE_SHAPES if name not in shapes]
    lacks += [f"{LOCKS} points in `locks`"] * (len(kind.hair) != LOCKS)
    lacks += [f"{OUTLINE} points in `outline`"] * (len(kind.outline) != OUTLINE)
    if lacks:
        form = "no `point` and no `locks`, or all that feature points need"
        project.report("FS244", kind.span, what=", ".join(lacks), name=kind.name, form=form)


def _size(project: Project, kind: Kind) -> None:
    points = sum(anchors(outline) * (2 if shape.sides else 1) for shape in kind.shapes for outline in shape.outlines)
    for count, most, what in ((len(kind.shapes), MOST_SHAPES, "shapes"), (points, MOST_POINTS, "points")):
        if count > most:
            project.report("FS246", kind.span, name=kind.name, count=count, most=most, what=what)


def _known(project: Project, names: tuple[str, ...], shapes: dict[str, KindShape], span: Span) -> None:
    for name in names:
        if name not in shapes:
            clause, _ = project.meant(name, shapes, span)
            project.report("FS242", span, name=name, what="shape of this kind", meant=clause)


def _measured(project: Project, kind: Kind, shape: KindShape) -> None:
    """A shape that eyes or mouth draw only with a measure of their own has it."""
    row, all_measures = ("eye", kind.eyes) if shape.id.startswith("eye-") else ("mouth", (kind.mouth,))
    asked = ASKING.get(shape.id)
    if shape.id in TOOTHED and any(name == "muzzle" for name, _ in kind.mouth.values):
        asked = TOOTHED[shape.id]
    if asked is not None and any(asked not in dict(measures.values) for measures in all_measures):
        form = f"{row} ..., {asked} NUMBER" if row == "eye" else f"{row} ..., {asked} X Y X Y X Y"
        project.report("FS244", shape.span, what=f"the measure `{asked}` of the {row}", name=shape.id, form=form)


def _fits(project: Project, pull: Pull, kind: Kind) -> None:
    """Offsets are one for all, or one for each anchor of each shape, whatever the looks."""
    if len(pull.by) <= 1:
        return
    for shape in (shape for shape in kind.shapes if set(pull.shapes).intersection(names_of(shape))):
        count = sum(anchors(outline) for outline in shape.outlines)
        if shape.id in LIVE or count != len(pull.by):
            project.report("FS247", pull.span, name=shape.id, count=count, given=len(pull.by))
