"""60 frames a second to 100 WebSocket clients in a second process, for `MINUTES` (10, if nothing is set), and with one
among them that stops reading.
"""

from __future__ import annotations

import asyncio
import gc
import json
import os
import socket
import sys
import time
from asyncio.subprocess import PIPE, Process
from collections.abc import Iterator
from pathlib import Path

from _sending import layout, sent
from row import Row

from facescript.live.ports import Ports
from facescript.live.sinks.registry import open_sink
from facescript.live.sinks.setting import Setting
from facescript.live.sinks.ws import WebSocketSink

MINUTES = float(os.environ.get("MINUTES", "10"))
CLIENTS = 100
GAP = 25.0
"""ms between two frames at a client, 99 in 100 of them at most."""

SHARE = 0.25
"""Of a core."""

STALLED, FACES = 12.0, 8
"""Seconds with a client that does not read, before it is taken as gone; so many faces that they soon fill its way."""

HEAD = (
    "GET /json HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)


def rows() -> Iterator[Row]:
    yield from asyncio.run(_all())
    yield from asyncio.run(_one_stalls())


async def _opened(faces: int) -> tuple[WebSocketSink, Ports]:
    setting = Setting()
    sink = open_sink("ws://127.0.0.1:0", setting)
    assert isinstance(sink, WebSocketSink)
    await setting.ports.open()
    await sink.open(layout(faces))
    return sink, setting.ports


async def _come(sink: WebSocketSink, many: int) -> Process:
    """Clients, once all are there."""
    words = [str(Path(__file__).with_name("_clients.py")), f"ws://127.0.0.1:{sink.port}/binary", str(many)]
    process = await asyncio.create_subprocess_exec(sys.executable, *words, stdout=PIPE, limit=1 << 20)
    assert process.stdout is not None and await process.stdout.readline() == b"ready\n"
    gc.collect()
    gc.freeze()
    return process


async def _all() -> list[Row]:
    sink, ports = await _opened(1)
    clients = await _come(sink, CLIENTS)
    seconds = MINUTES * 60
    used, began = time.process_time(), time.perf_counter()
    tally = await sent(sink, layout(), seconds)
    share = (time.process_time() - used) / (time.perf_counter() - began)
    await ports.close()
    found = json.loads((await clients.communicate())[0])
    what = f"60 fps to {CLIENTS} WebSocket clients for {MINUTES:g} min"
    few = min(found["frames"]), max(found["frames"])
    lost = found["lost"] + sink.counts()["dropped"] + tally.frames * CLIENTS - sum(found["frames"])
    middle, late, latest = found["gaps"]
    made = f"{lost} of {sum(found['frames']) + lost} ({few[0]} to {few[1]} a client; {tally.dropped} not made in time)"
    gaps = f"{middle:.1f} ms p50, {late:.1f} ms p99, {latest:.0f} ms at most"
    return [
        Row(f"{what}: lost", "none", made, lost == 0),
        Row(f"{what}: between two frames at a client", f"p99 {GAP:g} ms", gaps, late <= GAP),
        Row(f"{what}: processor", f"{SHARE:g} of a core", f"{share:.3f} of a core", share <= SHARE),
        Row("ticks late", "", f"p99 {tally.lateness(0.01) * 1000:.1f} ms", None),
        Row("processor that the clients take", "", f"{found['used']:.3f} of a core", None),
    ]


async def _one_stalls() -> list[Row]:
    """A client that reads its head and no more, among others."""
    sink, ports = await _opened(FACES)
    clients = await _come(sink, CLIENTS - 1)
    lazy = socket.create_connection(("127.0.0.1", sink.port))
    lazy.sendall(HEAD.format(port=sink.port).encode())
    while sink.counts()["clients"] < CLIENTS:
        await asyncio.sleep(0.01)
    tally = await sent(sink, layout(FACES), STALLED)
    waits = max(client.waiting for client in sink._clients)
    dropped = sink.counts()["dropped"]
    newest, more = await _read_on(lazy, sink)
    await ports.close()
    found = json.loads((await clients.communicate())[0])
    what = f"a client that reads nothing for {STALLED:g} s, {CLIENTS - 1} others, {FACES} faces"
    _, late, latest = found["gaps"]
    lost = (tally.frames + more) * (CLIENTS - 1) - sum(found["frames"])
    told = f"p99 {late:.1f} ms, {latest:.0f} ms at most, {lost} lost"
    return [
        Row(f"{what}: between two frames at the others", f"p99 {GAP:g} ms", told, late <= GAP and lost == 0),
        Row(f"{what}: waits for it", "64 kB", f"{waits} bytes; {dropped} frames dropped for it", waits <= 1 << 16),
        Row(f"{what}: when it reads again", "the newest frame", newest, newest == "the newest frame"),
    ]


async def _read_on(lazy: socket.socket, sink: WebSocketSink) -> tuple[str, int]:
    """Reads what is there, while the run goes on for a second of so many frames."""
    lazy.setblocking(False)
    loop, text = asyncio.get_running_loop(), b""

    async def read() -> None:
        nonlocal text
        while part := await loop.sock_recv(lazy, 1 << 16):
            text = text[-65_536:] + part

    reading = asyncio.create_task(read())
    frames = (await sent(sink, layout(FACES), 1.0)).frames
    await asyncio.sleep(0.2)
    reading.cancel()
    lazy.close()
    got = int(text[text.rindex(b'"number":') + 9 :].split(b",")[0])
    return "the newest frame" if got == frames - 1 else f"frame {got} of {frames}", frames
