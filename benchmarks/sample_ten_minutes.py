"""How long it takes to sample a ten-minute performance at 60 frames a second."""

from __future__ import annotations

import statistics
import time

import numpy as np
from _measure import job_of, row
from _scripts import talk

from facescript.speech.espeak.voicebox import open_voice


def main() -> None:
    performance = job_of(talk(600), open_voice()).performance
    times = np.arange(600 * 60) / 60
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        performance.sample(times)
        seconds.append(time.perf_counter() - start)
    median = statistics.median(seconds)
    row("`sample` of ten minutes at 60 fps", f"{median:.2f} s", "2 s", median <= 2)


if __name__ == "__main__":
    main()
