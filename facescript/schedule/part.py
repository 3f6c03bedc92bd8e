"""A part of a film: scenes that hang together, solved; all its times are seconds from its own start."""

from __future__ import annotations

from dataclasses import dataclass, replace

from facescript.ir.acts import Say
from facescript.schedule.faults import Fault
from facescript.schedule.score import Marker, TimedAct, TimedBlock, TimedLine
from facescript.space.plan import GazePlan
from facescript.space.planner import Rest
from facescript.speech.model import Spoken


@dataclass(frozen=True, slots=True)
class Cost:
    """What solving a part took: statements, all rounds together (in statements), movements of eyes and head."""

    statements: int = 0
    work: float = 0.0
    moves: float = 0.0


@dataclass(frozen=True, slots=True)
class Written:
    """What a part gives to the score; acts in the order written. `lasts` is when all of it is over."""

    acts: tuple[TimedAct, ...]
    lines: tuple[TimedLine, ...]
    markers: tuple[Marker, ...]
    blocks: tuple[TimedBlock, ...]
    lasts: float


NOTHING = Written((), (), (), (), 0.0)


@dataclass(frozen=True, slots=True)
class Opening:
    """A scene as it was played, by its number among the part's, and when it started."""

    scene: int
    start: float


@dataclass(frozen=True, slots=True)
class Calm:
    """How things are at the end of a stretch: whether it is `sound` (nothing in it reaches before its start), whether
    nothing of it goes on (`over`), and the gaze at rest that it leaves."""

    sound: bool = False
    over: bool = False
    left: tuple[tuple[str, Rest], ...] = ()


@dataclass(frozen=True, slots=True)
class Part:
    """`end` is when what follows may start, and `rough` whether it rests on an estimate. `solving` are the faults that
    its times have, `checks` those of what is done at them; where it `failed` it has no times. `begun` says how it
    begins: its length at most, and whether its start is rough. `outside` are lines that hang on files, `astray` the
    orders of the acts whose gaze stays short or is hurried, `calm` how things are at its end. What is `passing` may be
    otherwise the next time; where the budget is `spent`, nothing that follows is solved.
    """

    scenes: tuple[Opening, ...]
    written: Written
    end: float
    rough: bool
    failed: bool
    solving: tuple[Fault, ...]
    checks: tuple[Fault, ...]
    begun: tuple[float, bool]
    cost: Cost
    outside: tuple[tuple[Say, Spoken], ...] = ()
    astray: tuple[int, ...] = ()
    passing: bool = False
    spent: bool = False
    calm: Calm = Calm()

    @property
    def reach(self) -> float:
        """From when on it would be the same however long it might be."""
        return max(self.end, self.written.lasts)


def act_at(act: TimedAct, start: float, scene: int, before: int) -> TimedAct:
    """An act of a part that starts then, with the scene `scene`, after `before` other acts."""
    return TimedAct(
        before + act.order,
        act.verb,
        act.face,
        scene + act.scene,
        start + act.start,
        start + act.settled,
        start + act.released,
        start + act.end,
        act.span,
        act.label,
        tuple(plan_at(plan, start) for plan in act.plan),
        tuple((before + order, term) for order, term in act.drops),
        act.persons,
        act.estimated,
        act.seed,
    )


def plan_at(plan: GazePlan, start: float) -> GazePlan:
    """A gaze shift of a part that starts then."""
    return GazePlan(
        plan.aim,
        plan.parts,
        start + plan.eye_onset,
        start + plan.landed,
        start + plan.head_onset,
        start + plan.head_done,
        plan.head_share,
        plan.amplitude,
        start + plan.released,
        plan.instant,
        plan.unreachable,
        start + plan.worst if plan.unreachable or plan.lost else plan.worst,
        plan.at_times,
        plan.lost,
        start + plan.eye_done,
        plan.head_from,
        plan.needs,
    )


def line_at(line: TimedLine, start: float) -> TimedLine:
    """A line of a part that starts then."""
    return replace(line, start=start + line.start, cut=None if line.cut is None else start + line.cut)


def block_at(block: TimedBlock, start: float) -> TimedBlock:
    """A block of a part that starts then."""
    return replace(block, start=start + block.start, settled=start + block.settled)
