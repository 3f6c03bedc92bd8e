"""The README's pictures, the manual's plots and the gallery, made by the program: `python docs/make_pictures.py`."""

from __future__ import annotations

import tempfile
from pathlib import Path

import imageio.v3 as iio
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from facescript.backends.job import Job
from facescript.backends.stills import write_png
from facescript.cli.main import main as run
from facescript.compile import compile_source
from facescript.resolve.kinds.library import kind_names
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

PLACE = Path(__file__).with_name("pictures")
PAGE = Path(__file__).with_name("gallery.md")
EXAMPLES = Path(__file__).parents[1] / "examples"
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


STRIP = (
    ("woman", "", "show happiness 80%", 14),
    ("dog", "", "show excitement 60%", -16),
    ("man", ", seed 8", "show surprise 70%", -12),
    ("woman", ", seed 5", "show inquisitive", -20),
    ("gorilla", "", "show happiness 60%", 12),
    ("woman", ", seed 7", "show smile 60%", 10),
    ("rodent", "", "show surprise 60%", -14),
    ("man", "", "show anger 80%", 10),
)
"""The strip of faces at the head of the README: kind, looks, what it shows, where it turns (deg)."""

STRIPPED = """\
film 440x440, screen none
face x{kind} = {kind}{looks}
    life still
target there at {yaw}deg 0deg 2m
scene a:
    look at camera, eyes only
    add head.yaw {yaw}deg over 1ms
    {what}
    wait 1s
"""

STRANGER = """\
film 440x440, screen none
face x{kind} = {kind}, seed {seed}
    life still
show smile 40%
wait 1s
"""

GALLERY = {
    "hello": 0.24,
    "evening": 1.5,
    "dialogue": 2.0,
    "conversation": 11.0,
    "crowd": 1.2,
    "kiosk": 8.0,
    "scenes": 5.4,
    "words": 1.5,
    "expressions": 5.0,
    "muscles": 1.4,
    "gestures": 2.6,
    "gaze": 1.0,
    "vergence": 2.4,
    "degrees": 3.0,
    "mandarin": 1.0,
    "recorded": 3.4,
    "alone": 1.11,
    "idle": 5.2,
    "track": 7.5,
    "cueing": 0.6,
    "timed": 2.8,
    "marks": 1.8,
    "monster": 0.9,
    "book": 12.3,
}
"""Examples in the order of the gallery, and the moment of each that it shows, s."""

HIGH = 264
"""How high the gallery's pictures are, px."""


def frame(script: str, time: float, folder: Path | None = None) -> NDArray[np.uint8]:
    """One moment of a script that stands in a folder."""
    world = World(folder or Path(tempfile.gettempdir()))
    compiled = compile_source(Source("picture.face", script), world, open_studio(world))
    assert compiled.play is not None, [item.message for item in compiled.diagnostics]
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    job = Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration, time)
    with tempfile.TemporaryDirectory() as place:
        write_png(job, Path(place) / "one.png")
        return np.asarray(iio.imread(Path(place) / "one.png"))[..., :3]


def lower(picture: NDArray[np.uint8], high: int) -> Image.Image:
    """The picture made smaller, to be `high` px."""
    image = Image.fromarray(picture)
    return image.resize((round(image.width * high / image.height), high), Image.Resampling.LANCZOS)


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
        ("woman", ", hair bob auburn, glasses round tortoise, clothes jumper forest", 38, 8),
        ("man", ", hair afro black, skin brown, beard full, clothes shirt mustard", -34, 12),
        ("woman", ", hair braids black, skin umber, earrings hoops, clothes tee plum, eyes dark", 20, -22),
        ("man", ", hair parted grey, age 80%, glasses square black, clothes jumper navy", 30, 18),
    )
    turned = [frame(LOOKS.format(kind=k, looks=how, yaw=y, pitch=p), 1.5) for k, how, y, p in looks]
    iio.imwrite(PLACE / "looks.png", grid([small(picture) for picture in turned], 4))
    faces = [frame(STRIPPED.format(kind=k, looks=how, what=what, yaw=y), 0.9) for k, how, what, y in STRIP]
    strangers = [frame(STRANGER.format(kind=("woman", "man")[seed % 2], seed=seed), 0.5) for seed in range(1, 13)]
    lower(grid([small(picture) for picture in strangers], 6), 420).save(PLACE / "strangers.png", optimize=True)
    lower(frame((EXAMPLES / "monster.face").read_text("utf-8"), 0.9, EXAMPLES), 400).save(
        PLACE / "monster.png", optimize=True
    )
    lower(grid([small(picture) for picture in faces], len(faces)), 220).save(PLACE / "faces.png", optimize=True)
    plots()
    gallery()


def plots() -> None:
    """The manual's plots."""
    for name, script, *words in PLOTS:
        picture = str(PLACE / f"plot-{name}.png")
        assert run(["plot", str(PLACE.parents[1] / "examples" / script), "-o", picture, *words]) == 0, name


def gallery() -> None:
    """The gallery's page and pictures, these in 256 colours each."""
    for name, time in GALLERY.items():
        shown = lower(frame((EXAMPLES / f"{name}.face").read_text("utf-8"), time, EXAMPLES), HIGH)
        few = shown.quantize(256, Image.Quantize.MEDIANCUT, kmeans=1)
        few.save(PLACE / f"gallery-{name}.png", optimize=True)
    PAGE.write_text(page(), "utf-8", newline="\n")


def page() -> str:
    """The gallery: a moment of each example under what its first line says it is, and the sheet of each kind."""
    shown = "\n".join(_shown(name, time) for name, time in GALLERY.items())
    sheets = "\n".join(
        f"### {kind}\n\n![The sheet of {kind}](../tests/sheet/golden/{kind}.png)\n" for kind in kind_names()
    )
    return f"{HEAD}\n{shown}\n{SHEETS}\n{sheets}"


HEAD = """\
# Gallery

A moment of each script in [`examples/`](../examples). `facescript build examples/hello.face -o hello.mp4` makes the
whole film, and with `-o hello.svg` a page for a browser. `make docs` makes this page and its pictures.
"""

SHEETS = """\
## The kinds of faces

All that each can show, as `facescript sheet KIND -o sheet.png` draws it: at rest, turned and speaking; every expression
of the library, every shape of the mouth, the turns of the head and the eyes, a blink and a wink.
"""


def _shown(name: str, time: float) -> str:
    where = f"[`{name}.face`](../examples/{name}.face) at {time:g} s"
    return f"## {name}\n\n{told(name)} {where}.\n\n![{name}.face](pictures/gallery-{name}.png)\n"


def told(name: str) -> str:
    """What the first line of an example says it is, as a sentence."""
    first = (EXAMPLES / f"{name}.face").read_text("utf-8").partition("\n")[0]
    says = first.removeprefix(f"# {name}.face: ")
    sentence = says[0].upper() + says[1:] if first.startswith("#") else f"The shortest script: `{first}`"
    return f"{sentence.removesuffix('.')}."


def small(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Three quarters of the middle, so that faces fill their cells."""
    height, width = picture.shape[:2]
    return picture[: height * 7 // 8, width // 16 : width * 15 // 16]


if __name__ == "__main__":
    main()
