"""What an output is made from: a performance, its picture and sound when asked for, and the stretch of time wanted."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from facescript.backends.page.wish import PageWish
from facescript.ir.acts import Say
from facescript.ir.play import Play
from facescript.motion.perform import perform
from facescript.performance.performance import Performance
from facescript.schedule.score import Score
from facescript.speech.sound.mix import Soundtrack, soundtrack

if TYPE_CHECKING:
    from facescript.canvas.overlay import Stickers
    from facescript.stage.stage import Stage

Progress = Callable[[int, int], None]
"""Called with (done, total) as frames are made."""

MOST_HANDS = 8
"""Processes that are started without being asked for, at most."""


class JobFailure(Exception):
    """An output that cannot be made; `args[0]` is a clause for the author."""


def quiet(done: int, total: int) -> None:
    """A progress that shows nothing."""


@dataclass(frozen=True)
class Job:
    """A film to be put out, seconds `start` to `end` of it, or the one moment `at`.

    `pictures` reads a background picture's bytes by its path in the project; `jobs` is how many processes draw, 0 for
    as many as suit the machine; `page` is what an `.html` is to be. `captions` is how they are made: by "words", by
    "sentences", or "burn" for sentences in the frames, then in a `font` (the bytes of its file, None to find one).
    `face` is whose face an output of one face is of, None for the only one.
    """

    play: Play
    score: Score
    pictures: Callable[[str], bytes]
    start: float
    end: float
    at: float | None = None
    jobs: int = 0
    progress: Progress = quiet
    page: PageWish = field(default_factory=PageWish)
    captions: str = "sentences"
    font: bytes | None = None
    face: str | None = None

    @cached_property
    def performance(self) -> Performance:
        return perform(self.score)

    @cached_property
    def stage(self) -> Stage:
        from facescript.stage.stage import Stage

        return Stage(self.score, self.performance, self.pictures, self._titles() if self.captions == "burn" else None)

    def _titles(self) -> Stickers:
        from facescript.backends.captions.titles import Titles

        return Titles(self.score, self.start, self.end if self.at is None else self.score.duration, self.font).at

    @cached_property
    def sound(self) -> Soundtrack:
        """The soundtrack of the whole film: mixed when and as far as it is asked for."""
        return soundtrack(self.score)

    def hands(self) -> int:
        """How many processes work at once: as asked for, or one a core of the machine."""
        cores = len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
        return self.jobs or min(cores, MOST_HANDS)

    @property
    def fps(self) -> float:
        return self.score.film.fps

    @property
    def heard(self) -> Soundtrack:
        """The soundtrack from `start` to `end`, exactly that long."""
        return self.sound.between(self.start, self.end)

    def spoken(self) -> list[tuple[str, str]]:
        """Who says what, in time order: (face, text)."""
        return [(act.face or "", act.verb.text) for act in self.score.acts if isinstance(act.verb, Say)]

    def times(self) -> NDArray[np.float64]:
        """The frames' moments: every 1/fps from `start`, up to but not at `end`; or the one moment `at`."""
        if self.at is not None:
            return np.array([self.at])
        count = max(1, int(np.ceil((self.end - self.start) * self.fps - 1e-9)))
        return self.start + np.arange(count) / self.fps
