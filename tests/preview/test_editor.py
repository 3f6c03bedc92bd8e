"""`facescript preview --editor`: the script as an editor has it, to a page that only who has its key may frame."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

import pytest
from websockets.asyncio.client import connect
from websockets.typing import Origin

from facescript.preview.borrowed import Borrowed
from facescript.preview.editor import Editor, understood
from facescript.preview.paper import Edit, Refusal


@pytest.fixture
def running(tmp_path: Path) -> Iterator[subprocess.Popen[bytes]]:
    (tmp_path / "a.face").write_text("nod\n", "utf-8")
    command = [sys.executable, "-P", "-m", "facescript.cli.main", "preview", "a.face", "--editor"]
    process = subprocess.Popen(command, cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    yield process
    process.kill()
    process.wait()


def test_its_page_has_a_key_and_it_ends_with_its_editor(running: subprocess.Popen[bytes]) -> None:
    assert running.stdin is not None and running.stdout is not None
    address = json.loads(running.stdout.readline())["url"]
    with urllib.request.urlopen(address) as answer:
        assert "frame-ancestors" not in answer.headers["Content-Security-Policy"]
    origin, key = address[:-1].rsplit("/", 1)
    for wrong in ("", key, f"{key}x/", "app.js", "live"):
        with pytest.raises(urllib.error.HTTPError, match="403"):
            urllib.request.urlopen(f"{origin}/{wrong}")
    host, port = origin.removeprefix("http://").split(":")
    for odd in (b"*", b"nothing", b"//["):
        with socket.create_connection((host, int(port)), 10) as rough:
            rough.sendall(b"GET " + odd + b" HTTP/1.1\r\nHost: x\r\n\r\n")
            assert rough.recv(64).startswith(b"HTTP/1.1 403")
    running.stdin.close()
    assert running.wait(60) == 0
    running.stdout.close()


@pytest.mark.asyncio
async def test_an_editor_elsewhere_reaches_it_by_a_host_of_its_own(running: subprocess.Popen[bytes]) -> None:
    assert running.stdout is not None
    address = json.loads(running.stdout.readline())["url"]
    elsewhere = {"Host": "desk.example"}
    with urllib.request.urlopen(urllib.request.Request(address, headers=elsewhere)) as answer:
        assert b"app.js" in answer.read()
    live = address.replace("http", "ws") + "live"
    async with connect(live, origin=Origin("https://desk.example"), additional_headers=elsewhere) as page:
        assert json.loads(await page.recv())["kind"]


def test_an_edit_is_asked_of_the_editor_for_the_text_that_it_sent() -> None:
    out = BytesIO()
    borrowed = Borrowed(Editor(BytesIO(), out), "nod\n")
    assert borrowed.writable and borrowed.hear({"kind": "text", "version": 12, "text": "\U0001f600 nod\r\nblink"})
    assert borrowed.text == "\U0001f600 nod\nblink" and borrowed.version == 2
    borrowed.edit(2, Edit(3, 6, "shake"))
    assert json.loads(out.getvalue()) == {"kind": "edit", "version": 12, "from": 3, "to": 6, "text": "shake"}
    assert borrowed.text.endswith("nod\nblink"), "it is as it was until the editor says so"
    assert borrowed.line(4) == (0, 6) and borrowed.line(9) == (7, 12)
    for base, edit in ((1, Edit(3, 6, "")), (2, Edit(3, 60, "")), (2, Edit(6, 3, ""))):
        with pytest.raises(Refusal):
            borrowed.edit(base, edit)
    with pytest.raises(Refusal, match="undo it in the editor"):
        borrowed.undo()


def test_what_is_no_message_is_passed_over() -> None:
    for line in (
        b"",
        b"nonsense",
        b"[]",
        b'{"kind": "text"}',
        b'{"kind": "caret", "offset": "1"}',
        b"[" * 9999,
        b"\xff",
    ):
        assert understood(line) is None
    assert understood(b'{"kind": "caret", "offset": 1, "more": 2}') == {"kind": "caret", "offset": 1}
