"""10,000 events a second into a run over WebSocket, OSC and standard input: its frames go on."""

from __future__ import annotations

import re
import socket
import struct
import threading
import time
from collections.abc import Callable, Iterator

from _running import Running
from row import Row
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

SECONDS = 5.0
RATE = 10_000
"""Events a second."""

STALL = 250.0
"""ms by which a frame may be late: more is a stall."""

SAYINGS = ('{"heard": "no"}', '{"touched": "start"}', '{"signal": "nobody"}', "nonsense", '{"key": "q"}')


def rows() -> Iterator[Row]:
    yield _row("no events", [], None)
    yield _row("10,000 a second over WebSocket", ["--from", "ws://127.0.0.1:0"], _websocket)
    yield _row("10,000 a second over OSC", ["--from", "osc://127.0.0.1:0"], _osc)
    yield _row("10,000 a second over standard input", ["--from", "stdin:"], _stdin)


def _row(what: str, words: list[str], flood: Callable[[Running, threading.Event], None] | None) -> Row:
    ended = threading.Event()
    with Running(SECONDS, "--to", "csv:run.csv", *words) as run:
        flooding = threading.Thread(target=flood, args=(run, ended)) if flood else None
        if flooding is not None:
            flooding.start()
        found = run.end()
        ended.set()
        if flooding is not None:
            flooding.join()
        sent = re.search(r"(\d+) messages", "\n".join(run.said))
        events = next((line for line in run.said if line.startswith("events:")), "")
    told = f"{found}, {found.spent:.1f} s of processor time"
    told += f"; {int(sent[1]) / SECONDS:.0f} messages a second; {events}" if sent and flood else ""
    return Row(f"flood, {what}, {SECONDS:.0f} s", f"all frames within {STALL:.0f} ms", told, found.all <= STALL)


def _paced(send: Callable[[int], None], ended: threading.Event) -> None:
    """Sends in bursts of a hundredth of a second."""
    began, count = time.monotonic(), 0
    while not ended.is_set():
        due = int((time.monotonic() - began) * RATE)
        try:
            while count < due:
                send(count)
                count += 1
        except (OSError, ValueError, ConnectionClosed):
            return
        time.sleep(0.01)


def _websocket(run: Running, ended: threading.Event) -> None:
    place = run.wait("listens at").split()[-1].rstrip(".")
    with connect(place, compression=None, max_queue=None) as client:
        _paced(lambda count: client.send(SAYINGS[count % len(SAYINGS)]), ended)


def _osc(run: Running, ended: threading.Event) -> None:
    port = int(run.wait("listens at").rstrip(".").rpartition(":")[2])
    client = socket.socket(type=socket.SOCK_DGRAM)
    packets = [b"/facescript/heard\0\0\0,s\0\0no\0\0", b"/facescript/key\0,s\0\0q\0\0\0", struct.pack(">I", 7) * 9]
    _paced(lambda count: client.sendto(packets[count % len(packets)], ("127.0.0.1", port)) and None, ended)


def _stdin(run: Running, ended: threading.Event) -> None:
    assert run.process.stdin is not None
    stream = run.process.stdin
    _paced(lambda count: stream.write(f"{SAYINGS[count % len(SAYINGS)]}\n") and None, ended)
