"""The score: every act at its absolute time, with the draws drawn and the gaze shifts planned."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.ir.acts import Verb
from facescript.ir.play import Face, Film, Target, Viseme
from facescript.space.plan import GazePlan
from facescript.speech.model import Spoken
from facescript.text import Span

FOREVER = float("inf")


@dataclass(frozen=True, slots=True)
class TimedAct:
    """An act in time, seconds from the film's start.

    `verb` holds plain numbers only (draws drawn, times filled with the verb's defaults). `start` is when it begins,
    `settled` when the next statement may, `released` when it begins to let go (FOREVER: until replaced or the
    scene's end), `end` when nothing of it is left. `order` breaks ties of `start`: the later line wins.
    `label` is its name in the outputs (`trials.7.cued`), `plan` the gaze shift of a look, glance or one stop of a scan.
    `persons` says which target each person of a reaction is; `estimated` whether its times rest on a line that no
    voice has spoken yet. `seed` is its own where it lives by itself (a spontaneous expression): of the film's seed,
    its face and its place in the script.
    """

    order: int
    verb: Verb
    face: str | None
    scene: int
    start: float
    settled: float
    released: float
    end: float
    span: Span
    label: str | None = None
    plan: tuple[GazePlan, ...] = ()
    drops: tuple[tuple[int, int], ...] = ()
    persons: tuple[tuple[str, str], ...] = ()
    estimated: bool = False
    seed: int = 0


@dataclass(frozen=True, slots=True)
class TimedLine:
    """A spoken line at its time. `cut` is where it breaks off (a reaction took the voice), else None; `text` is what
    it says, plain, in which the words of `spoken` stand."""

    face: str
    start: float
    spoken: Spoken
    volume: float
    span: Span
    label: str | None = None
    cut: float | None = None
    text: str = ""

    @property
    def end(self) -> float:
        """When its last sound is over."""
        return self.cut if self.cut is not None else self.start + self.spoken.duration


@dataclass(frozen=True, slots=True)
class TimedScene:
    """A scene as it is played. `again` is how often it was played before; None where those are in the score too."""

    name: str
    faces: tuple[str, ...]
    start: float
    end: float
    title: str = ""
    again: int | None = None


@dataclass(frozen=True, slots=True)
class TimedBlock:
    """A block with a clock of its own: a call of an action (`span` is where it is called) or a pass of a `repeat`.
    `settled` is when the next statement may start, `estimated` whether a line that no voice has spoken is in it."""

    span: Span
    start: float
    settled: float
    estimated: bool = False


@dataclass(frozen=True, slots=True)
class Marker:
    """A named statement in the outputs: `trials.7.cued` at a time."""

    name: str
    time: float


@dataclass(frozen=True, slots=True)
class Score:
    """A play in time. `acts` are sorted by (start, order), `blocks` are in the order written."""

    film: Film
    faces: tuple[Face, ...]
    targets: tuple[Target, ...]
    scenes: tuple[TimedScene, ...]
    acts: tuple[TimedAct, ...]
    lines: tuple[TimedLine, ...]
    markers: tuple[Marker, ...]
    duration: float
    estimated: bool = False
    visemes: tuple[Viseme, ...] = ()
    blocks: tuple[TimedBlock, ...] = ()
