"""The processor time of a 1080p frame: sampling, geometry and drawing, 300 in a row of a minute of speech with life."""

from __future__ import annotations

import statistics
import time

from _measure import job_of, row
from _scripts import talk

from facescript.backends.frames import drawn
from facescript.backends.job import Job
from facescript.canvas.painter import Painter
from facescript.resolve.kinds.library import kind_names
from facescript.speech.espeak.voicebox import open_voice
from facescript.stage.backcloth import Backcloth

FIRST, COUNT = 300, 300
BAR = 16.0
DRESSED = "woman, hair curls, clothes blazer, glasses square, earrings hoops, age 60%, make-up 60%, freckles 60%"
"""A face with all that it can wear."""


def main() -> None:
    for face in (*kind_names(), DRESSED):
        figure = milliseconds(job_of(talk(60, face=face), open_voice()))
        called = face if face != DRESSED else "woman with all she can wear"
        row(
            f"a 1080p frame of a {called}, sampled and drawn",
            f"{figure:.1f} ms",
            f"{BAR:g} ms",
            figure <= BAR,
        )


def milliseconds(job: Job) -> float:
    """The processor time of a frame, the middle one of three runs."""
    stage, times = job.stage, job.times()[FIRST : FIRST + COUNT]
    painter = Painter(stage.width, stage.height, stage.shapes)
    cloth = Backcloth(stage.width, stage.height, stage.pictures)
    figures = []
    for _ in range(3):
        start = time.process_time()
        for _ in drawn(stage, painter, cloth, times):
            pass
        figures.append((time.process_time() - start) / COUNT * 1000)
    return statistics.median(figures)


if __name__ == "__main__":
    main()
