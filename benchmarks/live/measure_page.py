"""The page of a run in Chromium: from a touch to the first sound of its answer, mouths beside sounds, frames."""

from __future__ import annotations

import os
import re
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median

from _frames import frame_rate
from _running import Running
from row import Row

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "browser"))
from chromium import Page, program

TOUCHES = 10
SECONDS = 60.0

SOONEST, TOGETHER, LARGEST = 150.0, 40.0, 20.0
"""Bars: ms from a touch to the first sound of its answer, ms between a sound and its mouth, kB of a frame."""

SCRIPT = """\
film 360x640, seed 5
face mia = woman, voice en-us female
    life calm
scene attract:
    repeat forever:
        wait 2s
""" + "".join(f'when touched "{number}":\n    say "Hello, this is answer {number}."\n' for number in range(TOUCHES))

READY = """
new Promise(done => {
  const look = () => facescript.picture.frames.length > 5 ? done(1) : setTimeout(look, 50);
  look();
})
"""

TOUCHED = """
new Promise(done => {
  const { sound, time } = facescript, begun = performance.now();
  let line, off = 0;
  document.querySelectorAll("#touch button")[NUMBER].click();
  const look = () => {
    const now = performance.now();
    line ??= sound.lines.find((each) => each.heard > begun);
    const apart = line && 1000 * (time.now() - line.start - line.into) - (now - line.heard);
    if (line && now > line.heard) off = Math.max(off, Math.abs(apart));
    if (line && now > line.heard + 1000) done([line.heard - begun, off, 1000 * line.into]);
    else setTimeout(look, 5);
  };
  look();
})
"""


def rows() -> Iterator[Row]:
    if program() is None:
        yield Row("the page of a run", "", "no Chromium here", None)
        return
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        script = Path(folder) / "answers.face"
        script.write_text(SCRIPT, "utf-8")
        with Running(SECONDS, "--page", "0", script=script) as run:
            address = re.search(r"http://\S+/", run.wait("is shown at"))
            assert address is not None
            with Page(address[0], 360, 640) as page:
                page.run(READY)
                time.sleep(2.0)
                yield from _answers(page)
                yield from _frames(page)


def _answers(page: Page) -> Iterator[Row]:
    found = []
    for number in range(TOUCHES):
        found.append(page.run(TOUCHED.replace("NUMBER", str(number))))
        time.sleep(2.0)
    sooner, apart, left = (sorted(column) for column in zip(*found, strict=True))
    told = f"median {median(sooner):.0f} ms, most {sooner[-1]:.0f} ms, of a line {left[-1]:.0f} ms left out at most"
    load = f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores"
    what = f"{TOUCHES} touches to the first sound that is heard"
    yield Row(what, f"{SOONEST:.0f} ms", f"{told}; {load}", sooner[-1] <= SOONEST)
    yield Row("a mouth beside its sound", f"{TOGETHER:.0f} ms", f"{apart[-1]:.0f} ms", apart[-1] <= TOGETHER)


def _frames(page: Page) -> Iterator[Row]:
    size = (
        page.run("2 * (facescript.picture.frames[0].steps.length + 2 * facescript.picture.film.shapes.length)") / 1000
    )
    yield Row("a frame of one face to a page", f"{LARGEST:.0f} kB", f"{size:.1f} kB", size <= LARGEST)
    rate = page.run(frame_rate(5))
    yield Row("the page's own frames a second", "", f"{rate:.0f}", None)
