"""A run to a page in a browser: a WebSocket in Chromium gets layout and frames."""

from __future__ import annotations

import asyncio

import pytest
from chromium import Page, program
from streaming import layout, opened, smiling

from facescript.live.sinks.ws import WebSocketSink

pytestmark = pytest.mark.skipif(program() is None, reason="Chromium is not here")

LISTEN = """
new Promise((done, failed) => {
  const socket = new WebSocket("ws://" + location.host + "/binary");
  socket.binaryType = "arraybuffer";
  let layout;
  socket.onerror = () => failed(new Error("refused"));
  socket.onmessage = ({ data }) => {
    if (typeof data === "string") { layout = JSON.parse(data); return; }
    const head = new DataView(data), values = new Float32Array(data, 16);
    const at = name => values[layout.channels.findIndex(channel => channel.name === name)];
    done([head.getUint32(8, true), head.getFloat64(0, true), at("cheek.lower.left"), at("head.yaw"), values.length]);
  };
})
"""


async def test_a_page_gets_frames_by_name() -> None:
    of = layout()
    async with opened("ws://127.0.0.1:0", of) as sink:
        assert isinstance(sink, WebSocketSink)
        sink.frame(smiling(30, of))
        found = await asyncio.to_thread(_listen, f"http://127.0.0.1:{sink.port}/")
    assert found == [30, 0.5, pytest.approx(0.3), 3.0, len(of.names)]


def _listen(address: str) -> object:
    with Page(address) as page:
        return page.run(LISTEN)
