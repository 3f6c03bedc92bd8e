"""The expressions there are to the cells of a sheet: what each is called and what it asks of a face, by sections."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from facescript.ir.values import Driver
from facescript.performance.channels import SIDES
from facescript.resolve.drivers import side_of
from facescript.resolve.expressions import Expression
from facescript.speech.mouth.visemes import SHAPES, Values

YAWS, PITCHES = (-45, -30, -15, 0, 15, 30, 45), (30, 15, 0, -15, -30)
"""Turns of the head, deg: the face's left is the viewer's right."""

ROLLS = (-30, -20, -10, 0, 10, 20, 30)
"""Tilts of the head, deg."""

SIDEWAYS, UPWARDS = (-30, -20, -10, 0, 10, 20, 30), (20, 0, -20)
"""Turns of the eyes, deg."""

PHASES = (0, 25, 50, 75, 100)
"""How far a blink has shut, %."""

WINK = "winking"
"""The library's far pose of a wink."""


@dataclass(frozen=True, slots=True)
class Cell:
    """One picture: its label, and what it asks for. `turn` is where head and eyes turn together, `gaze` how far the
    eyes turn beyond that (yaw and pitch, deg); `spoken` is a shape of the mouth as speech has it."""

    label: str
    drivers: tuple[Driver, ...] = ()
    turn: tuple[float, float] = (0.0, 0.0)
    gaze: tuple[float, float] = (0.0, 0.0)
    spoken: Values | None = None


@dataclass(frozen=True, slots=True)
class Section:
    """Cells under one title; `close` where they are of eyes and mouth alone."""

    title: str
    cells: tuple[Cell, ...]
    close: bool = False


FIRST = Section(
    "", (Cell("at rest"), Cell("turned", turn=(30.0, 5.0)), Cell("speaking", turn=(-12.0, 0.0), spoken=SHAPES["a"]))
)
"""Stands large before all others."""


def sections(expressions: Sequence[Expression], units: bool) -> tuple[Section, ...]:
    """What a sheet shows of a face, `units` of FACS where they are wanted; sections without cells are left out."""
    shown = [each for each in expressions if not each.unit]
    found = (
        Section("Expressions of the script", _shown(each for each in shown if each.own)),
        Section("Expressions of the library", _shown(each for each in shown if not each.own)),
        Section("Shapes of the mouth", tuple(Cell(name, spoken=values) for name, values in SHAPES.items()), close=True),
        Section("Head: yaw, pitch", tuple(Cell(f"{y}°, {p}°", turn=(y, p)) for p in PITCHES for y in YAWS)),
        Section("Head: roll", tuple(Cell(f"{angle}°", (Driver("head.roll", angle),)) for angle in ROLLS)),
        Section(
            "Eyes: yaw, pitch", tuple(Cell(f"{y}°, {p}°", gaze=(y, p)) for p in UPWARDS for y in SIDEWAYS), close=True
        ),
        Section("Blink and wink", tuple(_blinks(expressions)), close=True),
        Section("Units of FACS", _shown(each for each in expressions if each.unit and units)),
    )
    return tuple(section for section in found if section.cells)


def _shown(expressions: Iterable[Expression]) -> tuple[Cell, ...]:
    """A cell for each, at 100 %, but for those that need a value first."""
    return tuple(Cell(each.name, each.drivers) for each in expressions if each.drivers is not None)


def _blinks(expressions: Sequence[Expression]) -> Iterator[Cell]:
    for phase in PHASES:
        yield Cell(f"{phase} %", tuple(Driver(f"blink.{side}", phase / 100) for side in SIDES))
    far = next((each.drivers or () for each in expressions if each.name == WINK), ())
    for side in SIDES:
        yield Cell(f"wink {side}", tuple(driver for driver in far if side_of(driver.name) == side))
