"""A play to its score: the scenes are solved one after another, or all together where events reach into them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from operator import itemgetter

from facescript.diagnostics.model import Diagnostics
from facescript.diagnostics.wording import tell
from facescript.ir.play import Play, Scene
from facescript.schedule.faults import Fault, Faults, hand_over
from facescript.schedule.film import Placed, Timed
from facescript.schedule.kept import Kept
from facescript.schedule.means import Budget, Means, budget
from facescript.schedule.part import Part
from facescript.schedule.score import Score
from facescript.schedule.solving import Solving
from facescript.schedule.steps import NEVER
from facescript.schedule.stretches import Stretch, joined, stretches
from facescript.space.planner import Rest
from facescript.speech.model import VoiceBox

WIDTHS = (1, 2, 4, 8)
"""So many of the shortest stretches of a scene are tried as one, until things are at rest after them."""

LONGEST = 4 * 3600.0
"""Seconds of a film."""


def schedule(play: Play, voice: VoiceBox, diagnostics: Diagnostics) -> Score | None:
    """The score of a play, or None where its times cannot be solved (then `diagnostics` says why).

    Lines are spoken by `voice`; where that only estimates, the score is `estimated`, and conflicts that rest on it
    are warnings.
    """
    timed = timed_by(play, voice, diagnostics, Kept())
    return timed.score() if timed is not None else None


def timed_by(play: Play, voice: VoiceBox, diagnostics: Diagnostics, kept: Kept) -> Timed | None:
    """The play with its times, as `schedule` has them. What `kept` has of the play before is not solved again."""
    long = NEVER if play.film.long is None else play.film.long
    means = Means(play, voice, kept.turn_to(play, voice))
    whole = budget(kept.statements(play))
    if play.events:
        parts = [Placed(Solving(play, means, whole, long, False).part(), 0.0, 0)]
    else:
        parts = _Apart(play, means, kept, long, whole).parts()
    timed = Timed(play, tuple(parts), min(long, max(one.start + one.part.written.lasts for one in parts)))
    faults = list(_faults(timed, long))
    hand_over(faults, diagnostics)
    return None if any(fault.error for fault, _ in faults) else timed


@dataclass(slots=True)
class _Apart:
    """Solves each scene for itself; a long one in stretches, as far as things come to rest between them. `left` is what
    is left of the budget."""

    play: Play
    means: Means
    kept: Kept
    long: float
    left: Budget

    def parts(self) -> list[Placed]:
        found: list[Placed] = []
        start, rough = 0.0, False
        for number, scene in enumerate(self.play.scenes):
            if start >= self.long:
                break
            traits = self.kept.traits(scene)
            cut = stretches(traits) if traits else None
            placed = self._stretched(scene, number, cut, start, rough) if cut else None
            found += placed or [Placed(self._scene(scene, start, rough), start, number)]
            last = found[-1]
            if last.part.spent:
                break
            start, rough = last.start + last.part.end, last.part.rough
        return found

    def _scene(self, scene: Scene, start: float, rough: bool) -> Part:
        key = ("scene", id(scene))
        part = self.kept.part(key, self.long - start, rough)
        if part is None or not self.left.covers(part.cost):
            play = replace(self.play, scenes=(scene,))
            part = Solving(play, self.means, self.left, self.long - start, rough).part()
        self.kept.keep(key, scene, part)
        self.left.spend(part.cost)
        return part

    def _stretched(
        self, scene: Scene, number: int, cut: list[Stretch], start: float, rough: bool
    ) -> list[Placed] | None:
        """A scene in stretches, each as short as things at its end allow; None where it has to be solved as one."""
        found: list[Placed] = []
        rests: dict[str, Rest] = {}
        at, left = 0, replace(self.left)
        while at < len(cut):
            for width in _widths(len(cut) - at):
                part = self._stretch(scene, joined(cut[at : at + width]), rests, self.long - start, rough, left)
                if not part.calm.sound or not (self.long == NEVER or part.reach < self.long - start):
                    return None
                if part.calm.over:
                    break
            found.append(Placed(part, start, number, begins=not found))
            at += width
            left.spend(part.cost)
            rests.update(part.calm.left)
            start, rough = start + part.end, part.rough
        self.left = left
        return found

    def _stretch(
        self, scene: Scene, stretch: Stretch, rests: dict[str, Rest], long: float, rough: bool, left: Budget
    ) -> Part:
        ids = tuple(map(id, stretch.items))
        key = (scene.name, ids, stretch.names, stretch.after_line, tuple(sorted(rests.items(), key=itemgetter(0))))
        part = self.kept.part(key, long, rough)
        if part is None or not left.covers(part.cost):
            body = replace(scene.body, items=stretch.items)
            play = replace(self.play, scenes=(replace(scene, body=body),))
            part = Solving(play, self.means, left, long, rough, stretch, dict(rests)).part()
        self.kept.keep(key, stretch.items, part)
        return part


def _widths(most: int) -> Iterator[int]:
    """How many stretches are tried as one: one, a few, at last all that are left."""
    yield from (width for width in WIDTHS if width < most)
    yield most


# ------------------------------------------------------------------------------------------------ what is wrong


def _faults(timed: Timed, long: float) -> Iterator[tuple[Fault, float]]:
    """What is wrong with a play's times, with the starts that it counts from."""
    yield from ((fault, one.start) for one in timed.parts for fault in one.part.solving)
    if any(one.part.failed for one in timed.parts):
        return
    yield from ((fault, one.start) for one in timed.parts for fault in one.part.checks)
    yield from ((fault, 0.0) for fault in _of_all(timed, long).found.values())


def _of_all(timed: Timed, long: float) -> Faults:
    """What is wrong with the film as a whole: scenes that it never comes to, and its length."""
    faults, scenes, last = Faults(), timed.play.scenes, timed.parts[-1]
    if not timed.play.events and last.scene + 1 < len(scenes):
        faults.unplayed(scenes[last.scene + 1], last.start + last.part.end, long)
    if timed.duration > LONGEST:
        faults.add("FS423", scenes[-1].span, lasts=tell(timed.duration), longest=tell(LONGEST))
    return faults
