"""A page in Chromium: it looks like our own frames, keeps to its sound, and does what its reader asks for."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import imageio.v3 as iio
import numpy as np
import pytest
from chromium import Page
from test_svg import tiles

from facescript.cli.main import main

EARLY, LATE = 0.015, 0.045
TRIES = 3

SCRIPT = """\
film 480x270, seed 2
face ada = woman
scene one:
    say "Where is my *cup*? | Here it is."
        on "cup": show surprise
"""
TEMPLATE = "<!DOCTYPE html><style>body{margin:0}.fs-begin{display:none}</style>{{face}}{{controls}}{{text}}"

DRAWN = """
new Promise(done => {
  const look = () => Math.abs(facescript.drawn - AT) < 1e-3 ? done(1) : requestAnimationFrame(look);
  look();
})
"""

AHEAD = """
new Promise(done => {
  const audio = document.querySelector("audio"), found = [];
  facescript.watch(() => audio.paused || audio.seeking || found.push(facescript.drawn - audio.currentTime));
  setTimeout(() => { facescript.pause(); done(found); }, 1200);
  facescript.seek(0.2); facescript.play();
})
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("page")
    (folder / "talk.face").write_text(SCRIPT, "utf-8")
    (folder / "mine.html").write_text(TEMPLATE, "utf-8")
    words = ["--page", str(folder / "mine.html"), "--split", "--quiet"]
    assert main(["build", str(folder / "talk.face"), "-o", str(folder / "talk.html"), *words]) == 0
    return folder


@pytest.fixture(scope="module")
def page(folder: Path) -> Iterator[Page]:
    with Page((folder / "talk.html").as_uri(), 480, 700) as page:
        shown(page, 0.0)
        yield page


def shown(page: Page, at: float) -> None:
    page.run(f"facescript.seek({at})")
    page.run(DRAWN.replace("AT", f"{at}"))


def press(page: Page, key: str) -> None:
    page.run(f"document.body.dispatchEvent(new KeyboardEvent('keydown', {{key: '{key}', bubbles: true}})); 0")


def test_looks_like_our_frames(page: Page, folder: Path) -> None:
    for moment in (0.43, 1.31):
        shown(page, moment)
        place = folder / "frame.png"
        words = ["build", str(folder / "talk.face"), "-o", str(place), "--at", f"{moment}s", "--quiet"]
        assert main(words) == 0
        ours = np.asarray(iio.imread(place))[..., :3].astype(np.int16)
        difference = np.abs(page.picture()[:270].astype(np.int16) - ours).mean(axis=2)
        assert difference.mean() < 2 and tiles(difference).max() <= 12, f"at {moment} s"


def in_step(page: Page) -> bool:
    """Whether picture and sound keep together; a machine that stalls for a moment may spoil that."""
    found = np.array(page.run(AHEAD))[3:]
    return len(found) > 3 and bool(found.max() <= EARLY and found.min() >= -LATE)


def test_keeps_to_its_sound(page: Page) -> None:
    assert any(in_step(page) for _ in range(TRIES))


def test_a_click_on_a_word_goes_there_and_lights_it(page: Page) -> None:
    number = page.run(
        "[...document.querySelectorAll('.fs-text .fs-word')].findIndex((each) => each.textContent === 'cup')"
    )
    page.run(f"document.querySelectorAll('.fs-text .fs-word')[{number}].click()")
    start = float(page.run(f"document.querySelectorAll('.fs-text .fs-word')[{number}].dataset.start"))
    page.run(DRAWN.replace("AT", f"{start + 0.001}"))
    assert page.run("facescript.time") == pytest.approx(start + 0.001)
    lit = "[...document.querySelectorAll('.fs-text .fs-word.now')].map((each) => each.textContent).join()"
    assert page.run(lit) == "cup"
    press(page, "c")
    shown(page, start + 0.01)
    assert "cup" in page.run("document.querySelector('.fs-caption').textContent")
    assert page.run("getComputedStyle(document.querySelector('.fs-caption')).display") == "block"
    press(page, "c")
    assert page.run("getComputedStyle(document.querySelector('.fs-caption')).display") == "none"


def test_keys(page: Page) -> None:
    shown(page, 0.5)
    press(page, "End")
    assert page.run("facescript.time") == pytest.approx(page.run("facescript.duration"))
    press(page, "ArrowLeft")
    assert page.run("facescript.time") == 0
    for key in ("+", "m", " "):
        press(page, key)
    page.run("new Promise(done => setTimeout(done, 200))")
    assert page.run("(a => [a.playbackRate, a.muted, a.paused])(document.querySelector('audio'))") == [
        1.25,
        True,
        False,
    ]
    for key in ("-", "m", " "):
        press(page, key)
    page.run("new Promise(done => setTimeout(done, 100))")
    assert page.run("(a => [a.playbackRate, a.muted, a.paused])(document.querySelector('audio'))") == [1, False, True]


def test_a_screen_reader_finds_its_way(page: Page) -> None:
    page.call("Accessibility.enable")
    nodes = page.call("Accessibility.getFullAXTree")["nodes"]
    found = {(node["role"]["value"], node.get("name", {}).get("value")) for node in nodes if not node.get("ignored")}
    assert {("slider", "Time"), ("button", "Play"), ("image", "Talk"), ("button", "Captions")} <= found
    assert all(name for role, name in found if role in ("button", "slider", "combobox", "image", "region"))


def test_waits_for_its_reader(folder: Path) -> None:
    """Nothing plays by itself, and the face is there before any script."""
    with Page("about:blank#", 480, 640) as page:
        page.call("Emulation.setScriptExecutionDisabled", value=True)
        page.call("Page.navigate", url=(folder / "talk.html").as_uri())
        time.sleep(0.4)
        assert np.ptp(page.picture()[60:220, 160:320]) > 100
        page.call("Emulation.setScriptExecutionDisabled", value=False)
        page.call("Page.navigate", url=(folder / "talk.html").as_uri() + "?")
        time.sleep(0.4)
        assert page.run("document.querySelector('audio').paused")
