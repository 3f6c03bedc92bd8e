"""The script beside its face in Chromium: what is written is played, helped, kept and shared."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NoReturn

import pytest
from accessible import faults
from chromium import Page, program
from serving import Serving
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

pytestmark = pytest.mark.skipif(program() is None, reason="no Chromium on this machine")

ROOT = Path(__file__).parents[2]
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
CHOOSE = """
(list => { list.value = "hello"; list.dispatchEvent(new Event("change")); })(
  document.querySelector(".source-examples select"))
"""
UNBUILT = """
const fetched = window.fetch;
window.fetch = async (address) => {
  const answer = await fetched(address);
  if (address !== "playground.json") return answer;
  return new Response(JSON.stringify({ ...await answer.json(), editor: false }));
};
"""
SAID = "document.querySelector('.source-told').textContent"
TEXT = "document.querySelector('.cm-content, .plain-text')"
ENTER, ESCAPE, DOWN, HOME = ("Enter", 13), ("Escape", 27), ("ArrowDown", 40), ("Home", 36)
CTRL = 2


@pytest.fixture(scope="module")
def address(editor: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The playground, with the editor that is built."""
    os.environ["PYTHONPATH"] = str(ROOT)
    with Serving(tmp_path_factory.mktemp("playground"), None, editor=editor) as serving:
        yield serving.address


@pytest.fixture(scope="module")
def page(address: str) -> Iterator[Page]:
    with Page("about:blank#", 1280, 800) as page:
        page.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        opened(page, address)
        until(page, "document.querySelector('.cm-face-time')")
        yield page


def opened(page: Page, address: str) -> None:
    page.call("Page.navigate", url=address)
    until(page, f"{TEXT} && window.facescript.time.duration > 0")
    page.run("facescript.link.on('script', (message) => { window.told = message; }); 0")


def until(page: Page, script: str, seconds: float = 30.0) -> None:
    """Waits until an expression holds in the page."""
    end = time.monotonic() + seconds
    while not page.run(f"Boolean({script})"):
        assert time.monotonic() < end, f"never: {script}; wrong: {page.run('window.wrong')}"
        time.sleep(0.05)


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
    page.run(f"facescript.link.say('jump', {{from: {place}, to: {place}}}); {TEXT}.focus()")


def written(page: Page, text: str) -> None:
    """Waits until the server has a text."""
    until(page, f"window.told?.text === {json.dumps(text)}")


def elsewhere(page: Page, before: str, after: str) -> None:
    """An edit that is not the editor's, as a dragged act makes it."""
    edit = {"from": 0, "to": len(before), "text": after}
    page.run(f"facescript.link.say('text', {{base: told.version, ...{json.dumps(edit)}}})")
    written(page, after)


def begun(page: Page) -> None:
    """The script, whole in the editor, by hand."""
    page.run(f"{TEXT}.focus()")
    press(page, ("a", 65), CTRL)
    page.call("Input.insertText", text=SCRIPT)
    written(page, SCRIPT)


def quiet(page: Page) -> None:
    """Nothing went wrong in the page, and it asked for nothing but of its own server."""
    assert page.run("window.wrong") == []
    assert page.run("performance.getEntriesByType('resource').every(({name}) => name.startsWith(location.origin))")


def test_what_is_written_is_helped_and_mended(page: Page) -> None:
    begun(page)
    time.sleep(0.6)  # what is typed within half a second is taken back together
    page.call("Input.insertText", text="    ada: shoow smile")
    until(page, "document.querySelector('.cm-lintRange-error')")
    written(page, SCRIPT + "    ada: shoow smile")
    press(page, ESCAPE)
    press(page, ("F8", 119))
    until(page, "document.querySelector('.cm-diagnosticAction')")
    page.run("document.querySelector('.cm-diagnosticAction').click()")
    written(page, SCRIPT + "    ada: show smile")
    until(page, "!document.querySelector('.cm-lintRange-error')")
    press(page, ("z", 90), CTRL)
    written(page, SCRIPT + "    ada: shoow smile")
    press(page, ("z", 90), CTRL)
    written(page, SCRIPT)


def test_it_offers_what_may_be_written(page: Page) -> None:
    begun(page)
    typed(page, "    ada: sho")
    until(page, "document.querySelector('.cm-tooltip-autocomplete li[aria-selected]')?.textContent.startsWith('show')")
    time.sleep(0.2)  # an offer that has only just come is not taken
    press(page, ENTER)
    written(page, SCRIPT + "    ada: show")
    press(page, ESCAPE)


def test_what_changes_elsewhere_shows_and_can_be_taken_back(page: Page) -> None:
    begun(page)
    caret_to(page, SCRIPT.index("nod"))
    other = SCRIPT.replace("64x64", "64x64, seed 4")
    elsewhere(page, SCRIPT, other)
    until(page, f"{TEXT}.textContent.includes('seed 4')")
    typed(page, "quick")
    written(page, other.replace("nod", "quicknod"))
    for _ in range(2):
        press(page, ("z", 90), CTRL)
    written(page, SCRIPT)


