"""What all parts of a film are solved with: its voice, its room, its draws; and how much solving may cost."""

from __future__ import annotations

from dataclasses import dataclass, field

from facescript.ir.acts import Say, Verb
from facescript.ir.play import Face, Play
from facescript.schedule.defaults import Concrete
from facescript.schedule.part import Cost
from facescript.space.room import Room
from facescript.speech.model import Spoken, VoiceBox, VoiceFailure

MOST = 20_000
"""Statements that a script may come to as it is played: an hour and a half with four a second."""

WORK, EACH = 75_000, 30
"""What all rounds together may cost, in statements solved (some ten microseconds): so much, and more for each
statement that a play has. Scripts come to rest after two to five rounds."""

MOVES = 8
"""So many movements of eyes and head may be worked out in all, for each statement that may be solved."""


@dataclass(slots=True)
class Means:
    """`spoken` are the lines that were spoken so far, `paced` concrete verbs with what `unhurried` makes of them."""

    play: Play
    voice: VoiceBox
    room: Room
    faces: dict[str, Face] = field(init=False)
    concrete: Concrete = field(init=False)
    paced: dict[int, tuple[Verb, Verb]] = field(default_factory=dict)
    spoken: dict[Say, Spoken | VoiceFailure] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.faces = {face.name: face for face in self.play.faces}
        self.concrete = Concrete(self.play.film.seed)


@dataclass(slots=True)
class Budget:
    """What solving may still cost: statements of one round, all rounds together (in statements), movements."""

    statements: int
    work: float
    moves: float

    def spend(self, cost: Cost) -> None:
        self.statements -= cost.statements
        self.work -= cost.work
        self.moves -= cost.moves

    def covers(self, cost: Cost) -> bool:
        return cost.statements <= self.statements and cost.work <= self.work and cost.moves <= self.moves


def budget(statements: int) -> Budget:
    """That of a play with so many statements as it is written."""
    most = WORK + EACH * statements
    return Budget(MOST, most, MOVES * most)
