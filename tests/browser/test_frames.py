"""The rasteriser's frames beside Chromium's of the animated SVG of the same script, at fifty random moments."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from chromium import Page
from numpy.typing import NDArray

from facescript.backends.frames import pictures
from facescript.backends.job import Job
from facescript.backends.svg.document import write_svg
from facescript.compile import compile_source
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

EXAMPLES = Path(__file__).parents[2] / "examples"
MOMENTS = 10
SECONDS = 1.0
SEED = 4
TILE = 32
MEAN, WORST = 2.0, 12.0
"""Of 255: the most that a face's box may be off in the mean, and a tile of the picture."""

BOXES = (
    "[...document.querySelectorAll('.figure')].map(g => g.getBoundingClientRect())"
    ".map(b => [b.left, b.top, b.right, b.bottom])"
)


@dataclass(frozen=True)
class Shot:
    """A stretch of an example, of SECONDS from `start`; its faces are of a `kind` where one is given."""

    name: str
    start: float
    kind: str | None = None

    def job(self) -> Job:
        text = (EXAMPLES / f"{self.name}.face").read_text("utf-8").replace("film 720x720", "film 1280x720")
        if self.kind:
            text = re.sub(r"= (woman|man)\b", f"= {self.kind}", text)
        world = World(EXAMPLES)
        compiled = compile_source(Source(f"{self.name}.face", text), world, EstimatedVoice())
        assert compiled.play is not None and compiled.score is not None
        assert compiled.score.film.width == 1280
        return Job(compiled.play, compiled.score, world.read, self.start, self.start + SECONDS)


SHOTS = (
    Shot("evening", 0.0),
    Shot("expressions", 4.0),
    Shot("gestures", 1.4, "dog"),
    Shot("idle", 2.0, "gorilla"),
    Shot("monster", 1.0),
)


def tiles(difference: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean of every TILE x TILE square, those at the picture's edge as much of them as there is."""
    rows, columns = (range(0, side, TILE) for side in difference.shape)
    return np.array([[difference[y : y + TILE, x : x + TILE].mean() for x in columns] for y in rows])


@pytest.mark.parametrize("number", range(len(SHOTS)), ids=[shot.name for shot in SHOTS])
def test_chromium_shows_the_rasterisers_frames(number: int, tmp_path: Path) -> None:
    job = SHOTS[number].job()
    write_svg(replace(job), tmp_path / "film.svg", sound=False)
    moments = np.sort(np.random.default_rng([SEED, number]).uniform(0, SECONDS, MOMENTS)).round(3)
    off: list[tuple[float, float, str]] = []
    with Page((tmp_path / "film.svg").as_uri()) as page:
        page.run("document.documentElement.pauseAnimations()")
        for moment, frame in zip(moments, pictures(job.stage, job.start + moments), strict=True):
            page.run(f"document.documentElement.setCurrentTime({moment:.3f})")
            difference = np.abs(page.picture() - frame[..., 2::-1].astype(np.float64)).mean(axis=2)
            mean = max(box.mean() for box in boxed(difference, page.run(BOXES)) if box.size)
            off.append((mean, tiles(difference).max(), f"{moment:.3f} s"))
    told = [f"{label} {value:.2f} at {at}" for label, value, at in worst(off)]
    print(f"{SHOTS[number].name}: {', '.join(told)}")
    assert all(mean < MEAN and tile <= WORST for mean, tile, _ in off), told


def worst(off: list[tuple[float, float, str]]) -> list[tuple[str, float, str]]:
    """The worst mean and the worst tile of all moments, and when they are."""
    mean, tile = (max(off, key=lambda each: each[column]) for column in (0, 1))
    return [("mean", mean[0], mean[2]), ("tile", tile[1], tile[2])]


def boxed(difference: NDArray[np.float64], boxes: list[list[float]]) -> list[NDArray[np.float64]]:
    """The parts of a picture inside boxes left, top, right, bottom."""
    return [
        difference[max(0, int(top)) : max(0, int(bottom)), max(0, int(left)) : max(0, int(right))]
        for left, top, right, bottom in boxes
    ]
