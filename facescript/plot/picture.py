"""A job to a plot: its strips one under another, a block a face, all over the same time axis."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil
from typing import Protocol

from facescript.backends.job import Job
from facescript.ir.play import Face
from facescript.performance.channels import channels_of
from facescript.plot.acts import face_lanes, film_lanes
from facescript.plot.axis import Scale
from facescript.plot.channels import Panel, PlotFault, asked
from facescript.plot.font import width
from facescript.plot.lanes import strip
from facescript.plot.looks import GREY, INK, LIGHT, PAPER
from facescript.plot.marks import LARGE, LARGEST, SMALL, Drawing, Mark, Text, box, upright
from facescript.plot.panels import INNER, strips
from facescript.plot.sound import energy
from facescript.plot.target import targets
from facescript.plot.usual import HEARD, usual
from facescript.plot.words import AxisStrip, word_strip

WIDTH, NARROWEST = 1200, 400
"""Width of a plot unless a size is asked for, and the least, px."""

TALL = 90
"""Height of the curves of a panel unless a size is asked for, px."""

HIGHEST = 8192
"""Pixels of the highest picture."""

LEFT, RIGHT, BOTTOM = 92, 20, 12
"""Margins, px."""

TITLE, HEADING, BETWEEN = 40, 26, 18
"""Heights of the title and of a face's name, and what is free between blocks, px."""


class Strip(Protocol):
    """A part of the picture from left to right: `fixed` px high, and of what height is left a share by `weight`."""

    @property
    def fixed(self) -> float: ...
    @property
    def weight(self) -> float: ...
    def marks(self, scale: Scale, top: float, height: float) -> Iterator[Mark]: ...


@dataclass(frozen=True, slots=True)
class Block:
    """What belongs to one face, or to the film: `body` lies on the grid, `foot` below it."""

    name: str
    body: tuple[Strip, ...]
    foot: tuple[Strip, ...]

    @property
    def strips(self) -> tuple[Strip, ...]:
        return self.body + self.foot

    @property
    def fixed(self) -> float:
        return (HEADING if self.name else 0) + sum(part.fixed for part in self.strips) + BETWEEN


@dataclass(frozen=True, slots=True)
class Asked:
    """What a plot is to be: the script's name, the channels (none: the usual), the size in px (None: as it comes)."""

    name: str
    channels: tuple[str, ...] = ()
    size: tuple[int, int] | None = None


def draw(job: Job, wanted: Asked) -> Drawing:
    """The plot of a job from its start to its end. Raises `PlotFault`."""
    wide = wanted.size[0] if wanted.size else WIDTH
    scale = Scale(LEFT, max(wide, NARROWEST) - RIGHT, job.start, job.end)
    blocks, fixed, weight = [], float(TITLE - BETWEEN + BOTTOM), 0.0
    for block in _blocks(job, wanted.channels, scale):
        blocks.append(block)
        fixed, weight = fixed + block.fixed, weight + sum(part.weight for part in block.strips)
        if fixed + weight * INNER > HIGHEST:
            raise PlotFault("FS922", most=HIGHEST)
    height, share = _height(fixed, weight, wanted)
    title = f"{wanted.name}, seed {job.score.film.seed}"
    marks = [box(0, 0, wide, height, PAPER), *_title(wanted.name, job, scale)]
    top: float = TITLE
    for block in blocks:
        marks.extend(_marks(block, scale, top, share))
        top += block.fixed + share * sum(part.weight for part in block.strips)
    return Drawing(wide, height, title, _description(job), marks)


def _height(fixed: float, weight: float, wanted: Asked) -> tuple[int, float]:
    """The picture's height, and how high the curves of a panel of weight 1 are."""
    least = ceil(fixed + weight * INNER)
    if wanted.size is None:
        share = min(TALL, (HIGHEST - fixed) / weight) if weight else 0.0
        return round(fixed + weight * share), share
    width, height = wanted.size
    if width < NARROWEST or height < least:
        raise PlotFault("FS921", size=f"{width}x{height}", least=f"{max(width, NARROWEST)}x{max(height, least)}")
    return height, (height - fixed) / weight if weight else 0.0


# ------------------------------------------------------------------------------------------------ blocks


def _blocks(job: Job, names: Sequence[str], scale: Scale) -> Iterator[Block]:
    seen = {face.name: channels_of(face.parts) for face in job.score.faces if face.seen}
    if names and not seen:
        raise PlotFault("FS923", channels=", ".join(names))
    panels = asked(names, seen) if names else None
    lanes = [found for lane in film_lanes(job.score, job.play) if (found := strip(lane, scale)) is not None]
    if lanes:
        yield Block("", tuple(lanes), ())
    for face in job.score.faces:
        chosen = usual(seen[face.name]) if face.seen else HEARD
        if panels is not None:
            chosen = panels.get(face.name, ())
        block = _block(job, face, chosen, scale)
        if block.body and not (panels is not None and not chosen):
            yield block


def _block(job: Job, face: Face, panels: Sequence[Panel], scale: Scale) -> Block:
    """A face: its lanes, its panels, the time axis, its words."""
    lines = [line for line in job.score.lines if line.face == face.name]
    aims = tuple(targets(job.score, face, scale)) if face.seen else ()
    lanes = [found for lane in face_lanes(job.score, face) if (found := strip(lane, scale)) is not None]
    curves = job.performance.faces.get(face.name)
    body: list[Strip] = [*lanes, *strips(panels, curves, scale, aims, energy(lines, scale))]
    words = word_strip(lines, scale)
    name = face.name if len(job.score.faces) > 1 else ""
    return Block(name, tuple(body), (AxisStrip(), *([words] if words else [])))


# ------------------------------------------------------------------------------------------------ marks


def _marks(block: Block, scale: Scale, top: float, share: float) -> Iterator[Mark]:
    """The grid, and every strip in its place on it."""
    if block.name:
        yield Text(scale.left, top + LARGE + 2, block.name, LARGE, "start", INK)
        top += HEADING
    height = sum(part.fixed + share * part.weight for part in block.body)
    for time, _ in scale.ticks():
        yield upright(scale.x(time), top, top + height, LIGHT)
    for part in block.strips:
        yield from part.marks(scale, top, part.fixed + share * part.weight)
        top += part.fixed + share * part.weight


def _title(name: str, job: Job, scale: Scale) -> Iterator[Mark]:
    whole = f"{round(job.score.duration, 2):g} s"
    stretch = whole if scale.end - scale.start >= job.score.duration else f"{job.start:g} s to {job.end:g} s of {whole}"
    yield Text(scale.left, 26, name, LARGEST, "start", INK)
    rest = f"seed {job.score.film.seed}, {stretch}"
    yield Text(scale.left + width(name, LARGEST) + 14, 26, rest, SMALL, "start", GREY)


def _description(job: Job) -> str:
    said = "\n".join(f"{face}: {text}" for face, text in job.spoken())
    return f"Acts and curves from {job.start:g} s to {job.end:g} s." + (f"\n{said}" if said else "")
