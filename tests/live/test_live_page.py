"""The page of a run in Chromium: what is touched is answered in face, sound and captions; a server may go."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import deque
from collections.abc import Iterator
from contextlib import ExitStack
from http.client import HTTPConnection
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from accessible import faults
from chromium import Page, program
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from facescript.live.page.guest import AHEAD
from facescript.live.page.page import PAGES

pytestmark = pytest.mark.skipif(program() is None, reason="no Chromium on this machine")

ROOT = Path(__file__).parents[2]

SCRIPT = """\
film 240x320, seed 5, title "The hall"
background #1f3a4d to #3f6b7a
face mia = woman, voice en-us female
    life still
scene attract:
    repeat forever:
        wait 1s
        look left 30deg, eyes only for 500ms
when touched "Start":
    show surprise for 1500ms
when touched "Where am I?":
    say "This is where you are. Come in."
when touched "start":
    nod
when key "q":
    show frown for 1s
"""

WATCHED = """
window.asked = []; window.faults = [];
new PerformanceObserver(list => list.getEntries().forEach(entry => asked.push(entry.name)))
  .observe({ type: "resource", buffered: true });
for (const name of ["error", "warn"]) { console[name] = (...said) => faults.push(said.join(" ")); }
addEventListener("error", event => faults.push(event.message));
addEventListener("unhandledrejection", event => faults.push(String(event.reason)));
addEventListener("securitypolicyviolation", event => faults.push(event.violatedDirective));
"""


class Live:
    """`facescript live` with its page, as a process of its own."""

    def __init__(self, folder: Path) -> None:
        script = folder / "hall.face"
        script.write_text(SCRIPT, "utf-8")
        command = [sys.executable, "-m", "facescript.cli.main", "live", str(script), "--fps", "20", "--page", "0"]
        around = os.environ | {"PYTHONPATH": str(ROOT)}
        self.process = subprocess.Popen(command, cwd=folder, env=around, stderr=subprocess.PIPE, text=True)
        assert self.process.stderr is not None
        found = re.search(r"http://127\.0\.0\.1:(\d+)/", self.process.stderr.readline())
        assert found is not None
        self.address, self.port = found[0], int(found[1])

    def end(self) -> str:
        """Ends it; what it told."""
        if self.process.poll() is not None:
            return ""
        self.process.terminate()
        return self.process.communicate(timeout=20)[1]

    def socket(self, **options: Any) -> ClientConnection:
        origin = self.address.rstrip("/")
        return connect(f"ws://127.0.0.1:{self.port}/live", **{"origin": origin, "max_size": None, **options})


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Live]:
    live = Live(tmp_path_factory.mktemp("live"))
    yield live
    live.end()


@pytest.fixture(scope="module")
def page(live: Live) -> Iterator[Page]:
    with Page("about:blank#", 300, 400) as page:
        page.call("Page.addScriptToEvaluateOnNewDocument", source=WATCHED)
        page.call("Emulation.setFocusEmulationEnabled", enabled=True)
        page.call("Page.navigate", url=live.address)
        wait(page, "window.facescript && facescript.picture.frames.length > 5")
        yield page


def wait(page: Page, condition: str, seconds: float = 20.0) -> None:
    begun = time.monotonic()
    while not page.run(f"Boolean({condition})"):
        assert time.monotonic() - begun < seconds, f"never {condition}"
        time.sleep(0.02)


def touch(page: Page, text: str) -> None:
    """A finger on the button with this text."""
    x, y = page.run(
        f"(box => [box.x + box.width / 2, box.y + box.height / 2])([...document.querySelectorAll('#touch button')]"
        f".find(each => each.textContent === {json.dumps(text)}).getBoundingClientRect())"
    )
    page.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
    page.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])


def drawn(page: Page) -> np.ndarray[Any, Any]:
    """The face as the page draws it: grey values of a small picture."""
    script = """(canvas => { const small = document.createElement("canvas"); small.width = 120; small.height = 160;
      const look = small.getContext("2d"); look.drawImage(canvas, 0, 0, 120, 160);
      return [...look.getImageData(0, 0, 120, 160).data.filter((_, at) => at % 4 === 1)]; })
      (document.querySelector(".fs-figures"))"""
    return np.array(page.run(script), dtype=float)


def moved(page: Page, before: np.ndarray[Any, Any], pixels: int = 60) -> bool:
    """Whether the face comes to look different in so many pixels; eyes alone have fewer."""
    until = time.monotonic() + 10
    while time.monotonic() < until:
        if (np.abs(drawn(page) - before) > 25).sum() > pixels:
            return True
    return False


def test_a_button_for_each_thing_to_touch_in_the_order_written(page: Page) -> None:
    texts = page.run("[...document.querySelectorAll('#touch button')].map(each => each.textContent)")
    assert texts == ["Start", "Where am I?"], "`start` is `Start` again"
    heights = page.run("[...document.querySelectorAll('#touch button')].map(each => each.clientHeight)")
    assert min(heights) >= 44
    assert page.run("document.title") == "The hall"


def test_the_face_moves_by_itself_between_the_runs_frames(page: Page) -> None:
    assert moved(page, drawn(page), 5), "the scene's own loop"
    held = "facescript.picture.frames.map(frame => frame.time)"
    times = page.run(held)
    assert all(later - sooner < 0.5 for sooner, later in pairwise(times))
    behind = page.run("facescript.picture.frames.at(-1).time - facescript.time.now()")
    assert -0.3 < behind < 0.5, "what is shown is not long ago"


def test_a_touch_is_answered_by_the_face(page: Page) -> None:
    before = drawn(page)
    touch(page, "Start")
    assert moved(page, before), "surprise opens mouth and eyes"


def test_a_key_is_told_and_no_other(page: Page) -> None:
    for key in ("q", "x"):
        page.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=key)
        page.call("Input.dispatchKeyEvent", type="keyUp", key=key)
    assert page.run("facescript.offered.told.filter(each => each.kind === 'key').map(each => each.text)") == ["q"]


def test_a_line_is_heard_when_its_mouth_is_seen_and_read(page: Page) -> None:
    touch(page, "Where am I?")
    wait(page, "facescript.sound.lines.some(line => line.heard)")
    wait(page, "document.getElementById('caption').textContent.includes('where you are')")
    asked = """(line => 1000 * (facescript.time.now() - line.start - line.into) - (performance.now() - line.heard))
      (facescript.sound.lines.at(-1))"""
    assert abs(page.run(asked)) < 40, "ms from the mouth to its sound"
    page.run("document.getElementById('captions-button').click()")
    assert page.run("getComputedStyle(document.getElementById('caption')).display") == "none"
    page.run("document.getElementById('captions-button').click()")


def test_a_line_that_breaks_off_is_cut(page: Page) -> None:
    wait(page, "facescript.sound.lines.every(line => facescript.time.now() > line.start + line.duration)")
    touch(page, "Where am I?")
    wait(page, "facescript.sound.lines.some(line => line.heard && facescript.time.now() > line.start + 0.3"
               " && facescript.time.now() < line.start + line.duration)")  # fmt: skip
    touch(page, "Where am I?")
    wait(page, "facescript.sound.lines.some(line => line.cut !== null)")


def test_everybody_can_use_it(page: Page) -> None:
    wait(page, "!document.querySelector('.taken')")
    time.sleep(0.5)  # a button fades back
    assert faults(page) == []
    page.run("document.getElementById('captions-button').focus()")
    for _ in range(2):
        page.call("Input.dispatchKeyEvent", type="rawKeyDown", key="Tab", code="Tab", windowsVirtualKeyCode=9)
    assert page.run("document.activeElement.matches('#touch button:focus-visible')")


def test_a_page_that_draws_nothing_is_sent_no_queue(live: Live) -> None:
    with live.socket() as idle:
        numbers = []
        while len(numbers) < AHEAD:
            numbers += [head["number"] for head in [head_of(idle.recv(timeout=10))] if head["kind"] == "frame"]
        time.sleep(0.6)
        idle.send(json.dumps({"kind": "drew", "number": numbers[-1]}))
        newest = head_of(idle.recv(timeout=10))["number"]
    assert newest >= numbers[-1] + 6, "the newest, and none of those it missed"


def head_of(message: str | bytes) -> dict[str, Any]:
    if isinstance(message, str):
        return dict(json.loads(message))
    return dict(json.loads(message[4 : 4 + int.from_bytes(message[:4], "little")]))


def test_strangers_and_nonsense_are_refused(live: Live) -> None:
    with pytest.raises(InvalidStatus, match="403"):
        live.socket(origin="http://example.org")
    asked = HTTPConnection("127.0.0.1", live.port)
    asked.request("GET", "/", headers={"Host": "example.org"})
    assert asked.getresponse().status == 403
    with live.socket() as page:
        for said in ("{", '{"kind": "touched"}', '{"kind": "touched", "text": "Stop"}', '{"kind": "signal"}'):
            page.send(said)
        page.send("x" * 5000)
        with pytest.raises(ConnectionClosed):
            deque(page, 0)


def test_no_more_pages_may_be_open_than_it_can_serve(page: Page, live: Live) -> None:
    with ExitStack() as pages:
        for _ in range(PAGES - 1):
            pages.enter_context(live.socket())
        with pytest.raises(InvalidStatus, match="503"):
            live.socket()
    assert page.run("facescript.picture.waiting") == 0


def test_it_waits_for_a_server_that_answers_nothing_and_comes_back(page: Page, live: Live) -> None:
    live.process.send_signal(signal.SIGSTOP)
    try:
        wait(page, "document.getElementById('state').textContent === 'One moment, please'")
        wait(page, "facescript.picture.waiting === 1")
        assert moved(page, drawn(page)), "a face that waits sways, and blinks"
        wait(page, "document.querySelector('#touch button').getAttribute('aria-disabled') === 'true'")
    finally:
        live.process.send_signal(signal.SIGCONT)
    wait(page, "document.getElementById('state').textContent === '' && facescript.picture.waiting === 0")
    before = drawn(page)
    touch(page, "Start")
    assert moved(page, before)


def test_it_is_quiet_and_asks_nobody_else(page: Page, live: Live) -> None:
    """The last test of this file: it looks back at all before it."""
    assert page.run("faults") == []
    asked = page.run("asked")
    assert asked and all(address.startswith((live.address, "data:")) for address in asked)
    told = live.end()
    assert re.search(r"from --page 0: .*6 events, 4 refused", told), told
