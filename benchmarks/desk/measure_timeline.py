"""The preview's timeline of ten minutes with 2,000 acts in Chromium: its frames a second beside a blank page's.

The picture is not drawn meanwhile: what it costs is another row's business (measure_preview.py).
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from _frames import frame_rate
from row import Row

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "browser"))
sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "preview"))
from chromium import Page, program
from serving import Serving

BAR = 0.9
"""Of a blank page's frames."""

SECONDS = 4
ACTS, LONG = 2000, 600

PASS = """\
    ada: say "Number {number} is here for now, as it was before."
        on "here": nod 20%
    together:
        ada: look left for 400ms
        bruno: show smile 40% for 700ms
        ada: blink
        bruno: glance ada
        bruno: nod 30%
    together:
        bruno: add AU1 30% for 300ms
        ada: show frown {degree}% for 300ms
        bruno: look right for 300ms
        bruno: blink
        ada: tilt left for 400ms
"""

READY = f"""
window.facescript?.line.view.score?.acts.length >= {ACTS} && facescript.line.view.peaks.length > 0
  && facescript.picture.held >= Math.min(facescript.time.duration, {LONG}) - 2
"""
PATIENCE = 600
"""Seconds until all frames are drawn, so that nothing else is at work, at most."""

RATE = frame_rate(SECONDS)

ALWAYS = "window.on = true, (function again() {{ {what}; if (window.on) requestAnimationFrame(again); }})()"
LINE = "facescript.line.surface"

CASES = (
    ("playing, all in sight", "facescript.time.seek(1), facescript.time.play()", "facescript.time.pause()"),
    (
        "playing, near",
        f"facescript.time.seek(100), {LINE}.zoom(30), facescript.time.play()",
        "facescript.time.pause()",
    ),
    ("scrolling, near", ALWAYS.format(what=f"{LINE}.scroller.scrollLeft += 30"), "window.on = false"),
    (
        "scrolling up and down, all in sight",
        f"{LINE}.zoom(0), " + ALWAYS.format(what=f"{LINE}.scroller.scrollTop = performance.now() / 10 % 100"),
        "window.on = false",
    ),
)


def script() -> str:
    lines = ["film 160x90, 1fps", "face ada = woman", "face bruno = man, voice en-gb", "scene one:"]
    passes = (PASS.format(number=number, degree=20 + number % 60) for number in range(ACTS // 12 + 1))
    return "\n".join(lines) + "\n" + "".join(passes)


def rows() -> Iterator[Row]:
    if program() is None:
        yield Row("the timeline in Chromium", f"{BAR}", "no Chromium here", None)
        return
    with (
        tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder,
        Serving(Path(folder), script()) as serving,
        Page(serving.address, 1280, 800) as page,
        Page("data:text/html,<body>", 1280, 800) as blank,
    ):
        wait(page)
        page.run("facescript.picture.draw = () => true; 0")
        for what, begin, end in CASES:
            free = float(blank.run(RATE))
            page.run(f"{begin}; 0")
            ours = float(page.run(RATE))
            page.run(f"{end}; 0")
            found = f"{ours / free:.2f} ({ours:.0f} of {free:.0f})"
            yield Row(f"timeline of {ACTS} acts, {what}: frames a second", f"{BAR}", found, ours >= BAR * free)


def wait(page: Page) -> None:
    end = time.monotonic() + PATIENCE
    while not page.run(READY):
        assert time.monotonic() < end, "the frames do not come"
        time.sleep(1)
