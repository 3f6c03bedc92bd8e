"""One round of the solution: with what the round before has learned, every step gets its times."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from facescript.ir.acts import Do, Say
from facescript.ir.play import Play
from facescript.schedule.deeds import Deed, Sounding, deeds, soundings
from facescript.schedule.events import Trigger, roots
from facescript.schedule.facts import Control, Hold, Holds
from facescript.schedule.lengths import PAUSE
from facescript.schedule.rules import Times
from facescript.schedule.solver import Solver
from facescript.schedule.steps import DONE, NEVER, Key, Maker, Root, Step, ends_in_line
from facescript.schedule.voices import word_end

NUMBER = 3
"""Where in a reaction's place its number stands."""


@dataclass(frozen=True, slots=True)
class Begin:
    """With which scene a round begins and when, how many were played before, the number of the first run of each among
    them, and when that scene's time is up, where that is known."""

    scene: int = 0
    start: float = 0.0
    played: int = 0
    first: tuple[tuple[int, int], ...] = ()
    limit: float = NEVER


@dataclass(slots=True)
class Played:
    """A scene as it was played: of which of the play's scenes, and when its time was up."""

    scene: int
    root: Root
    end: float


@dataclass(slots=True)
class Round:
    """All the trees of a play, solved. `end` is when the last scene has ended, and `rough` whether that (and at first
    the start of the first one) rests on an estimate. `first` is which scene played was the first run of one of the
    play's; a `stopped` film lives on after its last scene. It may `begin` later than the film, with `orders` deeds done
    before."""

    play: Play
    times: Times
    maker: Maker
    long: float
    rough: bool = False
    after_line: bool = False
    begin: Begin = Begin()
    orders: int = 0
    end: float = 0.0
    scenes: list[Played] = field(default_factory=list)
    first: dict[int, int] = field(default_factory=dict)
    reactions: list[Root] = field(default_factory=list)
    unplayed: list[tuple[int, float]] = field(default_factory=list)
    stopped: bool = False
    done: list[Deed] = field(default_factory=list)
    late: list[Step] = field(default_factory=list)

    def run(self, triggers: list[Trigger], planted: Iterable[Root] | None = None) -> None:
        """Solve the reactions, then the scenes that they stop and restart, and gather what is done. The reactions'
        trees may be `planted` already."""
        solver = Solver(self.times)
        for root in roots(triggers, self.maker, self.long) if planted is None else planted:
            solver.solve(root.top, DONE)
            self.reactions.append(root)
        self._play(solver, self._controls(triggers))
        trees = [*(played.root for played in self.scenes), *self.reactions]
        self.done, self.late = deeds(trees, self.times.voices, self.orders)

    # -------------------------------------------------------------------------------------------- scenes

    def _play(self, solver: Solver, controls: list[Control]) -> None:
        """Play scene after scene. A `stop` ends the scene, a `restart` plays it again; the last scene, once it has
        ended, can still be played again."""
        number, start, coming = self.begin.scene, self.begin.start, 0
        self.first.update(self.begin.first)
        while number < len(self.play.scenes):
            if start >= min(self.long, self.times.horizon):
                self.unplayed += [(later, start) for later in range(number, len(self.play.scenes))]
                return
            while coming < len(controls) and controls[coming].time <= start:
                coming += 1
            limit = controls[coming].time if coming < len(controls) else NEVER
            if not self.scenes and self.begin.limit < limit:
                limit = self.begin.limit
                controls.insert(coming, Control(limit, "stop"))
            root = self._scene(number, start, min(limit, self.long))
            end, self.rough = solver.solve(root.top, DONE)
            last = number == len(self.play.scenes) - 1
            control = controls[coming] if limit < end else None
            self.stopped = control is not None and control.kind == "stop"
            if control is not None:
                end = control.time
            if last and (control is None or control.kind == "stop"):
                control = next((one for one in controls[coming:] if one.kind == "restart"), None)
                end = control.time if control else end
            self.scenes.append(Played(number, root, end))
            number += control is None or control.kind == "stop"
            start = self.end = end

    def _controls(self, triggers: Sequence[Trigger]) -> list[Control]:
        """The stops and restarts of the reactions that come to their end, in time."""
        controls = []
        for root, trigger in zip(self.reactions, triggers, strict=True):
            ending, time = trigger.reaction.ending, root.top.time(DONE)
            if ending != "resume" and time <= root.top.limit and time < self.long:
                controls.append(Control(time, ending))
        return sorted(controls, key=lambda control: control.time)

    def _scene(self, number: int, start: float, limit: float) -> Root:
        scene = self.play.scenes[number]
        index = self.begin.played + len(self.scenes)
        again = index - self.first.setdefault(number, index)
        root = Root(0, ("scene", scene.name, *([again] if again else [])), start, self.maker, scene=len(self.scenes))
        root.after_line = self.after_line
        root.plant(scene.body, limit, self.rough, index)
        return root

    # -------------------------------------------------------------------------------------------- what it learns

    def sounds(self) -> Iterator[Sounding]:
        """Every line as far as it sounds, in the order written."""
        for deed in self.done:
            if isinstance(deed.verb, Say):
                yield from soundings(deed.step, self.times.voices)

    def holds(self) -> Holds:
        """Which voices the reactions have, when."""
        ends = _ends(self.reactions)
        past = self.maker.past
        first: dict[tuple[int, str], tuple[float, float]] = dict(past.voiced) if past is not None else {}
        for step, due, start in self.times.requests:
            assert isinstance(step.node, Do) and step.node.face is not None
            if due < step.limit:
                key = (step.root.rank, step.node.face)
                wait = (due, start - due)
                first[key] = min(wait, first.get(key, wait))
        holds = (Hold(face, rank, due, *ends[rank], delay) for (rank, face), (due, delay) in first.items())
        return Holds(tuple(sorted(holds, key=lambda hold: (hold.start, hold.rank))))

    def delays(self) -> dict[Key, float]:
        """Until when each line of a reaction waits for the end of the word that its face is saying."""
        if not self.times.requests:
            return {}
        sounding = _Voiced(list(self.sounds()))
        delays: dict[Key, float] = {}
        for step, due, _ in self.times.requests:
            for one in sounding.at(step, due):
                spoken = self.times.voices.speak(one.line, one.step.node.span)
                end = min(one.end, one.start + word_end(spoken, due - one.start))
                delays[step.key()] = max(end, delays.get(step.key(), end))
        return delays

    def starts(self) -> tuple[float, ...]:
        """When each scene starts."""
        return tuple(played.root.start for played in self.scenes)

    def natural_end(self) -> float:
        """When all has been done, NEVER where something goes on for ever."""
        reactions = [min(root.top.time(DONE), root.top.limit) for root in self.reactions]
        lines = [one.end for one in self.sounds()]
        releases = [deed.release for deed in self.done if deed.release < NEVER]
        settled = [deed.settled for deed in self.done]
        return max([self.scenes[-1].end, *reactions, *lines, *releases, *settled])


