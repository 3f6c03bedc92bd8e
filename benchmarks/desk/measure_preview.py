"""`facescript preview` of a minute in Chromium: from a save to the new picture at the playhead, and its frames a second
beside a blank page's.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from _frames import frame_rate
from _scripts import talk
from row import Row

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "browser"))
sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "preview"))
from chromium import Page, program
from serving import Serving

SAVES = 16
BAR = 400
"""ms from a save to the picture."""

SECONDS = 5
PLAYED = 0.9

PLAYHEADS = (3.2, 21.7, 40.1, 58.8)

SHOWN = """
new Promise(done => {
  const face = document.getElementById("face");
  const look = () => Number(face.dataset.version) >= VERSION ? done(1) : requestAnimationFrame(look);
  look();
})
"""

COMPLETE = """
new Promise(done => {
  const look = () => facescript.picture.held >= 60 ? done(1) : setTimeout(look, 50);
  look();
})
"""

RATE = frame_rate(SECONDS)


def rows() -> Iterator[Row]:
    if program() is None:
        yield Row("the preview in Chromium", f"{BAR} ms", "no Chromium here", None)
        return
    script = talk(60, size="1280x720")
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder, Serving(Path(folder), script) as serving:
        begun = time.perf_counter()
        with Page(serving.address, 1280, 900) as page:
            page.run(SHOWN.replace("VERSION", "1"))
            opened = time.perf_counter() - begun
            yield Row("preview of a minute: from its start to the first picture", "", f"{opened:.1f} s", None)
            page.run(COMPLETE)
            yield from _saves(serving, page, script)
            page.run(COMPLETE)
            yield _rate(page, "once all frames are there")
            serving.script.write_text(script.replace("30%", "90%"), "utf-8")
            yield _rate(page, "while frames are drawn anew")


def _saves(serving: Serving, page: Page, script: str) -> Iterator[Row]:
    """Saves that change something at every line, the next one when the last is done with, and while it is under way."""
    for what, pause, bar in (("", 1.5, BAR), (", frames still under way", 0.25, None)):
        took = []
        for number in range(SAVES):
            page.run(f"facescript.time.seek({PLAYHEADS[number % len(PLAYHEADS)]}); 0")
            time.sleep(pause)
            version = int(page.run("facescript.picture.version"))
            text = script.replace("30%", f"{40 + number + (20 if bar else 0)}%")
            begun = time.perf_counter()
            serving.script.write_text(text, "utf-8")
            page.run(SHOWN.replace("VERSION", str(version + 1)))
            took.append((time.perf_counter() - begun) * 1000)
        took.sort()
        found = f"{took[len(took) // 2]:.0f} ms in the median, {took[-1]:.0f} ms at most"
        yield Row(
            f"preview of a minute: a save to the new picture{what}",
            f"{bar} ms" if bar else "",
            found,
            took[-1] <= bar if bar else None,
        )


def _rate(page: Page, when: str) -> Row:
    """Frames a second, played at its full size beside a blank page."""
    with Page("data:text/html,<body>", 1280, 900) as blank:
        free = float(blank.run(RATE))
    page.run("facescript.time.seek(1); facescript.time.play(); 0")
    ours = float(page.run(RATE))
    page.run("facescript.time.pause(); 0")
    found = f"{ours / free:.2f} ({ours:.0f} of {free:.0f})"
    return Row(f"preview playing, {when}: frames a second", f"{PLAYED} of a blank page", found, ours >= PLAYED * free)
