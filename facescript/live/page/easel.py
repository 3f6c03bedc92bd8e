"""Poses to frames for pages, drawn by a process of their own: a run's other frames never wait for a picture."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from threading import Thread

import numpy as np
from numpy.typing import NDArray

from facescript.ir.play import Face, Film
from facescript.live.page.picture import WAITING, WIDTH, Picture, Pose

FIRST = 1 + len(WAITING)
"""Messages that come before the first frame: what a page is told at first."""

TOGETHER = 6
"""Frames that are drawn at once where several wait, at most."""

NUMBER = 8
"""Bytes in front of a frame that say which it is."""


class Easel:
    """The process. `first` is called with what a page is told at first, `drawn` with the number and the numbers of each
    frame, `ended` when the process is gone; all in a thread of the easel's own."""

    def __init__(
        self,
        film: Film,
        faces: Sequence[Face],
        about: Mapping[str, object],
        first: Callable[[list[bytes]], None],
        drawn: Callable[[int, bytes], None],
        ended: Callable[[], None],
    ) -> None:
        context = multiprocessing.get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=work, args=(theirs, film, tuple(faces), dict(about)), daemon=True)
        self._process.start()
        theirs.close()
        self._first, self._drawn, self._ended, self._closed = first, drawn, ended, False
        Thread(target=self._listen, daemon=True).start()

    def draw(self, number: int, pose: Pose) -> None:
        """Has a frame drawn; waits where dozens are not drawn yet, so ask for few at once."""
        row = np.concatenate([[number, pose.time, pose.own], pose.present, pose.channels.ravel()])
        with suppress(OSError):
            self._pipe.send_bytes(row.tobytes())

    def close(self) -> None:
        """Ends the process."""
        self._closed = True
        self._process.terminate()
        self._process.join(5)

    def _listen(self) -> None:
        with suppress(EOFError, OSError):
            self._first([self._pipe.recv_bytes() for _ in range(FIRST)])
            while True:
                made = self._pipe.recv_bytes()
                self._drawn(int.from_bytes(made[:NUMBER], "little"), made[NUMBER:])
        if not self._closed:
            self._ended()


def work(pipe: Connection, film: Film, faces: Sequence[Face], about: Mapping[str, object]) -> None:
    """What the process does until the pipe is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever started it ends it
    os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1")
    picture = Picture(film, faces)
    with suppress(EOFError, OSError):
        for message in picture.figure(about):
            pipe.send_bytes(message)
        count = sum(face.seen for face in faces)
        while True:
            rows = [pipe.recv_bytes()]
            while len(rows) < TOGETHER and pipe.poll():
                rows.append(pipe.recv_bytes())
            asked = [_pose(np.frombuffer(row), count) for row in rows]
            for (number, _), made in zip(asked, picture.draw([pose for _, pose in asked]), strict=True):
                pipe.send_bytes(number.to_bytes(NUMBER, "little") + made)


def _pose(row: NDArray[np.float64], faces: int) -> tuple[int, Pose]:
    """A frame that was asked for: its number, and what is drawn."""
    present = tuple(row[3 : 3 + faces].tolist())
    return int(row[0]), Pose(row[1], row[2], present, row[3 + faces :].reshape(faces, WIDTH))