class _Voiced:
    """The lines of each face in the order they sound."""

    def __init__(self, sounds: list[Sounding]) -> None:
        self._rows: dict[str, list[Sounding]] = {}
        self._longest = max((sound.end - sound.start for sound in sounds), default=0.0)
        for sound in sorted(sounds, key=_begins):
            self._rows.setdefault(sound.face, []).append(sound)

    def at(self, step: Step, time: float) -> Iterator[Sounding]:
        """The lines of a step's face, of lower rank, that sound at a time."""
        assert isinstance(step.node, Do) and step.node.face is not None
        row = self._rows.get(step.node.face, [])
        last = bisect_left(row, time, key=_begins)
        for sound in row[bisect_left(row, time - self._longest, key=_begins) : last]:
            if sound.step.root.rank < step.root.rank and time < sound.end:
                yield sound


def _begins(sound: Sounding) -> float:
    return sound.start


def _ends(reactions: Sequence[Root]) -> dict[int, tuple[float, float]]:
    """When each reaction has settled, and the pause before a line that follows; one that is started afresh has when
    its follower has."""
    ends: dict[int, tuple[float, float]] = {}
    followers: dict[Hashable, tuple[float, float]] = {}
    for root in reversed(reactions):
        number = root.place[NUMBER]
        own = (root.top.time(DONE), PAUSE if ends_in_line(root.top) else 0.0)
        if root.afresh and own[0] > root.top.limit:
            own = followers[number]
        ends[root.rank] = followers[number] = own
    return ends
