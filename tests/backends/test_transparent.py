"""Outputs over a ground of nothing: laid over green, each looks as if it had been drawn there."""

from __future__ import annotations

import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image, ImageSequence
from test_film import job_of

from facescript.backends.encoder import program
from facescript.backends.film import write_gif, write_mp4, write_webm
from facescript.backends.frames import CHUNK, film_planes, pictures, planes
from facescript.backends.job import Job
from facescript.backends.stills import write_png, write_pngs

SCRIPT = """\
film 240x160, 10fps, seed 3
background none
face ada = woman
    hair #2a1a10
look left 20deg over 300ms
look right 20deg over 300ms
wait 400ms
"""
GREEN = (0, 255, 0)


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Job:
    return job_of(SCRIPT, tmp_path_factory.mktemp("project"), 1.0)


@pytest.fixture(scope="module")
def on_green(job: Job) -> NDArray[np.float64]:
    """The frames drawn before green: array[frame, y, x, rgb]."""
    green = job_of(SCRIPT.replace("none", "#00ff00"), Path())
    return np.stack([frame[..., 2::-1].astype(float) for frame in pictures(green.stage, job.times())])


@pytest.fixture(scope="module")
def alpha(job: Job) -> NDArray[np.float64]:
    """array[frame, y, x], 0..255."""
    return np.stack([frame[..., 3].astype(float) for frame in pictures(job.stage, job.times())])


def laid(rgba: NDArray[np.uint8], ground: tuple[int, int, int] = GREEN) -> NDArray[np.float64]:
    """A straight picture over a colour, as programs that cut films do it."""
    share = rgba[..., 3:].astype(float) / 255
    return rgba[..., :3] * share + np.array(ground) * (1 - share)


def decoded(path: Path, size: tuple[int, int]) -> NDArray[np.uint8]:
    words = [program(), "-loglevel", "error", "-c:v", "libvpx-vp9", "-i", str(path), "-f", "rawvideo"]
    data = subprocess.run([*words, "-pix_fmt", "rgba", "-"], capture_output=True, check=True).stdout
    return np.frombuffer(data, np.uint8).reshape(-1, size[1], size[0], 4)


def test_a_png_laid_over_green_is_the_picture_drawn_there(
    job: Job, on_green: NDArray[np.float64], tmp_path: Path
) -> None:
    paths = [tmp_path / f"{number}.png" for number in range(10)]
    write_pngs(job, paths)
    for path, drawn in zip(paths, on_green, strict=True):
        with Image.open(path) as picture:
            assert picture.mode == "RGBA"
            rgba = np.asarray(picture)
        partly = (rgba[..., 3] > 0) & (rgba[..., 3] < 255)
        assert partly.sum() > 100
        assert np.abs(laid(rgba) - drawn).max() <= 6
        assert np.abs(laid(rgba) - drawn).mean() < 0.1
        assert (laid(rgba) - drawn)[partly].mean() == pytest.approx(0.0, abs=0.6), "no dark or light fringe"


def test_a_png_is_without_opacity_where_no_ground_is_clear(job: Job, tmp_path: Path) -> None:
    write_png(replace(job, at=0.0), tmp_path / "clear.png")
    write_png(replace(job_of(SCRIPT.replace("none", "#00ff00"), Path()), at=0.0), tmp_path / "green.png")
    assert [Image.open(tmp_path / name).mode for name in ("clear.png", "green.png")] == ["RGBA", "RGB"]


def test_a_webm_laid_over_green_is_the_film_drawn_there(
    job: Job, on_green: NDArray[np.float64], alpha: NDArray[np.float64], tmp_path: Path
) -> None:
    write_webm(job, tmp_path / "film.webm")
    film = decoded(tmp_path / "film.webm", (240, 160))
    assert len(film) == len(on_green)
    difference = laid(film) - on_green
    assert np.abs(difference).mean() < 2.5
    assert np.abs(film[..., 3] - alpha).mean() < 0.5
    edge = (alpha > 20) & (alpha < 235)
    assert np.abs(difference[edge].mean(axis=0)).max() < 4, "no dark or light fringe"


def test_a_webm_of_odd_sides_and_several_processes(tmp_path: Path) -> None:
    odd = job_of(SCRIPT.replace("240x160, 10fps", "97x54, 40fps"), Path(), 1.0)
    alone = [frame.tobytes() for frame in planes(odd.stage, odd.times(), True)]
    assert len(alone) > 2 * CHUNK
    with film_planes(odd.stage, odd.times(), 3, True) as frames:
        assert [frame.tobytes() for frame in frames] == alone
    write_webm(replace(odd, jobs=2), tmp_path / "film.webm")
    assert decoded(tmp_path / "film.webm", (98, 54))[..., 3].min() < 8


def test_a_gif_is_clear_where_less_than_half_is_seen(
    job: Job, on_green: NDArray[np.float64], alpha: NDArray[np.float64], tmp_path: Path
) -> None:
    write_pngs(job, [tmp_path / f"{number}.png" for number in range(10)])
    whole = np.stack([np.asarray(Image.open(tmp_path / f"{number}.png"))[..., :3] for number in range(10)])
    write_gif(job, tmp_path / "film.gif")
    with Image.open(tmp_path / "film.gif") as picture:
        frames = np.stack([np.asarray(frame.convert("RGBA")) for frame in ImageSequence.Iterator(picture)])
    assert len(frames) == len(alpha), "nothing of a frame stays behind the next"
    assert ((frames[..., 3] == 255) != (alpha >= 128)).mean() < 1e-4
    assert set(np.unique(frames[..., 3])) == {0, 255}
    assert np.abs(laid(frames) - on_green)[alpha == 255].mean() < 5
    edge = (alpha >= 128) & (alpha < 255) & (frames[..., 3] == 255)
    assert np.abs((frames[..., :3] - whole.astype(float))[edge].mean(axis=0)).max() < 5, "no dark or light fringe"


def test_an_mp4_has_white_where_nothing_is(job: Job, tmp_path: Path) -> None:
    write_mp4(job, tmp_path / "film.mp4")
    words = [program(), "-loglevel", "error", "-i", str(tmp_path / "film.mp4"), "-frames:v", "1", "-f", "rawvideo"]
    data = subprocess.run([*words, "-pix_fmt", "rgb24", "-"], capture_output=True, check=True).stdout
    first = np.frombuffer(data, np.uint8).reshape(160, 240, 3)
    assert first[5, 5].min() > 250


def test_the_same_job_gives_the_same_bytes(job: Job, tmp_path: Path) -> None:
    for write in (write_webm, write_gif):
        write(job, tmp_path / "one")
        write(job, tmp_path / "two")
        assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()
