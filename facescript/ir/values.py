"""Quantities of a play: numbers in base units, draws that the seed decides, moments, places in the room."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Draw:
    """A number the seed draws, uniform between `low` and `high` (`2s to 6s`)."""

    low: float
    high: float


Amount = float | Draw
"""Base units everywhere: seconds, degrees, centimetres, 1 for 100 %, 1/min for rates."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A place on the clock of something named: `hello.end`, `hello."cup".2.end`, `trials.7.cued.start`.

    `label` is the full name as `Do.label` bears it (see `ir.acts.Do` for the scheme and for `*` in the body of a
    `Repeat`); `word` is the spoken word as written, `nth` from 1 (`ir.wording.find` says where it is in the line).
    """

    label: str
    edge: str = "start"
    word: str | None = None
    nth: int = 1


@dataclass(frozen=True, slots=True)
class Moment:
    """A time: `offset` seconds after `mark`, or after the start of the block it stands in where there is none."""

    offset: Amount
    mark: Mark | None = None


@dataclass(frozen=True, slots=True)
class Point:
    """A place in the room: cm, x to the viewer's right, y up, z from the screen to the viewer."""

    x: float
    y: float
    z: float


@dataclass(frozen=True, slots=True)
class PicturePlace:
    """A place in the picture, as fractions of its width and height from its centre; x right, y up."""

    x: float
    y: float


# ------------------------------------------------------------------------------------------------ what is looked at


@dataclass(frozen=True, slots=True)
class AtTarget:
    """A declared target; `member` is the number (from 1) of one of a crowd, or "nearest"."""

    name: str
    member: int | str | None = None


@dataclass(frozen=True, slots=True)
class AtFace:
    """Another face, or a part of it: "eyes" or "mouth"."""

    face: str
    part: str = "eyes"


@dataclass(frozen=True, slots=True)
class AtCamera:
    """Straight ahead of the picture, 60 cm away."""


@dataclass(frozen=True, slots=True)
class Towards:
    """A direction from straight ahead, drawn as it is; deg, yaw + is the viewer's right, pitch + up."""

    yaw: Amount
    pitch: Amount


@dataclass(frozen=True, slots=True)
class Away:
    """Somewhere else, by the seed."""


@dataclass(frozen=True, slots=True)
class AtPerson:
    """Whom an event brought (`when person arrives as guest`): bound to a target when the event happens."""

    name: str


Aim = AtTarget | AtFace | AtCamera | Towards | Away | AtPerson


# ------------------------------------------------------------------------------------------------ what is shown


@dataclass(frozen=True, slots=True)
class Driver:
    """One thing a term moves: a muscle, lid, blink or other channel by its name, at degree 100 %, in its own unit."""

    name: str
    value: Amount


@dataclass(frozen=True, slots=True)
class Term:
    """One term of a sum: an expression, FACS unit, muscle or channel with its degree (negative where subtracted).

    `name` is as an author writes it (`smile`, `smile.left`, `AU6`, `head.roll`): `drop` finds terms by it. No two
    drivers of a term bear one name, and their values are plain numbers; only the degree may be drawn.
    """

    name: str
    degree: Amount
    drivers: tuple[Driver, ...]


@dataclass(frozen=True, slots=True)
class Mix:
    """A sum of terms; empty is neutral."""

    terms: tuple[Term, ...] = ()
