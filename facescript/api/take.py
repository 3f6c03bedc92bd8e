"""A script to a take: one performance of it, to be asked, shown in a notebook and written to files."""

from __future__ import annotations

import base64
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from html import escape
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from facescript.backends.job import Job, JobFailure
from facescript.backends.output import outputs
from facescript.backends.registry import backends
from facescript.compile import Settings
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic
from facescript.diagnostics.render import render
from facescript.project import compile_any, open_script
from facescript.schedule.explain import as_objects, explain
from facescript.schedule.score import Score
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World, WorldFailure

Floats = NDArray[np.float64]

DRAWN = 20.0
"""Seconds of film that a notebook shows as one animated picture; a longer one is shown as a page, made sooner."""


class ScriptFault(ValueError):
    """A script that cannot be played: its text is what `facescript check` prints, `diagnostics` all that was told."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__("\n\n".join(render(item, colour=False) for item in diagnostics))
        self.diagnostics = tuple(diagnostics)


@dataclass(frozen=True)
class Take:
    """One performance of a script. Times are seconds from the film's start; the same script gives the same take.

    >>> import facescript
    >>> take = facescript.loads("show smile 60% over 200ms\\nwait 1s\\n")
    >>> take.duration
    1.2
    >>> round(take.pose(1.0)["cheek.lower.left"], 2) > 0
    True
    >>> take.sample(fps=10)["time"].shape
    (12,)

    `diagnostics` are warnings and hints. `score` has all that was solved, as the compiler knows it.
    """

    job: Job
    diagnostics: tuple[Diagnostic, ...]

    @property
    def score(self) -> Score:
        return self.job.score

    @property
    def duration(self) -> float:
        return self.score.duration

    @property
    def faces(self) -> tuple[str, ...]:
        """The names of the faces that are seen."""
        return tuple(self.job.performance.faces)

    @property
    def channels(self) -> tuple[str, ...]:
        """The names of all channels (docs/language.md); where there are several faces, each has its face's in front."""
        return self.job.performance.names

    def pose(self, time: float) -> dict[str, float]:
        """Every channel at a moment, by name: degrees for heads and eyes, shares of 1 for muscles."""
        return self.job.performance.pose(time)

    def sample(self, times: ArrayLike | None = None, fps: float | None = None) -> dict[str, Floats]:
        """Every channel at `times`, or `fps` times a second (the film's, if nothing is said): array[time] by name, the
        times themselves as `time`. It is what `pandas.DataFrame` takes."""
        if times is None:
            rate = fps or self.job.fps
            count = max(1, int(np.ceil(self.duration * rate - 1e-9)))
            moments = np.arange(count) / rate
        else:
            moments = np.asarray(times, dtype=np.float64)
        values = self.job.performance.sample(moments)
        return {"time": moments, **dict(zip(self.channels, values.T, strict=True))}

    def explain(self) -> list[dict[str, object]]:
        """Who does what, from when until when, in time order, as `facescript explain --json` has it.

        >>> [(row["what"], row["start"]) for row in loads("nod\\nshow smile 40%\\n").explain()]
        [('nod', 0.0), ('show smile 40%', 0.7)]
        """
        return as_objects(explain(self.score))

    def save(self, path: str | Path, start: float = 0.0, end: float | None = None, at: float | None = None) -> Path:
        """Writes the file that its suffix chooses (`.svg`, `.mp4`, `.csv`, ...), from `start` to `end`, or the moment
        `at` as a still. Raises `ValueError` where that cannot be, `OSError` where it cannot be written."""
        target, known = Path(path), backends()
        backend = known.get(target.suffix)
        if backend is None:
            raise ValueError(f"`{target}` is of no kind that can be made: {', '.join(known)}")
        if at is not None and not backend.still:
            raise ValueError(f"only .png and .svg show one moment, not {target.suffix}")
        last = self.duration if end is None else end
        if not (0.0 <= start < last <= self.duration and (at is None or 0.0 <= at <= self.duration)):
            raise ValueError(f"the film is {self.duration:.3f} s long; nothing lies there")
        try:
            with outputs() as batch:
                backend.load()(replace(self.job, start=start, end=last, at=at), batch.place(target))
        except JobFailure as fault:
            raise ValueError(f"`{target}` could not be made: {fault.args[0]}") from None
        return target

    def svg(self, start: float = 0.0, end: float | None = None, at: float | None = None) -> str:
        """The animated picture with its sound, or the moment `at` as a still."""
        with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
            return self.save(Path(folder) / "take.svg", start, end, at).read_text("utf-8")

    def _repr_html_(self) -> str:
        """What a notebook shows: the film, playing in a frame of its own."""
        film = self.score.film
        width = min(film.width, 720)
        height = round(film.height * width / film.width)
        if self.duration <= DRAWN:
            data = base64.b64encode(self.svg().encode()).decode("ascii")
            source = f'src="data:image/svg+xml;base64,{data}"'
        else:
            source, height = f'srcdoc="{escape(self._page())}"', height + 260
        return f'<iframe {source} width="{width}" height="{height}" style="border:0" allow="autoplay"></iframe>'

    def _page(self) -> str:
        with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
            return self.save(Path(folder) / "take.html").read_text("utf-8")


def load(path: str | Path, values: Mapping[str, str] | None = None, seed: int | None = None) -> Take:
    """A take of a script of the disk, or of a play in JSON.

    `values` gives `let`s others, as text of the language (`{"degree": "40%"}`), `seed` another chance. Raises
    `ScriptFault`.
    """
    try:
        source, world = open_script(str(path))
    except WorldFailure as fault:
        raise ScriptFault([diagnose("FS901", None, name=str(path), reason=fault.args[0])]) from None
    return _take(source, world, values, seed)


def loads(
    text: str, folder: str | Path = ".", values: Mapping[str, str] | None = None, seed: int | None = None
) -> Take:
    """A take of a script's text; files that it names lie in `folder`. Raises `ScriptFault`."""
    return _take(Source("script.face", text), World(Path(folder)), values, seed)


def _take(source: Source, world: World, values: Mapping[str, str] | None, seed: int | None) -> Take:
    settings = Settings(values or {}, {} if seed is None else {"seed": seed})
    compiled = compile_any(source, world, open_studio(world), settings)
    told = tuple(compiled.diagnostics)
    if compiled.play is None or compiled.score is None:
        raise ScriptFault(told)
    return Take(Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration), told)
