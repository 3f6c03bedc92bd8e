"""Listens to a stream as many WebSocket clients: `python _clients.py ADDRESS CLIENTS`; prints what came, as JSON."""

from __future__ import annotations

import asyncio
import gc
import json
import struct
import sys
import time
from array import array

import numpy as np
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed

HEAD = struct.Struct("<dII")


async def listen(address: str, numbers: array[int], times: array[float], ready: asyncio.Semaphore) -> None:
    """Keeps the number of each frame and when it came."""
    async with connect(address, compression=None, proxy=None, ping_interval=None) as client:
        await client.recv()
        ready.release()
        try:
            while True:
                frame = await client.recv()
                times.append(time.perf_counter())
                numbers.append(HEAD.unpack_from(frame)[1])  # type: ignore[arg-type]
        except ConnectionClosed:
            pass


async def main(address: str, clients: int) -> None:
    numbers = [array("I") for _ in range(clients)]
    times = [array("d") for _ in range(clients)]
    ready = asyncio.Semaphore(0)
    tasks = [asyncio.create_task(listen(address, *kept, ready)) for kept in zip(numbers, times, strict=True)]
    for _ in range(clients):
        await ready.acquire()
    gc.disable()  # its pauses would be taken for the stream's
    print("ready", flush=True)
    await asyncio.gather(*tasks)
    gaps = np.concatenate([np.diff(np.array(one)) for one in times]) * 1000
    lost = sum(int(one[-1] - one[0]) + 1 - len(one) if one else 0 for one in numbers)
    used = time.process_time() / (max(one[-1] for one in times) - min(one[0] for one in times))
    found = {"used": used, "frames": [len(one) for one in numbers], "lost": lost, "last": [one[-1] for one in numbers]}
    print(json.dumps({**found, "gaps": [float(np.percentile(gaps, part)) for part in (50, 99, 100)]}), flush=True)


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1], int(sys.argv[2])))
