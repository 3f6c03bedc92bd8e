"""A run on the real clock with an event a second: no drift against the clock, no growth of memory. A minute; with
SOAK_MINUTES=10 (`make soak`) ten."""

from __future__ import annotations

import json
import os
import re
import socket
import threading
import time
from collections.abc import Iterator
from pathlib import Path

from _running import Running
from row import Row

MINUTES = float(os.environ.get("SOAK_MINUTES", "1"))

DRIFT = 1.0
"""ms between the clock of the run and this program's, from the first tenth of the run to the last."""

GROWTH, SETTLED = 1.0, 5.0
"""MB a minute, after the first fifth of the run; held to it in runs of so many minutes. In the first two minutes what
is kept of a script comes to its size."""

NUMBER = re.compile(rb'"number":\s*(\d+)')

EVENTS = ("heard no", "touched start", "key q", "arrives ann 40cm 0cm 90cm", "leaves ann")


def rows() -> Iterator[Row]:
    seconds = 60.0 * MINUTES
    with socket.socket(type=socket.SOCK_DGRAM) as ear:
        ear.bind(("127.0.0.1", 0))
        ear.settimeout(1.0)
        to = f"udp-json://127.0.0.1:{ear.getsockname()[1]}"
        with Running(seconds, "--from", "stdin:", "--to", to) as run:
            threading.Thread(target=_tell, args=(run,), daemon=True).start()
            offsets, sizes = _watched(ear, run)
            ended = run.end()
    what = f"soak, {MINUTES:g} min, an event a second"
    drift = 1000 * abs(_least(offsets, 0.9, 1.0) - _least(offsets, 0.0, 0.1))
    yield Row(f"{what}: drift against the clock", f"{DRIFT:g} ms", f"{drift:.2f} ms", drift <= DRIFT)
    growth = (_middle(sizes, 0.8, 1.0) - _middle(sizes, 0.2, 0.4)) / (0.6 * MINUTES)
    found = f"{growth:.2f} MB a minute, {sizes[-1]:.0f} MB at the end"
    bar = f"{GROWTH:g} MB a minute" if MINUTES >= SETTLED else ""
    yield Row(f"{what}: growth of memory", bar, found, growth <= GROWTH if bar else None)
    each = 1000 * ended.spent / (ended.frames + ended.dropped)
    yield Row(f"{what}: frames", "", f"{ended}; {each:.2f} ms of processor time each", None)


def _tell(run: Running) -> None:
    assert run.process.stdin is not None
    count = 0
    while not run.ended.is_set():
        try:
            run.process.stdin.write(EVENTS[count % len(EVENTS)] + "\n")
            run.process.stdin.flush()
        except OSError:
            return
        count += 1
        time.sleep(1.0)


def _watched(ear: socket.socket, run: Running) -> tuple[list[float], list[float]]:
    """Of each frame, by how many seconds it came after its time, but for a constant; the sizes of the process, MB."""
    offsets, sizes = list[float](), list[float]()
    while not run.ended.is_set():
        try:
            data = ear.recv(65_536)
        except TimeoutError:
            continue
        found = NUMBER.search(data)
        if found is None or json.loads(data).get("type") != "frame":
            continue
        offsets.append(time.monotonic() - int(found[1]) / 60.0)
        if len(offsets) % 60 == 0:
            sizes.append(_size(run.process.pid))
    return offsets, sizes


def _size(pid: int) -> float:
    """MB of a process in memory."""
    status = Path(f"/proc/{pid}/status").read_text()
    found = re.search(r"VmRSS:\s+(\d+)", status)
    return int(found[1]) / 1024 if found else 0.0


def _least(values: list[float], first: float, last: float) -> float:
    """The least in a part of a list: what frames took that nothing held up."""
    return min(values[int(first * len(values)) : int(last * len(values))])


def _middle(values: list[float], first: float, last: float) -> float:
    part = sorted(values[int(first * len(values)) : int(last * len(values))])
    return part[len(part) // 2]
