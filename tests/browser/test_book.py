"""The page of a book in Chromium: what is beside the faces follows the time, and the place is kept."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from accessible import faults
from chromium import Page
from PIL import Image

from facescript.cli.main import main

SCRIPT = """\
film 160x120, 10fps, seed 3, title "Walks"
face ada = woman
    life still
scene one "The lake":
    picture "lake.png" "A lake"
    wait 1s
    link "https://example.org/" "More"
    say "Hello."
    picture none
    wait 1s
scene two:
    wait 3s
"""

BESIDE = "[...document.querySelector('.beside').children].map(each => each.textContent).join()"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    folder = tmp_path_factory.mktemp("book")
    Image.new("RGB", (16, 12)).save(folder / "lake.png")
    (folder / "walks.face").write_text(SCRIPT, "utf-8")
    out = folder / "walks.html"
    assert main(["build", str(folder / "walks.face"), "--page", "book", "-o", str(out), "--quiet"]) == 0
    with Page(out.as_uri(), 1280, 800) as page:
        yield page


def beside_at(page: Page, time: float) -> object:
    return page.run(f"new Promise(done => {{ facescript.seek({time}); setTimeout(() => done({BESIDE}), 150); }})")


def test_what_is_beside_the_faces_follows_the_time(page: Page) -> None:
    assert [beside_at(page, time) for time in (0.5, 1.2, 2.0, 3.0)] == ["A lake", "A lake,More", "More", ""]


def test_a_chapter_is_gone_to(page: Page) -> None:
    page.run("document.querySelectorAll('.fb-contents a')[1].click()")
    start = page.run("Number(document.querySelectorAll('.fb-chapter')[1].dataset.start)")
    assert page.run("facescript.time") == pytest.approx(start, abs=0.1)
    now = "new Promise(done => setTimeout(() => done(document.querySelector('[aria-current] bdi').textContent), 150))"
    assert page.run(now) == "Two"


def test_everybody_can_use_it(page: Page) -> None:
    assert faults(page) == []


def test_the_place_is_kept(page: Page) -> None:
    page.run("facescript.seek(2.5)")
    page.run("dispatchEvent(new Event('pagehide'))")
    page.call("Page.reload")
    found = page.run("new Promise(done => setTimeout(() => done(facescript.time), 700))")
    assert found == pytest.approx(2.5, abs=0.1)
