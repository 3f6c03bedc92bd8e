"""The page in Chromium: it plays with its sound, shows what is saved, keeps its picture under an error, is quiet."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
import pytest
from chromium import Page, program
from serving import SCRIPT, Serving

pytestmark = pytest.mark.skipif(program() is None, reason="no Chromium on this machine")

SPOKEN = SCRIPT.replace("life still", "life still\n    voice en-us").replace("wait 2s", 'say "Good evening."')

WATCHED = """
window.asked = []; window.faults = [];
new PerformanceObserver(list => list.getEntries().forEach(entry => asked.push(entry.name)))
  .observe({ type: "resource", buffered: true });
for (const name of ["error", "warn"]) { console[name] = (...said) => faults.push(said.join(" ")); }
addEventListener("error", event => faults.push(event.message));
addEventListener("unhandledrejection", event => faults.push(String(event.reason)));
addEventListener("securitypolicyviolation", event => faults.push(event.violatedDirective));
"""

FAULTS = "document.getElementById('faults')"
FACE = "document.getElementById('face')"


@pytest.fixture(scope="module")
def page(serving: Serving) -> Iterator[Page]:
    serving.script.write_text(SPOKEN, "utf-8")
    with Page("about:blank#", 900, 700) as page:
        page.call("Page.addScriptToEvaluateOnNewDocument", source=WATCHED)
        page.call("Page.navigate", url=serving.address)
        wait(page, "window.facescript && facescript.picture.drawn >= 0 && document.getElementById('sound').src")
        yield page


def wait(page: Page, condition: str, seconds: float = 20.0) -> None:
    begun = time.monotonic()
    while not page.run(f"Boolean({condition})"):
        assert time.monotonic() - begun < seconds, f"never {condition}"
        time.sleep(0.02)


def save(serving: Serving, page: Page, text: str) -> None:
    """Saves a script and waits until its picture is there."""
    version = int(page.run(f"{FACE}.dataset.version"))
    serving.script.write_text(text, "utf-8")
    wait(page, f"Number({FACE}.dataset.version) > {version}")


def test_it_plays_with_its_sound(page: Page) -> None:
    page.run("facescript.time.seek(1); facescript.time.play(); 0")
    wait(page, "facescript.time.now() > 1.3")
    ahead = page.run("facescript.picture.drawn - document.getElementById('sound').currentTime")
    assert abs(ahead) < 0.1
    page.run("facescript.time.pause(); 0")
    at = page.run("facescript.time.now()")
    time.sleep(0.1)
    assert page.run("facescript.time.now()") == at and page.run("document.getElementById('sound').paused")


def test_a_save_shows_in_place(serving: Serving, page: Page) -> None:
    page.run("facescript.time.seek(2.2); 0")
    wait(page, "Math.abs(facescript.picture.drawn - 2.2) < 0.01")
    before = page.picture()
    save(serving, page, SPOKEN.replace("show wry", "show wry + surprise"))
    page.run("facescript.time.redraw(); 0")
    wait(page, "Math.abs(facescript.picture.drawn - 2.2) < 0.01")
    changed = np.abs(page.picture().astype(int) - before).max(axis=2) > 40
    assert changed.sum() > 500, "surprise opens eyes and mouth"
    assert abs(page.run("facescript.time.now()") - 2.2) < 0.01


def test_an_error_keeps_the_picture_with_the_message_over_it(serving: Serving, page: Page) -> None:
    version = page.run(f"{FACE}.dataset.version")
    serving.script.write_text(SPOKEN.replace("show wry", "shwo wry"), "utf-8")
    wait(page, f"!{FAULTS}.hidden && {FAULTS}.textContent.includes('FS204')")
    page.run("facescript.time.seek(0.7); 0")
    wait(page, "Math.abs(facescript.picture.drawn - 0.7) < 0.01")
    assert page.run(f"{FACE}.dataset.version") == version
    save(serving, page, SPOKEN)
    wait(page, f"{FAULTS}.hidden")


def test_faces_that_look_different_take_the_place_of_the_others(serving: Serving, page: Page) -> None:
    save(serving, page, SPOKEN.replace("woman", "man").replace("480x270", "270x480"))
    assert page.run("facescript.picture.size") == [270, 480]
    assert page.run(f"{FACE}.querySelectorAll('canvas').length") == 2
    save(serving, page, SPOKEN)


def test_a_page_that_was_away_is_told_all_again(page: Page) -> None:
    page.run("facescript.link.drop(); 0")
    wait(page, "document.getElementById('state').textContent !== ''")
    wait(page, "document.getElementById('state').textContent === ''")
    page.run("facescript.time.seek(1.1); 0")
    wait(page, "Math.abs(facescript.picture.drawn - 1.1) < 0.01")


def test_it_is_quiet_and_asks_nobody_else(serving: Serving, page: Page) -> None:
    """The last test of this file: it looks back at all before it."""
    assert page.run("faults") == []
    asked = page.run("asked")
    assert asked and all(address.startswith((serving.address, "data:")) for address in asked)
