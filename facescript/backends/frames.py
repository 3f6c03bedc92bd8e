"""A stage at many moments to pictures in their order, drawn a short stretch at a time by one process or several."""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from mmap import mmap
from multiprocessing.connection import Connection

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import JobFailure
from facescript.canvas.alpha import ClearPlanes
from facescript.canvas.box import Box
from facescript.canvas.overlay import Overlay
from facescript.canvas.painter import Painter
from facescript.canvas.planes import Planes
from facescript.canvas.thorvg import CanvasFailure
from facescript.canvas.video import video_paint, video_pixels
from facescript.pictures import PictureFailure
from facescript.stage.backcloth import WHITE, Backcloth
from facescript.stage.stage import Stage

Floats = NDArray[np.float64]
Bytes = NDArray[np.uint8]

CHUNK = 16
"""Frames sampled and laid out in one call, always the same ones together, so that no rounding depends on `jobs`."""

SHARED = 128 << 20
"""Bytes of finished frames that all drawing processes together may be ahead: at best each a whole chunk, so that none
stands still while another's chunk is encoded."""

DRAWN, FREE = b"drawn", b"free"
"""What the processes tell each other."""


FAULTS = (PictureFailure, CanvasFailure)
"""What can keep a frame from being drawn."""


@contextmanager
def drawing_faults() -> Iterator[None]:
    """Faults of drawing as the one exception of all outputs, `JobFailure`."""
    try:
        yield
    except FAULTS as fault:
        raise JobFailure(fault.args[0]) from None


def even(size: int) -> int:
    """The next even number of pixels: chroma has half the resolution."""
    return size + size % 2


def drawn(
    stage: Stage, painter: Painter, cloth: Backcloth, times: Floats, overlay: Overlay | None = None
) -> Iterator[tuple[Box, ...]]:
    """Draw the moments one by one into the painter's pixels; the boxes of each are where they changed."""
    for first in range(0, len(times), CHUNK):
        frames = stage.frames(times[first : first + CHUNK])
        for number, ground in enumerate(frames.grounds):
            boxes = painter.draw(
                frames.points[number], frames.opacity[number], cloth.paint(ground), frames.turns[number]
            )
            if overlay is None:
                yield boxes
                continue
            with overlay.over(painter.pixels, float(times[first + number]), boxes) as seen:
                yield seen


def pictures(stage: Stage, times: Floats) -> Iterator[Bytes]:
    """Each moment as array[y, x, (B, G, R, A)], premultiplied, which the next moment overwrites."""
    painter = Painter(stage.width, stage.height, stage.shapes)
    cloth = Backcloth(stage.width, stage.height, stage.pictures)
    for _ in drawn(stage, painter, cloth, times, stage.over and Overlay(stage.over, whole=True)):
        yield painter.pixels.astype("<u4", copy=False).view(np.uint8).reshape(stage.height, stage.width, 4)


def planes(stage: Stage, times: Floats, clear: bool = False) -> Iterator[Bytes]:
    """Each moment as yuv420p of even sides, in one array that the next moment overwrites. Where the ground is
    transparent it is white; with `clear` it is clear, and the moments are yuva420p."""
    width, height = even(stage.width), even(stage.height)
    if clear:
        yield from _clear_planes(stage, times, width, height)
        return
    painter = Painter(width, height, [replace(shape, fill=video_paint(shape.fill)) for shape in stage.shapes])
    cloth = Backcloth(width, height, stage.pictures, WHITE, video_pixels)
    yuv = Planes(width, height)
    for boxes in drawn(stage, painter, cloth, times, stage.over and Overlay(stage.over, False, video_pixels)):
        for box in boxes:
            yuv.take(painter.pixels, box)
        yield yuv.data


def _clear_planes(stage: Stage, times: Floats, width: int, height: int) -> Iterator[Bytes]:
    painter = Painter(width, height, stage.shapes)
    cloth = Backcloth(width, height, stage.pictures)
    yuva = ClearPlanes(width, height)
    for boxes in drawn(stage, painter, cloth, times, stage.over and Overlay(stage.over, whole=True)):
        if boxes:
            yuva.take(painter.pixels)
        yield yuva.data


@contextmanager
def film_planes(stage: Stage, times: Floats, jobs: int, clear: bool = False) -> Iterator[Iterator[Bytes]]:
    """`planes`, drawn by `jobs` processes where the system can fork them; the same bytes whatever their number."""
    workers = min(jobs, -(-len(times) // CHUNK))
    if workers < 2 or sys.platform != "linux":
        yield planes(stage, times, clear)
        return
    team = Team(stage, [_share(times, number, workers) for number in range(workers)], clear)
    try:
        yield team.frames(len(times))
    finally:
        team.end()


def _share(times: Floats, number: int, workers: int) -> Floats:
    """Every `workers`-th chunk."""
    chunks = [times[first : first + CHUNK] for first in range(number * CHUNK, len(times), workers * CHUNK)]
    return np.concatenate(chunks)


class Team:
    """Processes that each draw a share of the frames into slots of shared memory in turn.

    A process says "drawn" after each frame, and is told "free" when one of its slots may be filled again.
    """

    def __init__(self, stage: Stage, shares: Sequence[Floats], clear: bool) -> None:
        size = even(stage.width) * even(stage.height) * (5 if clear else 3) // 2
        self._ahead = max(1, min(CHUNK, SHARED // (size * len(shares))))
        shape = self._ahead, size
        self._slots = [list(np.frombuffer(mmap(-1, self._ahead * size), np.uint8).reshape(shape)) for _ in shares]
        pipes = [multiprocessing.Pipe() for _ in shares]
        self._links = [near for near, _ in pipes]
        fork = multiprocessing.get_context("fork")
        self._processes = []
        for number, share in enumerate(shares):
            far = pipes[number][1]
            others = [end for pipe in pipes for end in pipe if end is not far]
            frames = partial(planes, stage, share, clear)
            task = (frames, self._slots[number], far, others)
            self._processes.append(fork.Process(target=_draw, args=task, daemon=True))
        for process in self._processes:
            process.start()
        for _, far in pipes:
            far.close()

    def frames(self, count: int) -> Iterator[Bytes]:
        """The frames in their order, each whole until the next is asked for. Raises `JobFailure`."""
        for number in range(count):
            chunk = number // CHUNK
            worker = chunk % len(self._links)
            own = chunk // len(self._links) * CHUNK + number % CHUNK
            self._wait(self._links[worker])
            yield self._slots[worker][own % self._ahead]
            with suppress(OSError):
                self._links[worker].send_bytes(FREE)

    def end(self) -> None:
        """Stop whatever still draws."""
        for process, link in zip(self._processes, self._links, strict=True):
            process.kill()
            process.join()
            link.close()

    def _wait(self, link: Connection) -> None:
        try:
            word = link.recv_bytes()
        except (EOFError, OSError):
            raise JobFailure("a process that draws has ended") from None
        if word != DRAWN:
            raise JobFailure(word.decode())


def _draw(
    frames: Callable[[], Iterator[Bytes]], slots: Sequence[Bytes], link: Connection, others: Sequence[Connection]
) -> None:
    """A process's whole work. It ends with its parent, whose ends of the pipes it must not hold open itself."""
    for other in others:
        other.close()
    with suppress(EOFError, OSError, KeyboardInterrupt):
        try:
            for number, frame in enumerate(frames()):
                if number >= len(slots):
                    link.recv_bytes()
                slots[number % len(slots)][...] = frame
                link.send_bytes(DRAWN)
        except FAULTS as fault:
            link.send_bytes(fault.args[0].encode())
