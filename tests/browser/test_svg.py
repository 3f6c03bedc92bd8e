"""The animated SVG in a real browser: it looks like our own frames, keeps to its sound, and starts at a click."""

from __future__ import annotations

import time
from pathlib import Path

import imageio.v3 as iio
import numpy as np
import pytest
from chromium import Page
from numpy.typing import NDArray

from facescript.cli.main import main
from facescript.diagnostics.catalogue import CATALOGUE

EXAMPLES = Path(__file__).parents[2] / "examples"
TILE = 32
EARLY, LATE = 0.015, 0.045
"""Seconds the picture may be ahead of and behind its sound (motion bar L1)."""

TRIES = 3

DOT = CATALOGUE["FS240"].good.partition("\nface ")[0] + "\n"
"""The smallest kind of face that the manual has."""

# Looked at after each frame is drawn, when every script of the page has had its turn.
CLOCKS = """
new Promise(done => {
  const svg = document.documentElement, audio = svg.querySelector("audio"), found = [];
  const look = () => setTimeout(() => {
    if (!audio.paused && audio.currentTime > 0.2) found.push(audio.currentTime - svg.getCurrentTime());
    if (found.length >= COUNT || audio.ended) done(found); else requestAnimationFrame(look);
  });
  audio.currentTime = FROM; audio.play(); requestAnimationFrame(look);
})
"""


