"""Time and memory of the schedule and the motion of an hour of two faces with life, and whether they grow in step."""

from __future__ import annotations

import resource
import subprocess
import sys
import time

import numpy as np
from _measure import job_of, row

from facescript.performance.performance import Performance
from facescript.speech.espeak.voicebox import open_voice

HOUR, QUARTER = 3600, 900
FRAMES, CHUNK = 60, 60

HEAD = """\
film 1280x720, 30fps, {seconds}s long, seed 3
face ada = woman, voice en-us female
    life conversation
face bruno = man, voice en-gb
    life conversation
target cup at 20cm -10cm 60cm
target walker moves
{keys}
scene talk:
"""

TURN = """\
    together:
        ada: look at bruno
        bruno: look at ada
    ada: say "Item {number}: good evening, and welcome to the programme. | Tonight we look at bridges and boats."
        on "bridges": glance cup
    bruno: take-turn ada, words "Some, {number} of them, have worked by the river. | Others came last spring."
    together:
        ada: nod
        bruno: show smile 60% for 2s
    ada: look at walker for 3s
    ada: look at cup
    wait 4s
"""


def script(seconds: int) -> str:
    """Two faces that talk, nod, smile and follow somebody, in turns of about 20 s."""
    keys = "\n".join(f"    {at}s {80 if at % 40 else -80}cm 0cm 2m" for at in range(0, seconds + 1, 20))
    turns = "".join(TURN.format(number=number) for number in range(1, seconds // 20 + 2))
    return HEAD.format(seconds=seconds, keys=keys) + turns


def performed(seconds: int) -> None:
    """Print the seconds that it takes to schedule and sample so many of the film, and the peak memory in MB."""
    start = time.process_time()
    performance = job_of(script(seconds), open_voice()).performance
    _sample(performance)
    print(time.process_time() - start, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)


def _sample(performance: Performance) -> None:
    """Every channel at 60 frames a second, a minute at a time, as a film is drawn."""
    for begin in np.arange(0.0, performance.duration, CHUNK):
        performance.sample(np.arange(begin, min(begin + CHUNK, performance.duration), 1 / FRAMES))


def measured(seconds: int) -> tuple[float, float]:
    words = [sys.executable, __file__, str(seconds)]
    done = subprocess.run(words, check=True, capture_output=True, text=True)
    took, megabytes = done.stdout.split()
    return float(took), float(megabytes)


def main() -> None:
    quarter, hour = measured(QUARTER), measured(HOUR)
    row("schedule and motion of an hour of two faces", f"{hour[0]:.1f} s", "20 s", hour[0] <= 20)
    row("its memory", f"{hour[1]:.0f} MB", "600 MB", hour[1] <= 600)
    times, sizes = hour[0] / quarter[0], hour[1] / quarter[1]
    row("four times as much takes", f"{times:.1f} times the time, {sizes:.1f} the memory", "4.6", times <= 4.6)


if __name__ == "__main__":
    performed(int(sys.argv[1])) if len(sys.argv) > 1 else main()
