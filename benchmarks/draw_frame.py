"""The processor time of a 1080p frame: sampling, geometry and drawing, 300 in a row of a minute of speech with life."""

from __future__ import annotations

import statistics
import time

from _measure import job_of, row
from _scripts import talk

from facescript.backends.frames import drawn
from facescript.canvas.painter import Painter
from facescript.speech.voicebox import open_voice
from facescript.stage.backcloth import Backcloth

FIRST, COUNT = 300, 300
BAR = 16.0


def main() -> None:
    job = job_of(talk(60), open_voice())
    stage, times = job.stage, job.times()[FIRST : FIRST + COUNT]
    painter = Painter(stage.width, stage.height, stage.shapes)
    cloth = Backcloth(stage.width, stage.height, stage.pictures)
    figures = []
    for _ in range(3):
        start = time.process_time()
        for _ in drawn(stage, painter, cloth, times):
            pass
        figures.append((time.process_time() - start) / COUNT * 1000)
    mean = statistics.median(figures)
    row("a 1080p frame, sampled and drawn, 300 in a row", f"{mean:.1f} ms", f"{BAR:g} ms", mean <= BAR)


if __name__ == "__main__":
    main()
