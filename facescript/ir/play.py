"""The play: a script with names, units and defaults resolved and the library unfolded; its times are still open."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from facescript.ir.acts import Life, Sequence, SetBackground, View, Voice
from facescript.ir.kind import Kind
from facescript.ir.values import Amount, Driver, PicturePlace, Point
from facescript.text import Span

MAIN = "main"
"""The scene's name where a script has none."""


@dataclass(frozen=True, slots=True)
class Film:
    """What the outputs are like. `screen` is the fraction of the true angle at which near targets are looked at;
    `title` and `author` are what books and pages bear, "" where nothing is said."""

    width: int = 1280
    height: int = 720
    fps: float = 30.0
    seed: int = 0
    long: float | None = None
    screen: float = 1 / 3
    wide_cm: float = 50.0
    title: str = ""
    author: str = ""


@dataclass(frozen=True, slots=True)
class Face:
    """A face: its kind, its voice, its life, where it stands (None: in the row), its size; of its looks the colours by
    family, the choices by name and the amounts 0..1 by name; whether its hair moves with its head or is `still`.

    `parts` are those of its kind that have channels of their own; `drawn` is the kind itself where the library has
    none of that name.
    """

    name: str
    kind: str
    voice: Voice
    life: Life
    span: Span
    gaze: Literal["", "eye-mover", "head-mover"] = ""
    place: PicturePlace | None = None
    size: float = 1.0
    looks: tuple[tuple[str, str], ...] = ()
    choices: tuple[tuple[str, str], ...] = ()
    amounts: tuple[tuple[str, float], ...] = ()
    hair: Literal["", "still"] = ""
    parts: tuple[str, ...] = ()
    drawn: Kind | None = None

    @property
    def seen(self) -> bool:
        return self.kind != "unseen"


@dataclass(frozen=True, slots=True)
class FixedTarget:
    name: str
    place: Point | PicturePlace
    span: Span


@dataclass(frozen=True, slots=True)
class MovingTarget:
    """Key places by time from the scene's start; smooth between, still before and after. In the stretches `lost`
    (from, to) nobody knows where it is: they begin and end at keys, or a day before and after the scene's start."""

    name: str
    times: tuple[float, ...]
    places: tuple[Point, ...]
    span: Span
    lost: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Crowd:
    """Several places; members may be named targets."""

    name: str
    members: tuple[Point | PicturePlace | str, ...]
    span: Span


Target = FixedTarget | MovingTarget | Crowd


@dataclass(frozen=True, slots=True)
class Scene:
    """A scene: the faces in it, what is set before it begins, and its block. Every scene starts neutral. `title` is
    that of the chapter it is in a book, "" where it has none but its name."""

    name: str
    faces: tuple[str, ...]
    body: Sequence
    span: Span
    background: SetBackground | None = None
    view: View | None = None
    title: str = ""


@dataclass(frozen=True, slots=True)
class EventPattern:
    """What a reaction waits for: `kind` is heard, touched, key, signal, arrives, leaves or nearest; `text` the words
    of the first four; `binds` the name a person gets."""

    kind: str
    text: str = ""
    binds: str | None = None


@dataclass(frozen=True, slots=True)
class Reaction:
    event: EventPattern
    body: Sequence
    ending: Literal["resume", "restart", "stop"]
    span: Span


@dataclass(frozen=True, slots=True)
class Event:
    """A scripted event, `time` seconds from the film's start; `person` is the target that arrives or leaves."""

    kind: str
    time: Amount
    span: Span
    text: str = ""
    person: str | None = None


@dataclass(frozen=True, slots=True)
class Viseme:
    """How the mouth is at a sound (IPA, as a voice has it): as at the sound that it is `like`, at a degree, or with a
    shape of its own, the mouth's channels by name."""

    sound: str
    like: str = ""
    degree: float = 1.0
    drivers: tuple[Driver, ...] = ()


@dataclass(frozen=True, slots=True)
class Play:
    film: Film
    faces: tuple[Face, ...]
    targets: tuple[Target, ...]
    scenes: tuple[Scene, ...]
    reactions: tuple[Reaction, ...] = ()
    events: tuple[Event, ...] = ()
    background: SetBackground | None = None
    view: View | None = None
    lives: tuple[tuple[str, Life], ...] = field(default=())
    visemes: tuple[Viseme, ...] = ()
