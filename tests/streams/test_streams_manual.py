"""What the manual says of streams: its programs listen, and its sink is one."""

from __future__ import annotations

import asyncio
import contextlib
import io
import re
import sys
from pathlib import Path

import pytest
from chromium import Page, program
from streaming import layout, opened, smiling

from facescript.live.sinks.registry import KINDS
from facescript.live.sinks.ws import WebSocketSink

MANUAL = (Path(__file__).parents[2] / "docs" / "live.md").read_text("utf-8")


def titled(name: str) -> str:
    """A file that the manual shows."""
    found = re.search(rf'^```\w+ {{title="{re.escape(name)}"}}\n(.*?)^```$', MANUAL, re.MULTILINE | re.DOTALL)
    assert found is not None, name
    return found[1]


def test_the_manual_has_all_kinds_and_options() -> None:
    assert [kind.scheme for kind in KINDS if f"| `{kind.form.example.split(':')[0]}" not in MANUAL] == []
    assert [name for kind in KINDS for name in kind.form.options if f"| `{name}=" not in MANUAL] == []
    usual = {kind.form.port for kind in KINDS} - {None, 1883}
    assert [port for port in usual if f"({port})" not in MANUAL] == []


async def test_the_program_in_python_listens() -> None:
    of, told = layout(), io.StringIO()
    async with opened("ws://127.0.0.1:0", of) as sink:
        assert isinstance(sink, WebSocketSink)
        code = titled("listen.py").replace("8765", str(sink.port))
        with contextlib.redirect_stdout(told):
            listening = asyncio.create_task(asyncio.to_thread(exec, code, {}))
            while not sink.counts()["clients"]:
                await asyncio.sleep(0.005)
            sink.frame(smiling(30, of))
            while not told.getvalue():
                await asyncio.sleep(0.005)
    await listening
    assert told.getvalue() == "0.5 3.0 0.0\n"


@pytest.mark.skipif(program() is None, reason="Chromium is not here")
async def test_the_program_of_a_page_gets_frames() -> None:
    of = layout()
    async with opened("ws://127.0.0.1:0", of) as sink:
        assert isinstance(sink, WebSocketSink)
        sink.frame(smiling(30, of))
        code = titled("listen.js").replace("8765", str(sink.port))
        found = await asyncio.to_thread(_shown, f"http://127.0.0.1:{sink.port}/", code)
    assert found == [0.5, 3.0]


def _shown(address: str, code: str) -> object:
    """What a page that runs the code is given to show."""
    with Page(address) as page:
        return page.run(f"new Promise(done => {{ const show = (...shown) => done(shown);\n{code}\n}})")


async def test_the_sink_of_the_manual_is_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    told = tmp_path / "lamp-1.0.dist-info"
    told.mkdir()
    (told / "METADATA").write_text("Name: lamp\nVersion: 1.0\n")
    (told / "entry_points.txt").write_text("[facescript.sinks]\nlamp = lamp:Lamp\n")
    (tmp_path / "lamp.py").write_text(titled("lamp.py"))
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "lamp", raising=False)
    of = layout()
    async with opened(f"lamp:{tmp_path}/device", of) as sink:
        for number in (0, 50, 200):
            sink.frame(smiling(number, of))
    assert (tmp_path / "device").read_bytes() == bytes([0, 128, 255])
