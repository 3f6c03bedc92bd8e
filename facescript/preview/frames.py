"""A score to drawn frames in chunks of a second, nearest to the playhead first, as a page adds them up.

What has been drawn once is kept by what it was drawn from: after an edit only chunks are drawn in which a face does
something else. Ways of moving, once found, are kept for as long as the faces look the same.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from hashlib import blake2b

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.page.basis import PLACE
from facescript.backends.page.figure import Object, layer_of, outlines
from facescript.backends.page.motion import RATE, Gathering, add_grounds, cuts
from facescript.stage.ground import Ground, Layer
from facescript.stage.stage import Moments, Stage
from facescript.web.messages import numbers, text

CHUNK = 60
"""Frames of a chunk; it has the first of the next as well."""

MOST = 600
"""Chunks that are held for the page: ten minutes around the playhead."""

KEPT = 1_200
"""Chunks that are kept besides, for what comes back: an edit taken back, a scene that moved by whole seconds."""

MOST_WAYS = 240
"""Ways of moving of a face beyond which they are found anew: each costs a page time in every frame."""


@dataclass(slots=True)
class Figure:
    """Faces that look a certain way: their outlines, the ways in which they move, as far as pages were told of them,
    and what lies behind them."""

    name: str
    outlines: Object
    gathering: Gathering
    told: list[int]
    layers: dict[Layer, int] = field(default_factory=dict)
    drawn: dict[bytes, tuple[Object, list[bytes]]] = field(default_factory=dict)


class Frames:
    """The frames of one script after another, each `show`n in its turn."""

    def __init__(self) -> None:
        self._figure: Figure | None = None
        self._number = 0
        self._job: Job | None = None
        self._version, self._frames = 0, 0
        self._cuts: tuple[int, ...] = ()
        self._told: dict[int, bytes] = {}
        self._left: set[int] = set()

    def show(self, job: Job, version: int) -> Iterator[bytes]:
        """From now on the frames are those of a job; what the page is told of its faces."""
        self._job, self._version = job, version
        self._frames = max(2, int(np.ceil(job.score.duration * RATE - 1e-9)) + 1)
        self._cuts = cuts(job)
        yield from self._faces(job.stage)
        self._left = set(range(self._chunks))
        for number in [number for number in self._told if number >= self._chunks]:
            del self._told[number]

    def stop(self) -> None:
        """Draws no more of this job."""
        self._left.clear()

    @property
    def busy(self) -> bool:
        """Whether chunks are left to be drawn."""
        return bool(self._left)

    def draw(self, time: float) -> Iterator[bytes]:
        """Draws the chunk nearest to a moment: one that lies behind it counts as twice as far."""
        assert self._job is not None and self._figure is not None
        here = min(max(int(time * RATE) // CHUNK, 0), self._chunks - 1)
        number = min(self._left, key=lambda each: _far(each, here))
        self._left.discard(number)
        held = {number, *self._told}
        if len(held) > MOST:
            last = max(held, key=lambda each: _far(each, here))
            if last == number:
                self._left.clear()
                return
            del self._told[last]
            yield text("forget", chunks=[last])
        yield from self._chunk(self._job.stage, self._figure, number)

    def came(self) -> None:
        """The playhead went elsewhere: what was too far away may not be any more."""
        if self._job is not None:
            self._left |= set(range(self._chunks)) - set(self._told)

    @property
    def _chunks(self) -> int:
        return -(-(self._frames - 1) // CHUNK)

    def _faces(self, stage: Stage) -> Iterator[bytes]:
        """The figure, and where it is another than before, its mean places and ways of moving."""
        found, figure = outlines(stage), self._figure
        if figure is None or figure.outlines != found or max(figure.told, default=0) > MOST_WAYS:
            self._number += 1
            name = f"{os.getpid()}-{self._number}"
            gathering = Gathering(stage, stage.frames(self._moments(0)))
            figure = self._figure = Figure(name, found, gathering, [0] * len(gathering.bases))
            self._told.clear()
            yield text("figure", version=self._version, **self._described(figure))
            for face, basis in enumerate(gathering.bases):
                yield numbers("mean", [_bytes(basis.mean * PLACE)], figure=figure.name, face=face)
        else:
            yield text("figure", version=self._version, **self._described(figure))

    def _described(self, figure: Figure) -> Object:
        faces = [{"first": face.start, "size": face.stop - face.start} for face in figure.gathering.faces]
        counts = {"frames": self._frames, "chunk": CHUNK, "chunks": self._chunks}
        return {"figure": figure.name, **counts, **figure.outlines, "faces": faces}

    def _moments(self, number: int) -> NDArray[np.float64]:
        """The moments of a chunk's frames; after the last frame of all, that one."""
        assert self._job is not None
        frames = np.minimum(number * CHUNK + np.arange(CHUNK + 1), self._frames - 1)
        return np.minimum(frames / RATE, self._job.score.duration)

    def _chunk(self, stage: Stage, figure: Figure, number: int) -> Iterator[bytes]:
        moments = stage.moments(self._moments(number))
        key = _key(moments)
        if self._told.get(number) == key:
            yield text("kept", version=self._version, chunks=[number])
            return
        if key not in figure.drawn:
            yield from self._drawn(stage, figure, key, moments)
        head, parts = figure.drawn[key]
        inside = [cut - number * CHUNK for cut in self._cuts if 0 < cut - number * CHUNK <= CHUNK]
        place = {"version": self._version, "figure": figure.name, "chunk": number, "cuts": inside}
        self._told[number] = key
        yield numbers("frames", parts, **place, **head)

    def _drawn(self, stage: Stage, figure: Figure, key: bytes, moments: Moments) -> Iterator[bytes]:
        """Draws a chunk, which is then kept; what the page has to know before it."""
        weights, rest = figure.gathering.take(stage.drawn(moments))
        for face, basis in enumerate(figure.gathering.bases):
            if len(basis) > figure.told[face]:
                ways = basis.moves(figure.told[face])
                yield numbers("ways", [_bytes(ways)], figure=figure.name, face=face, count=len(ways))
                figure.told[face] = len(basis)
        grounds = list[tuple[int, Ground]]()
        add_grounds(grounds, 0, moments.grounds)
        for layer in [layer for _, ground in grounds for layer, _ in ground if layer not in figure.layers]:
            figure.layers.setdefault(layer, len(figure.layers))
            yield text("layer", figure=figure.name, layer=layer_of(layer, stage.pictures))
        behind = [
            [frame, [[figure.layers[layer], round(share, 4)] for layer, share in ground]] for frame, ground in grounds
        ]
        rows = np.concatenate([*weights, rest], axis=1).T
        moving = np.flatnonzero((rows != rows[:, :1]).any(axis=1))
        head: Object = {"ways": [each.shape[1] for each in weights], "moving": moving.tolist(), "grounds": behind}
        while len(figure.drawn) >= KEPT:
            del figure.drawn[next(iter(figure.drawn))]
        figure.drawn[key] = head, [_bytes(rows[:, 0]), _bytes(rows[moving])]


def _far(number: int, here: int) -> int:
    """How far a chunk is from that of the playhead."""
    return number - here if number >= here else 2 * (here - number)


def _key(moments: Moments) -> bytes:
    """What frames are drawn from, as a digest: equal ones look the same."""
    digest = blake2b(digest_size=16)
    for part in (*moments.poses, *moments.present, moments.views):
        digest.update(np.ascontiguousarray(part).tobytes())
    digest.update(repr(moments.grounds).encode())
    return digest.digest()


def _bytes(values: NDArray[np.generic]) -> bytes:
    """Numbers as a message has them."""
    return values.astype("<f4").tobytes()
