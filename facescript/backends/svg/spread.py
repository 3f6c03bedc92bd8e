"""The same work on many things to processes that share it, where the system can fork them."""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.context import ForkProcess
from typing import TypeVar

from facescript.backends.job import JobFailure

T = TypeVar("T")
Made = TypeVar("Made")


def spread(things: Sequence[T], work: Callable[[T], Made], jobs: int) -> list[Made]:
    """What `work` makes of each thing, in order, done by `jobs` processes: this one, and others that end with the call.
    Raises `JobFailure` where one of them ends sooner."""
    workers = min(jobs, len(things))
    if workers < 2 or sys.platform != "linux":
        return [work(thing) for thing in things]
    team: list[tuple[Connection, ForkProcess]] = []
    for number in range(1, workers):
        team.append(_started(things[number::workers], work, [link for link, _ in team]))
    try:
        shares = [[work(thing) for thing in things[::workers]], *(link.recv() for link, _ in team)]
    except EOFError:
        raise JobFailure("a process that draws has ended") from None
    finally:
        for link, process in team:
            process.kill()
            process.join()
            link.close()
    return [shares[number % workers][number // workers] for number in range(len(things))]


def _started(
    things: Sequence[T], work: Callable[[T], Made], links: Sequence[Connection]
) -> tuple[Connection, ForkProcess]:
    """A process at its share of the work, and where it sends what it has made; `links` are those of the others."""
    fork = multiprocessing.get_context("fork")
    near, far = fork.Pipe(duplex=False)
    process = fork.Process(target=_work, args=(things, work, far, [*links, near]), daemon=True)
    process.start()
    far.close()
    return near, process


def _work(things: Sequence[T], work: Callable[[T], Made], link: Connection, ends: Sequence[Connection]) -> None:
    """A process's whole work. An interrupt ends it without a word: its parent is interrupted too, and tells. The
    parent's `ends` of all links are let go: else it would wait for ever for a parent that was killed."""
    for end in ends:
        end.close()
    with suppress(OSError, KeyboardInterrupt):
        link.send([work(thing) for thing in things])
