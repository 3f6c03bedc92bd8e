"""The timeline in Chromium: what it shows, what pointer and keys do, and a dragged act in the script's file."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from accessible import faults
from chromium import Page, program
from serving import Serving

pytestmark = pytest.mark.skipif(program() is None, reason="no Chromium on this machine")

SCRIPT = """\
film 96x54, 30fps
face ada = woman
say "Where is my cup?" as hello
show smile 60% for 2s
nod 40%
wait 1s
blink
"""
WATCH = """
window.wrong = []; window.heard = [];
addEventListener("error", (event) => wrong.push(String(event.message)));
addEventListener("unhandledrejection", (event) => wrong.push(String(event.reason)));
addEventListener("securitypolicyviolation", (event) => wrong.push(event.blockedURI + " " + event.violatedDirective));
"""
READY = """
window.facescript?.line.view.peaks.length && facescript.line.fresh
  && facescript.line.view.score.lines.some(({text}) => text.includes("cup"))
"""
VIEW = "facescript.line.view"
HEARD = f"import('/timeline/marks.js').then(({{heard}}) => heard({VIEW}).map(({{text}}) => text))"
ALT, CTRL, SHIFT = 1, 2, 8


@pytest.fixture
def script(serving: Serving) -> Path:
    return serving.script


@pytest.fixture(scope="module")
def browser(serving: Serving) -> Iterator[Page]:
    before = serving.script.read_text("utf-8")
    serving.script.write_text(SCRIPT, "utf-8")
    with Page("about:blank#", 1280, 800) as page:
        page.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        page.call("Page.navigate", url=serving.address)
        until(page, READY, 60)
        page.run("for (const kind of ['would', 'refused']) facescript.link.on(kind, (each) => heard.push(each)), 0")
        yield page
        assert page.run("window.wrong") == []
    serving.script.write_text(before, "utf-8")


@pytest.fixture
def page(browser: Page, script: Path) -> Page:
    """The page as it is at first."""
    browser.run("facescript.time.pause(), facescript.time.seek(0), facescript.line.choose(null), heard.length = 0")
    browser.run("facescript.line.loop.off(), facescript.line.surface.zoom(0)")
    if script.read_text("utf-8") != SCRIPT:
        version = browser.run(f"{VIEW}.version")
        script.write_text(SCRIPT, "utf-8")
        until(browser, f"{VIEW}.version > {version} && facescript.line.fresh")
    return browser


def until(page: Page, expression: str, seconds: float = 20.0) -> None:
    end = time.monotonic() + seconds
    while not page.run(f"Boolean({expression})"):
        assert time.monotonic() < end, f"never: {expression}; wrong: {page.run('window.wrong')}"
        time.sleep(0.03)


def act(page: Page, label: str) -> dict[str, Any]:
    found: dict[str, Any] = page.run(f"{VIEW}.score.acts.find(({{label}}) => label.includes('{label}'))")
    return found


def place(page: Page, label: str, edge: str) -> tuple[float, float]:
    """Where an edge of a bar is on the page, or its `middle`."""
    x, y = page.run(f"""(() => {{
      const view = {VIEW}, act = view.score.acts.find(({{label}}) => label.includes("{label}"));
      const lane = view.strips.find(({{kind, number}}) => kind === "lane" && number === act.lane);
      const box = facescript.line.surface.sight.getBoundingClientRect();
      const time = "{edge}" === "middle" ? (act.start + act.until) / 2 : act["{edge}"];
      return [box.left + view.axis.x(time), box.top + 30 - view.scrolled + lane.top + (act.row + 0.5) * lane.row];
    }})()""")
    return x, y


def mouse(page: Page, kind: str, x: float, y: float, modifiers: int = 0) -> None:
    held = {"mouseMoved": 0, "mousePressed": 1}.get(kind, 0)
    options = {"button": "left", "buttons": held, "clickCount": 1, "modifiers": modifiers}
    page.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **options)


def drag(page: Page, label: str, edge: str, across: float, up: float = 0.0, modifiers: int = 0) -> None:
    """Presses on a bar and moves; the pointer stays down."""
    x, y = place(page, label, edge)
    mouse(page, "mousePressed", x, y, modifiers)
    for step in (0.5, 1.0):
        options = {"button": "left", "buttons": 1, "modifiers": modifiers}
        page.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + across * step, y=y - up * step, **options)


def drop(page: Page) -> None:
    mouse(page, "mouseReleased", 5, 5)


def press(page: Page, key: str, modifiers: int = 0) -> None:
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key, code=key, modifiers=modifiers)


def written(script: Path, page: Page, line: str) -> None:
    """Waits until a line stands in the script, and the page shows it."""
    end = time.monotonic() + 20
    while line not in script.read_text("utf-8").splitlines():
        assert time.monotonic() < end, f"{line!r} never: {script.read_text('utf-8')}; {page.run('heard')}"
        time.sleep(0.03)
    until(page, f"facescript.line.text.includes('{line}') && facescript.line.fresh && !{VIEW}.drag")


def test_lanes_and_words_are_shown(page: Page) -> None:
    names = page.run("[...document.querySelectorAll('.tl-name')].map(({textContent}) => textContent)")
    assert names == ["face", "gesture", "speech", "words", "life"]
    until(page, f"{VIEW}.words.length === 4")
    seen = page.run(
        f"{VIEW}.words.map(({{x, word}}) => [Math.round(x), Math.round({VIEW}.axis.x(word.start)), word.text])"
    )
    assert [text for _, _, text in seen] == ["Where", "is", "my", "cup"] and all(x == right for x, right, _ in seen)


def test_what_plays_is_lit(page: Page) -> None:
    smile, line = act(page, "smile"), page.run(f"{VIEW}.score.lines[0]")
    page.run(f"facescript.time.seek({smile['start'] + 0.2})")
    until(page, f"{VIEW}.lit.some(({{label}}) => label.includes('smile'))")
    assert page.run(HEARD) == []
    page.run(f"facescript.time.seek({line['words'][3]['start'] + 0.01})")
    until(page, f"{VIEW}.lit.some(({{label}}) => label.startsWith('“Where'))")
    assert page.run(HEARD) == ["cup"]


def test_a_click_chooses_an_act_and_jumps_to_its_line(page: Page) -> None:
    page.run("window.jumps = [], facescript.link.on('said jump', (each) => jumps.push(each)), 0")
    x, y = place(page, "smile", "middle")
    mouse(page, "mouseMoved", x, y)
    until(page, "document.querySelector('.tl-note').textContent.includes('script.face:4')")
    page.click(round(x), round(y))
    smile = act(page, "smile")
    assert page.run("jumps.map(({from, to}) => [from, to])") == [[smile["from"], smile["to"]]]
    assert page.run(f"{VIEW}.chosen.label") == smile["label"]


def test_the_ruler_is_scrubbed_and_looped(page: Page) -> None:
    box = page.run("(({left, top}) => ({left, top}))(facescript.line.surface.sight.getBoundingClientRect())")
    at = [box["left"] + page.run(f"{VIEW}.axis.x({time})") for time in (1.0, 2.0)]
    page.click(round(at[0]), round(box["top"] + 8))
    assert page.run("facescript.time.now()") == pytest.approx(1.0, abs=0.02)
    mouse(page, "mousePressed", at[0], box["top"] + 8, SHIFT)
    mouse(page, "mouseMoved", at[1], box["top"] + 8, SHIFT)
    mouse(page, "mouseReleased", at[1], box["top"] + 8, SHIFT)
    assert page.run("facescript.time.loop") == pytest.approx([1.0, 2.0], abs=0.02)
    press(page, "r")
    assert page.run("facescript.time.loop") is None


def test_zoom_keeps_the_time_under_the_pointer(page: Page) -> None:
    x, y = place(page, "nod", "middle")
    left = page.run("facescript.line.surface.sight.getBoundingClientRect().left")
    before = page.run(f"{VIEW}.axis.time({x - left})")
    page.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-400, modifiers=CTRL)
    until(page, f"{VIEW}.axis.scale > 2 * {VIEW}.axis.fit")
    assert page.run(f"{VIEW}.axis.time({x - left})") == pytest.approx(before, abs=0.02)


def test_the_end_of_an_act_is_dragged_into_the_script_and_taken_back(page: Page, script: Path) -> None:
    pixels = 0.5 * page.run(f"{VIEW}.axis.scale")
    drag(page, "smile", "until", pixels, modifiers=ALT)
    until(page, f"{VIEW}.drag?.would.startsWith('show smile 60% for 2.')")
    assert "end " in page.run("document.querySelector('.tl-note').textContent")
    drop(page)
    written(script, page, "show smile 60% for 2.5s")
    press(page, "z", CTRL)
    written(script, page, "show smile 60% for 2s")


def test_up_is_stronger(page: Page, script: Path) -> None:
    drag(page, "nod", "middle", 0, up=36)
    assert page.run(f"{VIEW}.drag.degree") == pytest.approx(0.7)
    drop(page)
    written(script, page, "nod 70%")


def test_a_drag_snaps_to_a_word_and_escape_ends_it(page: Page, script: Path) -> None:
    end = page.run(f"{VIEW}.score.lines[0].words[2].end")
    pixels = (end - act(page, "“Where")["start"]) * page.run(f"{VIEW}.axis.scale")
    page.run(f"facescript.line.choose({VIEW}.score.acts.find(({{label}}) => label.includes('blink')))")
    drag(page, "blink", "middle", -pixels / 4)
    assert page.run(f"{VIEW}.drag.moved")
    press(page, "Escape")
    assert page.run(f"{VIEW}.drag") is None
    drop(page)
    time.sleep(0.2)
    assert script.read_text("utf-8") == SCRIPT


def test_what_cannot_be_is_refused_with_a_sentence(page: Page, script: Path) -> None:
    page.run(
        f"{VIEW}.say('drag', {{version: {VIEW}.version, id: 999, handle: 'end', by: 1, degree: null, done: true}})"
    )
    until(page, "heard.some(({kind}) => kind === 'refused')")
    until(page, "document.querySelector('[role=status].tl-hidden').textContent.includes('changed since')")
    assert script.read_text("utf-8") == SCRIPT


def test_keys_walk_over_the_acts_and_move_them(page: Page, script: Path) -> None:
    page.run("document.querySelector('.tl-acts').focus()")
    press(page, "ArrowRight")
    chosen = [page.run(f"{VIEW}.chosen.label")]
    for key in ("ArrowDown", "ArrowRight", "ArrowUp", "Home"):
        press(page, key)
        chosen.append(page.run(f"{VIEW}.chosen.label"))
    assert chosen == ["show smile 60% for 2s", "nod 40%", "blink", "show smile 60% for 2s", "show smile 60% for 2s"]
    read = page.run("document.getElementById(document.activeElement.getAttribute('aria-activedescendant')).textContent")
    assert read.startswith("show smile 60% for 2s, 0.") and read.endswith("line 4")
    press(page, "ArrowUp", ALT)
    written(script, page, "show smile 65% for 2s")


def test_two_fingers_zoom(page: Page) -> None:
    x, y = place(page, "nod", "middle")

    def touch(kind: str, *fingers: float) -> None:
        points = [{"x": x + finger, "y": y, "id": number} for number, finger in enumerate(fingers)]
        page.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)

    touch("touchStart", -40, 40)
    for apart in (40, 60, 80):
        touch("touchMove", -apart, apart)
    touch("touchEnd")
    until(page, f"Math.abs({VIEW}.axis.scale / {VIEW}.axis.fit - 2) < 0.1")


def test_what_plays_stays_in_sight(page: Page) -> None:
    page.run("facescript.line.surface.zoom(20, 0), facescript.time.seek(0.3), facescript.time.play()")
    until(page, f"{VIEW}.axis.left > 0 && {VIEW}.axis.x({VIEW}.time) < 0.9 * {VIEW}.axis.width")
    page.run("facescript.time.pause()")


def test_curves_are_drawn_for_the_channels_that_are_ticked(page: Page) -> None:
    chip = "[...document.querySelectorAll('.tl-chip')].find(({textContent}) => textContent === 'Lids')"
    page.run(f"{chip}.click()")
    until(page, f"{VIEW}.strips.some(({{kind}}) => kind === 'curves')")
    assert page.run("[...document.querySelectorAll('.tl-entry')].map(({textContent}) => textContent)") == [
        "lid.left",
        "lid.right",
    ]
    page.run(f"{chip}.click()")
    until(page, f"!{VIEW}.strips.some(({{kind}}) => kind === 'curves')")


def test_an_error_is_over_the_last_good_picture_and_in_the_list(page: Page, script: Path) -> None:
    script.write_text(SCRIPT.replace("nod 40%", "nodd 40%"), "utf-8")
    until(page, "!document.getElementById('faults').hidden")
    assert "line 5" in page.run("document.getElementById('faults').textContent")
    assert page.run("document.querySelector('.fault-count').dataset.severity") == "error"
    assert page.run(f"{VIEW}.score.acts.some(({{label}}) => label === 'nod 40%')")
    script.write_text(SCRIPT, "utf-8")
    until(page, "document.getElementById('faults').hidden")


def test_a_screen_reader_finds_its_way(page: Page) -> None:
    page.call("Accessibility.enable")
    nodes = page.call("Accessibility.getFullAXTree")["nodes"]
    found = {(node["role"]["value"], node.get("name", {}).get("value")) for node in nodes if not node.get("ignored")}
    wanted = {
        ("slider", "Playhead"),
        ("listbox", "Acts"),
        ("button", "Loop"),
        ("group", "ada, face"),
        ("button", "Curves"),
    }
    assert wanted <= found
    assert any(role == "option" and name.startswith("show smile") for role, name in found)


def test_axe_finds_nothing_in_it(page: Page) -> None:
    page.run(f"facescript.line.choose({VIEW}.score.acts[0]), facescript.line.loop.set(1, 2)")
    page.run("document.querySelectorAll('.tl-more > .tl-tool').forEach((button) => button.click())")
    for theme in ("light", "dark"):
        page.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}])
        assert faults(page) == [], theme
    page.call("Emulation.setEmulatedMedia", features=[])
    page.run("document.body.dispatchEvent(new PointerEvent('pointerdown', {bubbles: true})), 0")
