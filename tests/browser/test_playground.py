"""The script beside its face in Chromium: what is written is played, helped, kept and shared, and looks right to all."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from chromium import Page
from previewing import served

pytestmark = pytest.mark.xdist_group("playground")

SCRIPT = """\
film 64x64
face ada = woman
scene one:
    ada: nod for 300ms
"""
WATCH = """
window.wrong = [];
addEventListener("error", (event) => wrong.push(String(event.message)));
addEventListener("unhandledrejection", (event) => wrong.push(String(event.reason)));
addEventListener("securitypolicyviolation", (event) => wrong.push(event.blockedURI + " " + event.violatedDirective));
"""
TEXT = "document.querySelector('.cm-content, .plain-text')"
ENTER, ESCAPE, DOWN, HOME = ("Enter", 13), ("Escape", 27), ("ArrowDown", 40), ("Home", 36)
CTRL = 2


@pytest.fixture(scope="module")
def browser() -> Iterator[Page]:
    with Page("about:blank#", 1280, 800) as page:
        page.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        yield page


def opened(page: Page, address: str) -> None:
    page.call("Page.navigate", url=address)
    until(page, f"{TEXT} && window.facescript.time.duration > 0")


def until(page: Page, script: str, seconds: float = 30.0) -> None:
    """Waits until an expression holds in the page."""
    end = time.monotonic() + seconds
    while not page.run(f"Boolean({script})"):
        assert time.monotonic() < end, f"never: {script}; wrong: {page.run('window.wrong')}"
        time.sleep(0.05)


def said(page: Page) -> str:
    return str(page.run("document.querySelector('.source-told').textContent"))


def press(page: Page, key: tuple[str, int], modifiers: int = 0) -> None:
    name, number = key
    for kind in ("rawKeyDown", "keyUp"):
        page.call(
            "Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=number, modifiers=modifiers
        )


def typed(page: Page, text: str) -> None:
    for sign in text:
        page.call("Input.dispatchKeyEvent", type="keyDown", text=sign, key=sign)
        page.call("Input.dispatchKeyEvent", type="keyUp", key=sign)


def caret_to(page: Page, place: int) -> None:
    page.run(
        f"document.querySelector('#source-button').focus(), facescript.link.say('jump', {{from: {place}, to: {place}}})"
    )
    page.run(f"{TEXT}.focus()")


def quiet(page: Page) -> None:
    """Nothing went wrong in the page, and it asked for nothing but of its own server."""
    assert page.run("window.wrong") == []
    assert page.run("performance.getEntriesByType('resource').every(({name}) => name.startsWith(location.origin))")


@pytest.fixture(scope="module")
def helped(browser: Page, editor: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Page, Path]]:
    """A script of a file in the editor that is built, with its language server."""
    folder = tmp_path_factory.mktemp("helped")
    (folder / "talk.face").write_text(SCRIPT, "utf-8")
    with served(folder, "talk.face", editor=editor) as address:
        opened(browser, address)
        until(browser, "document.querySelector('.cm-face-time')")
        yield browser, folder / "talk.face"


def kept(file: Path, text: str) -> None:
    end = time.monotonic() + 10
    while file.read_text("utf-8") != text:
        assert time.monotonic() < end, file.read_text("utf-8")
        time.sleep(0.05)


def test_what_is_written_is_helped_mended_and_kept(helped: tuple[Page, Path]) -> None:
    page, file = helped
    caret_to(page, len(SCRIPT))
    typed(page, "    ada: shoow smile")
    until(page, "document.querySelector('.cm-lintRange-error')")
    kept(file, SCRIPT + "    ada: shoow smile")
    press(page, ESCAPE)
    press(page, ("F8", 119))
    until(page, "document.querySelector('.cm-diagnosticAction')")
    page.run("document.querySelector('.cm-diagnosticAction').click()")
    kept(file, SCRIPT + "    ada: show smile")
    until(page, "!document.querySelector('.cm-lintRange-error')")
    press(page, ("z", 90), CTRL)
    kept(file, SCRIPT + "    ada: shoow smile")
    press(page, ("z", 90), CTRL)
    kept(file, SCRIPT)


def test_it_offers_what_may_be_written(helped: tuple[Page, Path]) -> None:
    page, file = helped
    caret_to(page, len(SCRIPT))
    typed(page, "    ada: sho")
    until(page, "document.querySelector('.cm-tooltip-autocomplete li[aria-selected]')?.textContent.startsWith('show')")
    time.sleep(0.2)  # an offer that has only just come is not taken
    press(page, ENTER)
    kept(file, SCRIPT + "    ada: show")
    press(page, ESCAPE)
    file.write_text(SCRIPT, "utf-8")
    until(page, f"{TEXT}.textContent.indexOf('show') < 0")


def test_what_changes_elsewhere_shows_and_can_be_taken_back(helped: tuple[Page, Path]) -> None:
    page, file = helped
    caret_to(page, SCRIPT.index("nod"))
    other = SCRIPT.replace("film 64x64", "film 128x128, seed 4")
    file.write_text(other, "utf-8")
    until(page, f"{TEXT}.textContent.includes('seed 4')")
    typed(page, "quick")
    kept(file, other.replace("nod", "quicknod"))
    for _ in range(2):
        press(page, ("z", 90), CTRL)
    kept(file, SCRIPT)


def test_what_plays_is_lit(helped: tuple[Page, Path]) -> None:
    page, _ = helped
    version = page.run("facescript.picture.version")
    place = SCRIPT.index("ada: nod")
    detail = f"{{version: {version}, places: [{{from: {place}, to: {place + 8}}}]}}"
    page.run(f"dispatchEvent(new CustomEvent('facescript-plays', {{detail: {detail}}}))")
    lit = "[...document.querySelectorAll('.cm-face-lit')].map((line) => line.textContent.slice(0, 12)).join()"
    until(page, f"{lit} === '    ada: nod'")


def test_it_sends_no_key_of_its_own_to_the_player(helped: tuple[Page, Path]) -> None:
    page, _ = helped
    caret_to(page, len(SCRIPT))
    typed(page, " ")
    assert page.run("facescript.time.playing") is False
    press(page, ("z", 90), CTRL)
    quiet(page)


@pytest.fixture(scope="module")
def plain(browser: Page, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Page, Path]]:
    """The playground where the editor was not built."""
    folder = tmp_path_factory.mktemp("plain")
    with served(folder) as address:
        opened(browser, address)
        yield browser, folder


def test_examples_and_sharing(plain: tuple[Page, Path]) -> None:
    page, folder = plain
    assert "make playground" in page.run("document.querySelector('.source-note').textContent")
    page.run(
        "(list => { list.value = 'hello'; list.dispatchEvent(new Event('change')); })(document.querySelector('.source-examples select'))"
    )
    until(page, "facescript.time.duration < 2")
    assert page.run(f"{TEXT}.value") == 'say "Hello."\n'
    page.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    page.run("document.querySelector('[data-share]').click()")
    until(page, "document.querySelector('.source-told').textContent.startsWith('Shared')")
    end = time.monotonic() + 10
    while not (folder / "hello.html").is_file():
        assert time.monotonic() < end
        time.sleep(0.05)
    assert "say &quot;Hello.&quot;\n</pre>" in (folder / "hello.html").read_text("utf-8")
    page.run(f"{TEXT}.focus()")
    press(page, ("a", 65), CTRL)
    typed(page, "ada: shw")
    until(page, "document.querySelector('#faults').textContent.includes('FS')")
    page.run("document.querySelector('[data-share]').click()")
    until(page, "document.querySelector('.source-told').textContent.startsWith('Not shared: the script has an error')")
    press(page, ("s", 83), CTRL)
    while not (folder / "hello.face").is_file():
        assert time.monotonic() < end
        time.sleep(0.05)
    quiet(page)


TWO_WRITERS = """
(async () => {
  const { Shared } = await import("/edits.js");
  let state = SEED;
  const dice = (n) => { state = (state * 1103515245 + 12345) % 2147483648; return Math.floor(state / 65536) % n; };
  const server = { version: 1, text: "one\\n😀two\\nthree\\n" }, wire = [];
  let editor = server.text, clashes = 0;
  const shared = new Shared({
    read: () => editor,
    send: (edit) => wire.push(() => {
      if (edit.base !== server.version) return wire.push(() => shared.refused());
      server.text = server.text.slice(0, edit.from) + edit.text + server.text.slice(edit.to);
      publish();
    }),
    take: ({ from, to, text }) => { editor = editor.slice(0, from) + text + editor.slice(to); },
  });
  const publish = () => {
    const { version, text } = Object.assign(server, { version: server.version + 1 });
    wire.push(() => { clashes += shared.told(version, text); });
  };
  const written = (text, sign) => {
    const from = dice(text.length + 1), to = Math.min(text.length, from + dice(3));
    return text.slice(0, from) + (dice(4) ? sign : "") + text.slice(to);
  };
  shared.begin(1, server.text);
  for (let step = 0; step < 300; step++) {
    const what = dice(5);
    if (what < 2) editor = written(editor, "é");
    else if (what === 2) server.text = written(server.text, "界"), publish();
    else if (what === 3) shared.flush();
    else wire.shift()?.();
  }
  do { shared.flush(), wire.shift()?.(); } while (wire.length);
  return [editor === server.text, shared.settled, clashes];
})()
"""


def test_two_who_write_at_once_end_with_one_text(plain: tuple[Page, Path]) -> None:
    page, _ = plain
    found = [page.run(TWO_WRITERS.replace("SEED", str(seed))) for seed in range(1, 40)]
    assert all(same and settled for same, settled, _ in found)
