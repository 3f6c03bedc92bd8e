"""The same work on many things to processes that share it, where the system can fork them."""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Callable, Sequence
from multiprocessing.connection import Connection
from typing import TypeVar

from facescript.backends.job import JobFailure

T = TypeVar("T")
Made = TypeVar("Made")


def spread(things: Sequence[T], work: Callable[[T], Made], jobs: int) -> list[Made]:
    """What `work` makes of each thing, in order, done by `jobs` processes. Raises `JobFailure` where one ends."""
    workers = min(jobs, len(things))
    if workers < 2 or sys.platform != "linux":
        return [work(thing) for thing in things]
    fork = multiprocessing.get_context("fork")
    links = []
    for number in range(1, workers):
        near, far = fork.Pipe(duplex=False)
        process = fork.Process(target=_work, args=(things[number::workers], work, far), daemon=True)
        process.start()
        far.close()
        links.append((near, process))
    shares = [[work(thing) for thing in things[::workers]]]
    for near, process in links:
        try:
            shares.append(near.recv())
        except EOFError:
            raise JobFailure("a process that draws has ended") from None
        process.join()
    return [shares[number % workers][number // workers] for number in range(len(things))]


def _work(things: Sequence[T], work: Callable[[T], Made], link: Connection) -> None:
    link.send([work(thing) for thing in things])
