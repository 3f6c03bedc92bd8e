"""A job to the chapters of a book: what is read in each scene, and what stands beside the faces meanwhile."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from facescript.backends.job import Job
from facescript.backends.page.document import called, titled
from facescript.backends.page.words import Line, lines
from facescript.ir.acts import AddLink, SetPicture
from facescript.ir.play import MAIN
from facescript.schedule.score import TimedAct, TimedScene


@dataclass(frozen=True, slots=True)
class Beside:
    """A picture or a link beside the faces, from `start` to `end` (seconds from the chapter's start)."""

    shown: SetPicture | AddLink
    start: float
    end: float


@dataclass(frozen=True, slots=True)
class Chapter:
    """A scene of the film, seconds `start` to `end` of it. The times of its `lines` and of what is `beside` the faces
    count from its start."""

    title: str
    start: float
    end: float
    lines: tuple[Line, ...]
    beside: tuple[Beside, ...]

    @property
    def duration(self) -> float:
        return self.end - self.start


def chapters(job: Job) -> list[Chapter]:
    """The scenes of a job's stretch that last."""
    found = []
    for number, scene in enumerate(job.score.scenes):
        start, end = max(scene.start, job.start), min(scene.end, job.end)
        if start < end:
            said = tuple(lines(job.score, start, end))
            found.append(Chapter(_titled(job, scene), start, end, said, _beside(job, number, start, end)))
    return found


def _titled(job: Job, scene: TimedScene) -> str:
    """A scene's title or its name; the only scene of a script without `scene` is called as the book is."""
    return scene.title or (titled(job) if scene.name == MAIN else called(scene.name))


def _beside(job: Job, scene: int, start: float, end: float) -> tuple[Beside, ...]:
    """What stands beside the faces of a scene; a picture until the next one."""
    acts = [act for act in job.score.acts if act.scene == scene and isinstance(act.verb, (SetPicture, AddLink))]
    turns = [act.start for act in acts if isinstance(act.verb, SetPicture)]
    found = [_shown(act, turns, start, end) for act in acts]
    return tuple(beside for beside in found if beside is not None and beside.start < beside.end)


def _shown(act: TimedAct, turns: Sequence[float], start: float, end: float) -> Beside | None:
    verb = act.verb
    if isinstance(verb, AddLink):
        return Beside(verb, max(act.start - start, 0.0), end - start)
    if not isinstance(verb, SetPicture) or verb.picture is None:
        return None
    until = min([turn for turn in turns if turn > act.start], default=end)
    return Beside(verb, max(act.start - start, 0.0), min(until, end) - start)