@pytest.fixture(scope="module")
def evening(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("evening")
    words = ["-o", str(folder / "evening.svg"), "--to", "5s", "--quiet"]
    assert main(["build", str(EXAMPLES / "evening.face"), *words]) == 0
    return folder / "evening.svg"


@pytest.fixture(scope="module")
def minute(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A minute in which a simple face says something every two seconds."""
    folder = tmp_path_factory.mktemp("minute")
    lines = "".join(f'    say "Number {number}."\n    wait 1s\n' for number in range(36))
    script = f"film 320x320, 62s long, seed 1\n{DOT}face ada = dot\n    life still\nscene talk:\n{lines}"
    (folder / "minute.face").write_text(script, "utf-8")
    assert main(["build", str(folder / "minute.face"), "-o", str(folder / "minute.svg"), "--quiet"]) == 0
    return folder / "minute.svg"


def ours(moment: float, folder: Path) -> NDArray[np.int16]:
    place = folder / f"frame-{moment:.3f}.png"
    assert main(["build", str(EXAMPLES / "evening.face"), "-o", str(place), "--at", f"{moment:.3f}s", "--quiet"]) == 0
    return np.asarray(iio.imread(place))[..., :3].astype(np.int16)


def tiles(difference: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean of every whole TILE x TILE square."""
    rows, columns = (side // TILE for side in difference.shape)
    cut = difference[: rows * TILE, : columns * TILE]
    return cut.reshape(rows, TILE, columns, TILE).mean(axis=(1, 3))


def test_looks_like_our_frames(evening: Path, tmp_path: Path) -> None:
    with Page(evening.as_uri()) as page:
        page.run("(() => { const a = document.querySelector('audio'); if (a) a.pause(); })()")
        page.run("new Promise(done => setTimeout(done, 300))")
        duration = float(page.run("document.documentElement.getAttribute('data-duration')"))
        page.run("document.querySelector('.play').remove(); document.documentElement.pauseAnimations()")
        boxes = page.run(
            "[...document.querySelectorAll('.figure')].map(g => g.getBoundingClientRect())"
            ".map(b => [b.left, b.top, b.right, b.bottom])"
        )
        assert len(boxes) == 2
        for moment in np.linspace(0.05, 0.97, 10) * duration:
            page.run(f"document.documentElement.setCurrentTime({moment:.3f})")
            difference = np.abs(page.picture().astype(np.int16) - ours(round(moment, 3), tmp_path)).mean(axis=2)
            for left, top, right, bottom in boxes:
                part = difference[max(0, int(top)) : int(bottom), max(0, int(left)) : int(right)]
                assert part.mean() < 2, f"at {moment:.3f} s"
            assert tiles(difference).max() <= 12, f"at {moment:.3f} s"


def in_step(page: Page, start: int) -> bool:
    """Whether picture and sound keep together for 150 frames; a machine that stalls for a moment may spoil that."""
    found = np.array(page.run(CLOCKS.replace("FROM", str(start)).replace("COUNT", "150")))
    assert len(found) >= 100
    return bool(found[5:].min() >= -EARLY and found[5:].max() <= LATE)


def test_keeps_to_its_sound(minute: Path) -> None:
    with Page(minute.as_uri(), 320, 320) as page:
        for start in (0, 20, 40, 55):
            assert any(in_step(page, start) for _ in range(TRIES)), (
                f"from {start} s on the picture is behind its sound or ahead of it"
            )


def test_plays_without_script(evening: Path, tmp_path: Path) -> None:
    (tmp_path / "page.html").write_text(f'<img src="{evening.as_uri()}" width="640" height="360">')
    with Page((tmp_path / "page.html").as_uri(), 640, 360) as page:
        page.run("new Promise(done => setTimeout(done, 300))")
        first = page.picture().astype(int)
        page.run("new Promise(done => setTimeout(done, 900))")
        assert np.abs(page.picture().astype(int) - first).max() > 20


def test_a_click_starts_it_where_sound_is_refused(evening: Path) -> None:
    with Page(evening.as_uri(), sound=False) as page:
        page.run("new Promise(done => setTimeout(done, 400))")
        assert page.run("document.querySelector('audio').paused")
        assert page.run("document.querySelector('.play').getAttribute('visibility')") == "visible"
        page.click(640, 360)
        page.run("new Promise(done => setTimeout(done, 600))")
        assert not page.run("document.querySelector('audio').paused")
        assert page.run("document.querySelector('.play').getAttribute('visibility')") == "hidden"
        assert page.run("document.documentElement.getCurrentTime()") > 0.1


def test_a_still_and_the_shortest_films(tmp_path: Path) -> None:
    (tmp_path / "short.face").write_text(f"{DOT}face ada = dot\nnod for 60ms\n", "utf-8")
    for words in (["--at", "10ms"], ["--to", "4ms"], ["--to", "30ms"], []):
        assert main(["build", str(tmp_path / "short.face"), "-o", str(tmp_path / "out.svg"), "--quiet", *words]) == 0
        with Page((tmp_path / "out.svg").as_uri()) as page:
            assert np.ptp(page.picture()) > 100


def test_plays_where_scripts_are_off(evening: Path) -> None:
    with Page("about:blank#", 640, 360) as page:
        page.call("Emulation.setScriptExecutionDisabled", value=True)
        page.call("Page.navigate", url=evening.as_uri())
        pictures = []
        for _ in range(3):
            page.run("0")
            pictures.append(page.picture().astype(int))
            time.sleep(0.8)
        assert max(np.abs(picture - pictures[0]).max() for picture in pictures) > 20


def test_a_pages_style_sheet_changes_the_colours(evening: Path, tmp_path: Path) -> None:
    inline = evening.read_text("utf-8").split("?>", 1)[1].replace("<script", "<script type='text/none'")
    sheet = "[data-face=ada] {--clothes-base: #ff0000; --hair-top: #0000ff}"
    for name, style in (("plain", ""), ("styled", f"<style>{sheet}</style>")):
        (tmp_path / f"{name}.html").write_text(f"<!DOCTYPE html>{style}<body style='margin:0'>{inline}", "utf-8")
    seen = []
    for name in ("plain", "styled"):
        with Page((tmp_path / f"{name}.html").as_uri()) as page:
            page.run("document.querySelector('svg').pauseAnimations()")
            page.run("document.querySelector('svg').setCurrentTime(1)")
            page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
            bust = page.run("(b => [b.left, b.right])(document.getElementById('ada').getBoundingClientRect())")
            seen.append(page.picture().astype(int))
    change = seen[1] - seen[0]
    assert change[..., 0].max() > 100, "no redder clothes"
    assert change[..., 2].max() > 50, "no bluer hair"
    changed = np.flatnonzero(np.abs(change).max(axis=(0, 2)) > 8)
    assert bust[0] - 1 <= changed.min() <= changed.max() <= bust[1] + 1, "not ada alone"


def test_stands_still_where_motion_is_not_wanted(evening: Path, tmp_path: Path) -> None:
    (tmp_path / "page.html").write_text(f'<img src="{evening.as_uri()}" width="1280" height="720">')
    with Page((tmp_path / "page.html").as_uri(), calm=True) as page:
        page.run("new Promise(done => setTimeout(done, 300))")
        first = page.picture().astype(int)
        assert np.ptp(first[200:500, 200:500]) > 100, "nobody is there"
        page.run("new Promise(done => setTimeout(done, 1200))")
        assert np.abs(page.picture().astype(int) - first).max() == 0


def test_plays_on_request_where_motion_is_not_wanted(evening: Path) -> None:
    with Page(evening.as_uri(), calm=True) as page:
        page.run("new Promise(done => setTimeout(done, 400))")
        assert page.run("document.querySelector('audio').paused")
        page.click(640, 360)
        page.run("new Promise(done => setTimeout(done, 800))")
        assert page.run("document.documentElement.getCurrentTime()") > 0.1
        assert page.run("getComputedStyle(document.querySelector('.figure > .played')).display") != "none"
        assert page.run("getComputedStyle(document.querySelector('.figure > .stood')).display") == "none"
