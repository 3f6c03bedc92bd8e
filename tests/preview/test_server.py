"""The server by a real client: what a page is told, what it may say, and who is not let in."""

from __future__ import annotations

import socket
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress

import pytest
from serving import PARTS, SCRIPT, Message, Serving, said, until
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection

CHUNKS = 5


@pytest.fixture(scope="module", autouse=True)
def begun(serving: Serving) -> None:
    """The script is what it is in these tests, whatever others made of it."""
    serving.script.write_text(SCRIPT, "utf-8")
    with serving.page() as page:
        version = until(page, lambda message: message["kind"] == "script" and message["text"] == SCRIPT)[-1]["version"]
        until(page, lambda message: message["kind"] == "score" and message["version"] == version)
        until(page, lambda message: message["kind"] == "figure" and message["version"] == version)


@pytest.fixture(scope="module")
def page(serving: Serving) -> Iterator[ClientConnection]:
    with serving.page() as page:
        yield page


def kind(name: str, version: int = 0) -> Callable[[Message], bool]:
    return lambda message: message["kind"] == name and message.get("version", 0) >= version


def versions(serving: Serving, page: ClientConnection, text: str) -> list[Message]:
    """Saves a text; what the page is told up to its score."""
    serving.script.write_text(text, "utf-8")
    found = until(page, lambda message: message["kind"] == "script" and message["text"] == text)
    return until(page, kind("score", found[-1]["version"]))


def test_a_page_is_told_all_there_is(serving: Serving) -> None:
    frames: set[int] = set()

    def complete(message: Message) -> bool:
        frames.update([message["chunk"]] if message["kind"] == "frames" else [])
        return len(frames) == CHUNKS

    with serving.page() as page:
        told = until(page, complete)
    first = {message["kind"]: message for message in reversed(told)}
    assert {"script", "diagnostics", "score", "figure", "mean", "ways", "layer", "frames"} <= set(first)
    assert (first["script"]["text"], first["script"]["writable"]) == (SCRIPT, True)
    assert first["diagnostics"]["items"] == []
    score = first["score"]
    smile = next(act for act in score["acts"] if "smile" in act["label"])
    assert SCRIPT[smile["from"] : smile["to"]].strip() == "show smile 40% for 1s"
    assert smile["start"] == pytest.approx(0.5) and smile["line"] == 7
    assert score["film"]["width"] == 480 and 4 <= score["duration"] <= 5
    assert first["figure"]["chunks"] == CHUNKS
    rows = sum(first["frames"]["ways"]) + 2 * len(first["figure"]["shapes"]) + 3
    assert first["frames"]["numbers"] == rows + 61 * len(first["frames"]["moving"])


def test_after_an_edit_only_what_changed_is_drawn(serving: Serving, page: ClientConnection) -> None:
    text = SCRIPT.replace("wait 2s", "blink\n    wait 2s")
    versions(serving, page, text)
    told: list[Message] = []
    drawn = lambda: {m["chunk"] for m in told if m["kind"] == "frames"}  # noqa: E731
    kept = lambda: {c for m in told if m["kind"] == "kept" for c in m["chunks"]}  # noqa: E731
    while len(drawn() | kept()) < CHUNKS:
        told += until(page, lambda message: message["kind"] in ("frames", "kept"))
    assert drawn() == {2} and kept() == {0, 1, 3, 4}, "it blinks at 2.3 s"
    versions(serving, page, SCRIPT)


def test_the_playhead_is_bound_to_its_statement(serving: Serving, page: ClientConnection) -> None:
    said(page, "playhead", time=0.8, playing=False)
    before = versions(serving, page, SCRIPT + "\n")[-1]
    assert before["playhead"] == pytest.approx(0.8)
    after = versions(serving, page, SCRIPT.replace("wait 500ms\n    show smile", "wait 1200ms\n    show smile"))[-1]
    assert (after["was"], after["playhead"]) == (pytest.approx(0.8), pytest.approx(1.5))


def test_an_error_is_told_with_its_place_and_nothing_is_drawn(serving: Serving, page: ClientConnection) -> None:
    text = SCRIPT.replace("    show wry", '    say "😀" show nothing\n    show wry')
    serving.script.write_text(text, "utf-8")
    told = until(page, lambda message: message["kind"] == "diagnostics" and bool(message["items"]))
    item = told[-1]["items"][0]
    assert item["severity"] == "error" and item["line"] == 9 and item["file"] == "script.face"
    wide = text.encode("utf-16-le")
    assert "show" in wide[2 * item["start"] : 2 * item["end"] + 8].decode("utf-16-le")
    assert not any(message["kind"] == "score" for message in told)
    versions(serving, page, SCRIPT)


def test_a_script_that_is_used_is_followed_too(serving: Serving, page: ClientConnection) -> None:
    parts = serving.script.with_name("parts.face")
    parts.write_text(PARTS.replace("60%", "smile"), "utf-8")
    items = until(page, lambda message: message["kind"] == "diagnostics" and bool(message["items"]))[-1]["items"]
    assert items[0]["file"] == "parts.face" and "start" not in items[0]
    parts.write_text(PARTS, "utf-8")
    until(page, lambda message: message["kind"] == "score")