def test_what_plays_is_lit(page: Page) -> None:
    begun(page)
    until(page, "Math.abs(facescript.time.duration - 0.3) < 0.3")
    page.run("facescript.time.seek(0.2)")
    lit = "[...document.querySelectorAll('.cm-face-lit')].map((line) => line.textContent.slice(0, 12)).join()"
    until(page, f"{lit} === '    ada: nod'")
    page.run("facescript.time.seek(facescript.time.duration)")
    until(page, f"{lit} === ''")


def test_its_keys_are_not_the_players(page: Page) -> None:
    begun(page)
    typed(page, " ")
    written(page, SCRIPT + " ")
    press(page, ESCAPE)
    assert page.run("facescript.time.playing") is False


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_everybody_can_use_it(page: Page, scheme: str) -> None:
    page.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    press(page, ESCAPE)  # the list of what may be written
    until(page, "!document.querySelector('.cm-tooltip')")
    assert faults(page) == []


def test_a_plain_field_does_the_same(page: Page, address: str) -> None:
    added = page.call("Page.addScriptToEvaluateOnNewDocument", source=UNBUILT)
    opened(page, address)
    page.call("Page.removeScriptToEvaluateOnNewDocument", identifier=added["identifier"])
    assert "make playground" in page.run("document.querySelector('.source-note').textContent")
    page.run(CHOOSE)
    written(page, 'say "Hello."\n')
    begun(page)
    caret_to(page, SCRIPT.index("nod"))
    other = SCRIPT.replace("64x64", "64x64, seed 4")
    elsewhere(page, SCRIPT, other)
    typed(page, "quick")
    written(page, other.replace("nod", "quicknod"))
    assert faults(page) == []
    quiet(page)


def test_strangers_nonsense_and_floods_leave_it_as_it_is(page: Page, address: str) -> None:
    place = address.replace("http", "ws") + "lsp"
    with pytest.raises(InvalidStatus, match="403"):
        connect(place, origin=Origin("http://example.org"))
    uri = "file:///there/is/none.face"
    with connect(place) as other:
        ask(other, 1, "initialize", {"processId": None, "rootUri": None, "capabilities": {}})
        document = {"uri": uri, "languageId": "face", "version": 0, "text": SCRIPT}
        tell(other, "textDocument/didOpen", {"textDocument": document})
        for number in range(1000):
            changes = [{"text": SCRIPT + "#" * (number % 7)}]
            tell(
                other,
                "textDocument/didChange",
                {"textDocument": {"uri": uri, "version": number}, "contentChanges": changes},
            )
        where = {"textDocument": {"uri": uri}, "position": {"line": 3, "character": 10}}
        assert "nod" in ask(other, 2, "textDocument/hover", where)["result"]["contents"]["value"]
        assert "error" in ask(other, 3, "textDocument/nonsense", {})
        other.send('{"text": "' + "x" * 50_000_000 + '"}')
        with pytest.raises(ConnectionClosed):
            drained(other)
    begun(page)
    quiet(page)


def tell(connection: ClientConnection, method: str, parameters: object) -> None:
    connection.send(json.dumps({"jsonrpc": "2.0", "method": method, "params": parameters}))


def drained(connection: ClientConnection) -> NoReturn:
    """Read what was sent before the other side ended the connection."""
    while True:
        connection.recv(timeout=30)


def ask(connection: ClientConnection, number: int, method: str, parameters: object) -> Any:
    """The answer to a request."""
    connection.send(json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": parameters}))
    while True:
        found = json.loads(connection.recv(timeout=60))
        if found.get("id") == number:
            return found


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


def test_two_who_write_at_once_end_with_one_text(page: Page) -> None:
    ends = [page.run(TWO_WRITERS.replace("SEED", str(seed))) for seed in range(1, 40)]
    assert all(same and settled for same, settled, _ in ends)


def test_what_is_shared_is_one_page_with_the_script_in_it(page: Page, tmp_path: Path) -> None:
    page.run(CHOOSE)
    written(page, 'say "Hello."\n')
    begun(page)
    page.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(tmp_path))
    page.run("document.querySelector('[data-share]').click()")
    until(page, f"{SAID}.startsWith('Shared')")
    shared = found(tmp_path / "hello.html")
    press(page, ("s", 83), CTRL)
    assert found(tmp_path / "hello.face").read_text("utf-8") == SCRIPT
    typed(page, "    ada: shw")
    page.run("document.querySelector('[data-share]').click()")
    until(page, f"{SAID}.startsWith('Not shared: the script has an error')")
    quiet(page)
    page.call("Page.navigate", url=shared.as_uri())
    until(page, "window.facescript?.duration > 0")
    assert page.run("document.querySelector('.script pre').textContent") == SCRIPT
    assert faults(page) == []


def found(file: Path) -> Path:
    """A file, once it is there."""
    end = time.monotonic() + 10
    while not file.is_file():
        assert time.monotonic() < end, file.name
        time.sleep(0.05)
    return file
