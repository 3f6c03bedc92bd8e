"""The README's pictures and the manual's plots, made by the program: `python docs/make_pictures.py` writes them."""

from __future__ import annotations

import tempfile
from pathlib import Path

import imageio.v3 as iio
import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.stills import write_png
from facescript.cli.main import main as run
from facescript.compile import compile_source
from facescript.speech.voicebox import open_voice
from facescript.text import Source
from facescript.world import World

PLACE = Path(__file__).with_name("pictures")
FEELINGS = ("happiness", "sadness", "surprise", "fear", "anger", "disgust", "excitement", "inquisitive")

SPEAKING = """\
film 1280x640, seed 4
face ada = woman, voice en-us female, at -25% 0%
face bruno = man, voice en-gb, at 25% 0%
scene talk:
    together:
        ada: look at bruno
        bruno: look at ada
    together:
        ada: say "[smile 60%]Good evening, everyone. I have lost my cup."
        bruno: show inquisitive 70%
"""

PLOTS = (
    ("gaze", "gaze.face", "--to", "3.3s"),
    ("dialogue", "dialogue.face", "--to", "2.45s", "--size", "1200x1280"),
    ("life", "idle.face", "--to", "9s"),
)
"""Plots of examples that the manual shows: `plot-NAME.png`, the script, and how it is cut."""

FEELING = "film 480x480\nface x{kind} = {kind}\n    life still\nscene a:\n    show {what}\n    wait 1s\n"

LOOKS = """\
film 480x480, screen none
face x{kind} = {kind}{looks}
    life still
target there at {yaw}deg {pitch}deg 2m
scene a:
    look at there
    wait 1s
"""


def frame(script: str, time: float) -> NDArray[np.uint8]:
    """One moment of a script."""
    world = World(Path(tempfile.gettempdir()))
    compiled = compile_source(Source("picture.face", script), world, open_voice())
    assert compiled.play is not None, [item.message for item in compiled.diagnostics]
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    job = Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration, time)
    with tempfile.TemporaryDirectory() as folder:
        write_png(job, Path(folder) / "one.png")
        return np.asarray(iio.imread(Path(folder) / "one.png"))[..., :3]


def grid(frames: list[NDArray[np.uint8]], columns: int) -> NDArray[np.uint8]:
    rows = [np.concatenate(frames[at : at + columns], axis=1) for at in range(0, len(frames), columns)]
    return np.concatenate(rows, axis=0)


def main() -> None:
    PLACE.mkdir(exist_ok=True)
    iio.imwrite(PLACE / "dialogue.png", frame(SPEAKING, 1.62))
    kinds = ("woman", "man")
    shown = [frame(FEELING.format(kind=kinds[number % 2], what=what), 1.0) for number, what in enumerate(FEELINGS)]
    iio.imwrite(PLACE / "expressions.png", grid([small(picture) for picture in shown], 4))
    looks = (
        ("woman", "", 38, 8),
        ("man", ", hair #8a8f98, skin #6f4a35, clothes #7a3b2e", -34, 12),
        ("woman", ", hair #e0b35c, eyes #4f7fb5, clothes #5b3a6e", 20, -22),
        ("man", ", hair #c65f2a, skin #f3cdb0, clothes #2f5d4a", 30, 18),
    )
    turned = [frame(LOOKS.format(kind=k, looks=how, yaw=y, pitch=p), 1.5) for k, how, y, p in looks]
    iio.imwrite(PLACE / "looks.png", grid([small(picture) for picture in turned], 4))
    plots()


def plots() -> None:
    """The manual's plots."""
    for name, script, *words in PLOTS:
        picture = str(PLACE / f"plot-{name}.png")
        assert run(["plot", str(PLACE.parents[1] / "examples" / script), "-o", picture, *words]) == 0, name


def small(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Three quarters of the middle, so that faces fill their cells."""
    height, width = picture.shape[:2]
    return picture[: height * 7 // 8, width // 16 : width * 15 // 16]


if __name__ == "__main__":
    main()
