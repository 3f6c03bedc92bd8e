"""A job to the chapters of a book: what is read in each scene, and what stands beside the faces meanwhile."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from io import BytesIO

from facescript.backends.job import Job
from facescript.backends.page.document import called, titled
from facescript.backends.page.words import Line, lines
from facescript.backends.svg.ground import picture_kind
from facescript.ir.acts import AddLink, SetPicture
from facescript.ir.play import MAIN
from facescript.pictures import opened
from facescript.schedule.score import TimedAct, TimedScene


@dataclass(frozen=True, slots=True)
class Beside:
    """A picture or a link beside the faces, from `start` to `end`."""

    shown: SetPicture | AddLink
    start: float
    end: float


@dataclass(frozen=True, slots=True)
class Chapter:
    """A scene of the film from `start` to `end`. All times are seconds from the job's start."""

    title: str
    start: float
    end: float
    faces: tuple[str, ...]
    lines: tuple[Line, ...]
    beside: tuple[Beside, ...]

    @property
    def duration(self) -> float:
        return self.end - self.start

    def flow(self) -> Iterator[tuple[int, Line] | Beside]:
        """What stands below each other: the lines with their numbers from 1, a picture before the line in which it
        appears, a link behind it."""
        waiting = list(self.beside)
        for number, line in enumerate(self.lines, start=1):
            yield from _taken(waiting, SetPicture, line.end)
            yield number, line
            yield from _taken(waiting, AddLink, line.end)
        yield from waiting


def chapters(job: Job) -> list[Chapter]:
    """The scenes of a job's stretch that last."""
    said = lines(job.score, job.start, job.end)
    found = []
    for number, scene in enumerate(job.score.scenes):
        start, end = max(scene.start, job.start) - job.start, min(scene.end, job.end) - job.start
        if start < end:
            own = tuple(line for line in said if line.scene == number)
            beside = _beside(job, number, start, end)
            found.append(Chapter(_titled(job, scene), start, end, scene.faces, own, beside))
    return found


def speakers(found: Sequence[Chapter]) -> dict[str, str]:
    """The names of those who speak in a book, where they are several."""
    faces = dict.fromkeys(line.face for chapter in found for line in chapter.lines)
    return {face: called(face) for face in faces} if len(faces) > 1 else {}


def pictures(job: Job, found: Sequence[Chapter]) -> Iterator[tuple[str, bytes, str]]:
    """The pictures beside the faces, each once: its path in the project, its bytes as browsers and books may have
    them, and their kind. BMP becomes PNG."""
    shown = (beside.shown for chapter in found for beside in chapter.beside)
    for path in dict.fromkeys(each.picture for each in shown if isinstance(each, SetPicture)):
        if path is not None:
            yield path, *_fit(job.pictures(path))


def _fit(data: bytes) -> tuple[bytes, str]:
    kind = picture_kind(data)
    if kind != "image/bmp":
        return data, kind
    out = BytesIO()
    opened(data).save(out, "PNG")
    return out.getvalue(), "image/png"


def _titled(job: Job, scene: TimedScene) -> str:
    """A scene's title or its name; the only scene of a script without `scene` is called as the book is."""
    return scene.title or (titled(job) if scene.name == MAIN else called(scene.name))


def _taken(waiting: list[Beside], kind: type, before: float) -> Iterator[Beside]:
    """What of a kind appears before a time, taken from those that wait."""
    due = [beside for beside in waiting if isinstance(beside.shown, kind) and beside.start < before]
    for beside in due:
        waiting.remove(beside)
        yield beside


def _beside(job: Job, scene: int, start: float, end: float) -> tuple[Beside, ...]:
    """What stands beside the faces of a scene; a picture until the next one."""
    acts = [act for act in job.score.acts if act.scene == scene and isinstance(act.verb, (SetPicture, AddLink))]
    turns = [act.start for act in acts if isinstance(act.verb, SetPicture)]
    found = [_shown(job, act, turns, (start, end)) for act in acts]
    return tuple(beside for beside in found if beside is not None and beside.start < beside.end)


def _shown(job: Job, act: TimedAct, turns: Sequence[float], stretch: tuple[float, float]) -> Beside | None:
    verb, (first, last) = act.verb, stretch
    begun = max(act.start - job.start, first)
    if isinstance(verb, AddLink):
        return Beside(verb, begun, last)
    if not isinstance(verb, SetPicture) or verb.picture is None:
        return None
    until = min((turn - job.start for turn in turns if turn > act.start), default=last)
    return Beside(verb, begun, min(until, last))
