"""Work that blocks to a task that can be cancelled: in a thread of its own, which does not hold up the end."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable

Work = Callable[[threading.Event], None]
"""Works until it is done or the event is set."""


async def in_thread(work: Work, name: str) -> None:
    """Waits for the work; when it is cancelled, the work is told to stop. Raises what the work raises."""
    loop, stop = asyncio.get_running_loop(), threading.Event()
    done: asyncio.Future[None] = loop.create_future()

    def settle(fault: BaseException | None) -> None:
        if done.done():
            return
        if fault is None:
            done.set_result(None)
        else:
            done.set_exception(fault)

    def body() -> None:
        fault: BaseException | None = None
        try:
            work(stop)
        except Exception as raised:  # it is raised where the work is waited for
            fault = raised
        if not loop.is_closed():
            loop.call_soon_threadsafe(settle, fault)

    threading.Thread(target=body, name=name, daemon=True).start()
    try:
        await done
    finally:
        stop.set()
