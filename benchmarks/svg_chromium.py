"""A minute's SVG in Chromium at 1280x720: how soon it is there, and its frames a second beside a blank page's."""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from pathlib import Path

from _frames import frame_rate
from _measure import job_of, row
from _scripts import talk

from facescript.backends.svg.document import write_svg
from facescript.speech.espeak.voicebox import open_voice

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "browser"))
from chromium import Page, program

RUNS = 3
"""Pairs; the middle one counts."""
SECONDS = 6
BLANK = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1280 720'/>"

RATE = frame_rate(SECONDS)
DRAWN = "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"


def main() -> None:
    if program() is None:
        print("| a minute's SVG in Chromium | no Chromium here | 0.9 of a blank page | not run |")
        return
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        path = Path(folder) / "minute.svg"
        write_svg(job_of(talk(60, size="1280x720"), open_voice()), path, sound=False)
        opened, pairs = [], []
        for _ in range(RUNS):
            blank = looked_at(BLANK)[1]
            seconds, ours = looked_at(path.as_uri())
            opened.append(seconds)
            pairs.append((ours / blank, ours, blank))
    share, ours, blank = sorted(pairs)[RUNS // 2]
    row(
        "that SVG in Chromium", f"{share:.2f} ({ours:.0f} of {blank:.0f} frames/s)", "0.9 of a blank page", share >= 0.9
    )
    seconds = statistics.median(opened)
    row("that SVG opens in Chromium", f"{seconds * 1000:.0f} ms", "500 ms", seconds <= 0.5)


def looked_at(address: str) -> tuple[float, float]:
    """Seconds from asking for a page to its second frame, and its frames a second."""
    with Page("about:blank#", 1280, 720) as page:
        start = time.perf_counter()
        page.call("Page.navigate", url=address)
        while not page.run("document.readyState === 'complete' && !location.href.startsWith('about:')"):
            time.sleep(0.005)
        page.run(DRAWN)
        seconds = time.perf_counter() - start
        return seconds, float(page.run(RATE))


if __name__ == "__main__":
    main()
