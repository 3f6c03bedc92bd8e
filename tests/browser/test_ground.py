"""Grounds in a real browser: SVG and WebM over a green page look like our own frames over green."""

from __future__ import annotations

from pathlib import Path

import imageio.v3 as iio
import numpy as np
import pytest
from chromium import Page
from numpy.typing import NDArray
from PIL import Image

from facescript.cli.main import main

SCRIPT = """\
film 320x180, 10fps, seed 3
background #102040 to #c06040 to #f0d080, towards 45deg
face ada = woman
    life still
wait 400ms
background none over 400ms
wait 400ms
background "logo.png" over 400ms
background #ffe0c0 to #304060, round over 400ms
background #204060 over 400ms
background none over 400ms
wait 400ms
"""
SIZE = (320, 180)

SEEN = """
new Promise(done => {
  const film = document.querySelector("video");
  film.onseeked = () => done(film.videoWidth);
  film.currentTime = TIME;
})
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("ground")
    logo = Image.new("RGBA", (64, 64), (0, 0, 0, 0))
    logo.paste((200, 30, 30, 255), (16, 16, 48, 48))
    logo.save(folder / "logo.png")
    (folder / "film.face").write_text(SCRIPT, "utf-8")
    for name in ("film.svg", "film.webm"):
        assert main(["build", str(folder / "film.face"), "-o", str(folder / name), "--quiet"]) == 0
    assert main(["build", str(folder / "film.face"), "-o", str(folder / "%02d.png"), "--quiet"]) == 0
    return folder


def ours(folder: Path, number: int) -> NDArray[np.float64]:
    """A frame of ours over green."""
    rgba = np.asarray(iio.imread(folder / f"{number + 1:02d}.png")).astype(float)
    share = rgba[..., 3:] / 255
    return rgba[..., :3] * share + np.array([0, 255, 0]) * (1 - share)


def page(folder: Path, element: str) -> Page:
    (folder / "page.html").write_text(f'<body style="margin:0;background:#00ff00">{element}</body>', "utf-8")
    return Page((folder / "page.html").as_uri(), *SIZE)


def test_an_svg_over_green_is_our_frame_over_green(folder: Path) -> None:
    drawing = (folder / "film.svg").read_text("utf-8").partition("?>")[2]
    with page(folder, drawing) as shown:
        shown.run("document.querySelector('svg').pauseAnimations()")
        for number in range(0, 31, 2):
            shown.run(f"document.querySelector('svg').setCurrentTime({number / 10})")
            shown.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
            difference = np.abs(shown.picture() - ours(folder, number))
            assert difference.mean() < 2, f"at {number / 10} s"


def test_a_webm_over_green_is_our_frame_over_green(folder: Path) -> None:
    with page(folder, f'<video src="film.webm" muted style="display:block" width="{SIZE[0]}"></video>') as shown:
        for number in (2, 9, 16, 22, 30):
            assert shown.run(SEEN.replace("TIME", f"{number / 10 + 0.05}")) == SIZE[0]
            shown.run("new Promise(done => setTimeout(done, 150))")
            difference = shown.picture() - ours(folder, number)
            assert np.abs(difference).mean() < 6, f"at {number / 10} s"
            clear = (ours(folder, number) == (0, 255, 0)).all(axis=2)
            if clear.any():
                assert np.abs(difference[clear]).mean() < 2, "the page shows where nothing is"
