"""A run to WebSockets: real clients that read, do not read, lie, flood, are strange, or are gone."""

from __future__ import annotations

import asyncio
import json
import socket
import struct
import sys
from collections.abc import AsyncIterator
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from streaming import HELLO, Told, frame, layout, line, opened, smiling
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from facescript.live import port as ports
from facescript.live.address import AddressFault
from facescript.live.model import Layout, Mark
from facescript.live.sinks import ws
from facescript.live.sinks.ws import WebSocketSink

ANY = "ws://127.0.0.1:0"
TICK = 0.002


@pytest.fixture
async def sink() -> AsyncIterator[WebSocketSink]:
    async with opened(ANY, layout()) as found:
        assert isinstance(found, WebSocketSink)
        yield found


@pytest.fixture
def hasty(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pings come at once, and little is waited for."""
    for name, seconds in (("PING", 0.05), ("LOST", 0.1), ("CLOSING", 0.05)):
        monkeypatch.setattr(ports, name, seconds)


def at(sink: WebSocketSink, path: str = "/") -> str:
    return f"ws://127.0.0.1:{sink.port}{path}"


async def until(sink: WebSocketSink, clients: int) -> None:
    """Waits until so many have come."""
    while sink.counts()["clients"] < clients:
        await asyncio.sleep(0.001)


async def test_the_layout_comes_first_then_frames(sink: WebSocketSink) -> None:
    async with connect(at(sink), proxy=None) as client:
        told = json.loads(await client.recv())
        sink.frame(smiling(50, layout()))
        shown = json.loads(await client.recv())
    assert (told["type"], told["version"], told["title"]) == ("layout", 1, "kiosk.face")
    names = [channel["name"] for channel in told["channels"]]
    values = dict(zip(names, shown["values"], strict=True))
    assert (shown["number"], shown["time"]) == (50, 0.833333)
    assert (values["cheek.lower.left"], values["head.yaw"], values["head.scale"]) == (0.5, 5.0, 1.0)


async def test_frames_are_packed_for_who_asks(sink: WebSocketSink) -> None:
    async with connect(at(sink, "/binary"), proxy=None) as one, connect(at(sink), proxy=None) as other:
        await other.send('{"format": "binary"}')
        await one.recv(), await other.recv()
        await asyncio.sleep(0.02)
        sink.frame(smiling(50, layout()))
        first, second = await one.recv(), await other.recv()
    assert isinstance(first, bytes) and first == second
    assert struct.unpack("<dII", first[:16]) == (50 / 60, 50, len(layout().names))
    assert np.array_equal(np.frombuffer(first[16:], "<f4"), smiling(50, layout()).values.astype(np.float32))


async def test_who_comes_late_sees_what_is_true_now(sink: WebSocketSink) -> None:
    sink.frame(smiling(7, layout()))
    async with connect(at(sink), proxy=None) as client:
        await client.recv()
        assert json.loads(await asyncio.wait_for(client.recv(), 2))["number"] == 7


async def test_marks_and_lines_are_told(sink: WebSocketSink) -> None:
    async with connect(at(sink, "/binary"), proxy=None) as client:
        await client.recv()
        sink.mark(HELLO)
        sink.utter(line())
        told = [json.loads(await client.recv()) for _ in range(2)]
    assert [one["type"] for one in told] == ["mark", "utterance"]
    assert (told[0]["text"], told[1]["start"]) == ("Hello", 1.0)


async def test_who_stops_reading_costs_the_others_nothing() -> None:
    of = layout(*(f"face{number}" for number in range(8)))
    async with opened(ANY, of) as sink:
        assert isinstance(sink, WebSocketSink)
        lazy = await _lazy(sink)
        async with connect(at(sink, "/binary"), proxy=None) as eager:
            await eager.recv()
            await until(sink, 2)
            most = 0
            for number in range(600):
                sink.frame(smiling(number, of))
                assert struct.unpack("<dII", (await eager.recv())[:16])[1] == number  # type: ignore[arg-type]
                most = max(most, *(client.waiting for client in sink._clients))
            assert sink.counts()["dropped"] > 300
            assert most < 16_000, "no more than one message waits"
            seen = await _returns(lazy, sink, of)
    assert seen == 600, "and then it gets the newest"


async def test_who_misses_too_much_that_is_said_once_has_to_come_again() -> None:
    async with opened(ANY, layout()) as sink:
        assert isinstance(sink, WebSocketSink)
        lazy = await _lazy(sink)
        long = Mark("line", 0.0, "x" * 10_000)
        async with asyncio.timeout(5):
            while sink._clients:
                sink.mark(long)
                assert all(client.waiting <= ws.BEHIND for client in sink._clients)
                await asyncio.sleep(0)
        assert sink.counts()["dropped"] >= 1
        lazy.close()


async def _lazy(sink: WebSocketSink) -> socket.socket:
    """A client that has come, and reads no more."""
    lazy = socket.socket()
    lazy.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    lazy.connect(("127.0.0.1", sink.port))
    head = f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{sink.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    lazy.send(f"{head}Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
    await until(sink, 1)
    return lazy


async def _returns(lazy: socket.socket, sink: WebSocketSink, of: Layout) -> int:
    """Reads all that is there, then one frame more: its number."""
    lazy.setblocking(False)
    text = b""
    loop = asyncio.get_running_loop()
    while any(client.waiting for client in sink._clients):
        text += await loop.sock_recv(lazy, 1 << 16)
    sink.frame(smiling(600, of))
    while b'"number":600' not in text[-20_000:]:
        text += await asyncio.wait_for(loop.sock_recv(lazy, 1 << 16), 2)
    lazy.close()
    last = text.rindex(b'"number":')
    return int(text[last + 9 :].split(b",")[0])


async def test_strangers_are_refused(sink: WebSocketSink) -> None:
    for headers in ({"Origin": "https://example.org"}, {"Origin": "null"}, {"Host": "example.org"}):
        with pytest.raises(InvalidStatus) as refused:
            async with connect(at(sink), additional_headers=headers, proxy=None):
                pass
        assert refused.value.response.status_code == 403, headers
    with pytest.raises(InvalidStatus) as refused:
        async with connect(at(sink, "/etc/passwd"), proxy=None):
            pass
    assert refused.value.response.status_code == 404
    async with connect(at(sink), additional_headers={"Origin": f"http://localhost:{sink.port}"}, proxy=None) as client:
        await client.recv()


async def test_other_machines_need_a_token() -> None:
    with pytest.raises(AddressFault) as fault:
        async with opened("ws://0.0.0.0:0", layout()):
            pass
    assert fault.value.code == "FS983"


async def test_a_token_opens_the_door_and_nothing_else_does() -> None:
    async with opened("ws://0.0.0.0:0", layout(), Told().setting("let me in")) as sink:
        assert isinstance(sink, WebSocketSink)
        for path in ("/", "/?token=", "/?token=let%20me%20out"):
            with pytest.raises(InvalidStatus):
                async with connect(at(sink, path), proxy=None):
                    pass
        async with connect(at(sink, "/?token=let%20me%20in"), proxy=None) as client:
            await client.recv()
        known = {"Authorization": "Bearer let me in", "Origin": "https://example.org"}
        async with connect(at(sink), additional_headers=known, proxy=None) as client:
            await client.recv()


LIES = {
    "unmasked": b"\x81\x05hello",
    "long": b"\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0",
    "reserved": b"\xf1\x80\0\0\0\0",
    "no text": b"\x81\x81\0\0\0\0\xff",
    "no frame": b"GET / HTTP/1.1\r\n" * 10,
}


@pytest.mark.parametrize("lie", LIES)
async def test_who_lies_about_frames_is_sent_away(hasty: None, sink: WebSocketSink, lie: str) -> None:
    liar = await _lazy(sink)
    async with connect(at(sink), proxy=None) as client:
        await client.recv()
        liar.setblocking(False)
        await asyncio.get_running_loop().sock_sendall(liar, LIES[lie])
        async with asyncio.timeout(3):
            while len(sink._clients) > 1:
                await asyncio.sleep(TICK)
        sink.frame(smiling(1, layout()))
        assert json.loads(await client.recv())["number"] == 1
    liar.close()


async def test_who_says_too_much_is_sent_away(sink: WebSocketSink) -> None:
    async with connect(at(sink), proxy=None) as client:
        await client.recv()
        with pytest.raises(ConnectionClosed) as closed:  # noqa: PT012 - which of the messages is one too many, is no matter
            for _ in range(1000):
                await client.send("more")
            while True:
                await client.recv()
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1008
    assert sink.counts()["refused"] == ws.MOST_SAID


async def test_who_is_gone_without_a_word_is_found(hasty: None, sink: WebSocketSink) -> None:
    gone = await _lazy(sink)  # it answers no ping
    async with connect(at(sink), proxy=None):
        await until(sink, 2)
        async with asyncio.timeout(3):
            while len(sink._clients) > 1:
                await asyncio.sleep(TICK)
    gone.close()


async def test_no_more_come_than_there_is_room_for(monkeypatch: pytest.MonkeyPatch, sink: WebSocketSink) -> None:
    monkeypatch.setattr(ports, "MOST", 1)
    async with connect(at(sink), proxy=None) as client:
        await client.recv()
        with pytest.raises(InvalidStatus) as refused:
            async with connect(at(sink), proxy=None):
                pass
    assert refused.value.response.status_code == 503


async def test_a_port_that_is_taken_is_said() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(AddressFault) as fault:
            async with opened(f"ws://127.0.0.1:{taken.getsockname()[1]}", layout()):
                pass
    assert (fault.value.code, fault.value.values["reason"]) == ("FS982", "the port is in use by another program")


async def test_all_is_counted(sink: WebSocketSink) -> None:
    async with connect(at(sink), proxy=None) as client:
        await client.recv()
        for number in range(5):
            sink.frame(frame(number, layout()))
        for _ in range(5):
            await client.recv()
    assert sink.counts() == {"sent": 5, "dropped": 0, "clients": 1, "refused": 0}


async def test_events_come_in_where_the_stream_goes_out(tmp_path: Path) -> None:
    (tmp_path / "no.face").write_text('face ada = woman\n\nwhen heard "no":\n    nod as denied\n')
    at = f"ws://127.0.0.1:{free_port()}"
    words = [sys.executable, "-m", "facescript.cli.main", "live", "no.face", "--from", at, "--to", at, "--for", "20s"]
    process = await asyncio.create_subprocess_exec(*words, cwd=tmp_path, stderr=asyncio.subprocess.DEVNULL)
    async with asyncio.timeout(15):
        while True:
            with suppress(OSError):
                async with connect(f"{at}/json", proxy=None) as stream, connect(f"{at}/events", proxy=None) as events:
                    await events.send("heard no")
                    async for text in stream:
                        if json.loads(text).get("label") == "when.1.denied":
                            break
                break
            await asyncio.sleep(0.05)
    process.terminate()
    assert await process.wait() == 0


def free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])
