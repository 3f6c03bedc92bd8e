"""A process that makes what the page is told: texts and questions in, messages out; the server never waits for it."""

from __future__ import annotations

import gc
import json
import multiprocessing
import os
import signal
import traceback
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from threading import Condition, Thread

from facescript.web.messages import Message

COLLECT = 100_000
"""New objects between two looks for rubbish, as in `cli/main.py`."""

WAITING = 200
"""Messages that wait for the process; the oldest are dropped."""

LATEST = ("text", "playhead")
"""Kinds of which only the latest matters."""


class Workshop:
    """The process, which works for the script `name` of the project in `root`. `hear` is called with each message it
    makes, in a thread of the workshop's own; `ended` when the process is gone."""

    def __init__(
        self, root: Path, name: str, folder: Path, hear: Callable[[bytes], None], ended: Callable[[], None]
    ) -> None:
        context = multiprocessing.get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=work, args=(theirs, root, name, folder), daemon=True)
        self._process.start()
        theirs.close()
        self._hear, self._ended = hear, ended
        self._waiting: deque[Message] = deque(maxlen=WAITING)
        self._changed, self._closed = Condition(), False
        for act in (self._listen, self._speak):
            Thread(target=act, daemon=True).start()

    def tell(self, message: Message) -> None:
        """Hands over a message; never waits."""
        with self._changed:
            if message["kind"] in LATEST:
                for other in [other for other in self._waiting if other["kind"] == message["kind"]]:
                    self._waiting.remove(other)
            self._waiting.append(message)
            self._changed.notify()

    def close(self) -> None:
        """Ends the process."""
        with self._changed:
            self._closed = True
            self._changed.notify()
        self._process.terminate()
        self._process.join(5)

    def _listen(self) -> None:
        with suppress(EOFError, OSError):
            while True:
                self._hear(self._pipe.recv_bytes())
        if not self._closed:
            self._ended()

    def _speak(self) -> None:
        with suppress(OSError):
            while True:
                with self._changed:
                    self._changed.wait_for(lambda: self._waiting or self._closed)
                    if self._closed:
                        return
                    message = self._waiting.popleft()
                self._pipe.send_bytes(json.dumps(message).encode())


def work(pipe: Connection, root: Path, name: str, folder: Path) -> None:
    """What the process does until the pipe is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever started it ends it
    gc.set_threshold(COLLECT)
    os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1")  # a core is the browser's
    from facescript.preview.session import Session  # what it needs is loaded while the server starts

    session = Session(root, name, folder)
    with suppress(EOFError, OSError):
        while True:
            while pipe.poll(0 if session.busy else None):
                session.hear(json.loads(pipe.recv_bytes()))
            try:
                for message in session.step():
                    pipe.send_bytes(message)
            except OSError:
                raise
            except Exception:  # the page stays as it is, and the next edit is taken again
                traceback.print_exc()
                session.give_up()