def test_an_edit_of_the_page_is_written_and_taken_back(serving: Serving, page: ClientConnection) -> None:
    said(page, "undo")
    until(page, lambda message: message["kind"] == "refused")
    version = versions(serving, page, SCRIPT + "# end\n")[-1]["version"]
    at = SCRIPT.index("40%")
    said(page, "text", base=version, **{"from": at, "to": at + 2, "text": "55"})
    until(page, kind("score", version + 1))
    assert "smile 55%" in serving.script.read_text("utf-8")
    said(page, "text", base=version, **{"from": 0, "to": 0, "text": "nod\n"})
    refused = until(page, lambda message: message["kind"] == "refused")[-1]
    assert refused["what"] == "text" and "changed since" in refused["why"]
    said(page, "undo")
    edited = until(page, lambda message: message["kind"] == "edited")[-1]
    assert (edited["from"], edited["to"], edited["text"]) == (at, at + 2, "40")
    assert serving.script.read_text("utf-8") == SCRIPT + "# end\n"
    versions(serving, page, SCRIPT)


def test_curves_are_told_when_asked_for(page: ClientConnection) -> None:
    said(page, "curves", face="ada", channels=["cheek.lower.left", "nothing"])
    told = until(page, lambda message: message["kind"] == "curves")[-1]
    (channel,) = told["channels"]
    assert channel["name"] == "cheek.lower.left" and channel["most"] > 0.2 and channel["every"] <= 0.1


@pytest.mark.parametrize(
    "nonsense",
    [
        "{",
        "[]",
        "[" * 100_000,
        '{"kind": "text"}',
        '{"kind": "playhead", "time": "1", "playing": 1}',
        '{"kind": "playhead", "time": NaN, "playing": true}',
        '{"kind": "playhead", "time": 1e999, "playing": true}',
        b"\0",
    ],
)
def test_nonsense_is_passed_over(page: ClientConnection, nonsense: str | bytes) -> None:
    page.send(nonsense)
    until(page, lambda message: message["kind"] == "refused")
    said(page, "curves", face="nobody", channels=[])
    until(page, lambda message: message["kind"] == "curves")


# ------------------------------------------------------------------------------------------------ who is let in


def got(serving: Serving, path: str, **headers: str) -> tuple[int, bytes, dict[str, str]]:
    request = urllib.request.Request(serving.address.rstrip("/") + path, headers=headers)
    try:
        with urllib.request.urlopen(request, timeout=10) as answer:
            return answer.status, answer.read(), dict(answer.headers)
    except urllib.error.HTTPError as fault:
        return fault.code, fault.read(), dict(fault.headers)


def test_the_page_and_its_files_are_served_under_its_rule(serving: Serving) -> None:
    status, body, headers = got(serving, "/")
    assert status == 200 and b'id="face"' in body
    assert headers["Content-Security-Policy"].startswith("default-src 'none'; script-src 'self'")
    for path in ("/app.js", "/page.css", "/drawing.js"):
        assert got(serving, path)[0] == 200
    assert b"export { drawing }" in got(serving, "/drawing.js")[1]


@pytest.mark.parametrize(
    "path", ["/script.face", "/../server.py", "/%2e%2e/server.py", "//etc/passwd", "/sound/../x.wav"]
)
def test_no_other_file_is_served(serving: Serving, path: str) -> None:
    assert got(serving, path)[0] == 404


@pytest.mark.parametrize(
    "headers", [{"Host": "example.org"}, {"Host": "example.org:80"}, {"Origin": "http://example.org"}]
)
def test_strangers_are_refused(serving: Serving, headers: dict[str, str]) -> None:
    assert got(serving, "/", **headers)[0] == 403


@pytest.mark.parametrize("origin", ["http://example.org", "null", "http://127.0.0.1:1", "https://127.0.0.1"])
def test_a_foreign_page_gets_no_socket(serving: Serving, origin: str) -> None:
    with pytest.raises(InvalidStatus) as refused:
        serving.page(origin=origin)
    assert refused.value.response.status_code == 403


def test_it_listens_on_this_machine_alone(serving: Serving) -> None:
    found = socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)
    for address in {str(each[4][0]) for each in found} - {"127.0.0.1"}:
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection((address, serving.port), timeout=2)


def ended(page: ClientConnection, act: Callable[[], object]) -> int | None:
    """The code with which a page is ended for what it does."""
    with suppress(ConnectionClosed):
        act()
        until(page, lambda message: False)
    return page.close_code


def test_too_large_a_message_ends_a_page(serving: Serving) -> None:
    with serving.page() as other:
        assert ended(other, lambda: other.send("x" * (9 << 20))) == 1009


def test_a_flood_ends_a_page_and_no_other(serving: Serving, page: ClientConnection) -> None:
    with serving.page() as other:
        assert ended(other, lambda: [said(other, "playhead", time=0.1, playing=False) for _ in range(3_000)]) == 1008
    said(page, "curves", face="nobody", channels=[])
    until(page, lambda message: message["kind"] == "curves")


def test_there_is_room_for_a_few_pages(serving: Serving) -> None:
    with ExitStack() as pages:

        def come() -> None:
            for _ in range(9):
                pages.enter_context(serving.page())

        with pytest.raises(InvalidStatus) as refused:
            come()
    assert refused.value.response.status_code == 503
