"""Turns the shows, adds and drops of a face into what its expression asks of every driver at any time.

The base is a chain, `base_i = base_(i-1) (1 - w_i) + mix_i w_i`, w_i the weight of the i-th show, so a change that is
interrupted goes on from where it is; what is added is summed on top. Between two breakpoints (where a change starts or
ends) only the layers that can be seen are kept, so a long script costs no more per frame than a short one.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from facescript.ir.acts import Add, Drop, Perform, Show
from facescript.motion.dice import Dice
from facescript.motion.drivers import ROWS, Drive, Floats, number, term_column
from facescript.motion.expression_apex import SMALLER, Ripple
from facescript.motion.recorded import Playing, playing
from facescript.performance.curves import Ramp
from facescript.performance.easing import easing
from facescript.schedule.score import TimedAct

Drops = Mapping[tuple[int, int], tuple[Ramp, ...]]
"""The falls of each term, by its act's order and its index in the sum."""


@dataclass(frozen=True, slots=True)
class Part:
    """A term of a layer: what it asks at its apex, array[row], and the drops that take it away."""

    column: Floats
    drops: tuple[Ramp, ...]

    def at(self, times: Floats) -> Drive:
        left = np.ones_like(times)
        for drop in self.drops:
            left = left * (1.0 - drop.at(times))
        return self.column[:, None] * left


@dataclass(frozen=True, slots=True)
class Layer:
    """One show (`base`) or add: it rises, holds, and falls; seconds from the film's start. With a `ripple` it lives
    once it has risen. What is played (`recorded`) is a base on those rows that it has."""

    base: bool
    rise: Ramp
    fall: Ramp
    parts: tuple[Part, ...]
    act: TimedAct
    ripple: Ripple | None = None
    recorded: Playing | None = None

    def weight(self, times: Floats) -> Floats:
        return self.rise.at(times) * (1.0 - self.fall.at(times))

    def mix(self, times: Floats) -> Drive:
        if self.recorded is not None:
            return self.recorded.asks(times)
        asked = sum((part.at(times) for part in self.parts), np.zeros((len(ROWS), len(times))))
        return asked if self.ripple is None else asked * (1.0 + self.ripple.at(times))

    def covers(self, row: int) -> float:
        """How far it takes the place of what is below it on a driver: 0 or 1."""
        return float(self.base) if self.recorded is None else float(self.recorded.recording.has[row])

    @property
    def changes(self) -> Iterator[Ramp]:
        yield self.rise
        yield self.fall
        for part in self.parts:
            yield from part.drops

    @property
    def kept(self) -> bool:
        """Whether it stays as it is once it has risen."""
        return self.ripple is None and self.fall.start == np.inf and not any(part.drops for part in self.parts)


@dataclass(frozen=True, slots=True)
class Piece:
    """The expression from `start` to the next piece; `settled`, array[row], sums up what no longer changes."""

    start: float
    layers: tuple[Layer, ...]
    settled: Floats
    moving: bool

    def at(self, times: Floats) -> Drive:
        base = np.zeros((len(ROWS), len(times)))
        top = np.repeat(self.settled[:, None], len(times), axis=1)
        for layer in self.layers:
            weight = layer.weight(times)
            if layer.recorded is not None:
                base = base * (1.0 - weight * layer.recorded.recording.has[:, None]) + layer.mix(times) * weight
            elif layer.base:
                base = base * (1.0 - weight) + layer.mix(times) * weight
            else:
                top = top + layer.mix(times) * weight
        return base + top


class Expression:
    """What one face shows in one scene."""

    def __init__(self, acts: Sequence[TimedAct], start: float, end: float) -> None:
        """`acts` are the face's in the scene, sorted by (start, order); it is neutral at the scene's `start`."""
        self.layers = layers(acts)
        self._pieces = scene_pieces(self.layers, start, end)
        self._starts = np.array([piece.start for piece in self._pieces])
        self._moving = [index for index, piece in enumerate(self._pieces) if piece.moving]
        still = [piece.settled if piece.moving else _still(piece) for piece in self._pieces]
        self._still = np.stack(still, axis=1)

    def at(self, times: Floats) -> Drive:
        """What it asks at `times` (sorted): array[row, time]."""
        edges = np.maximum(np.searchsorted(self._starts, times, side="right") - 1, 0)
        drive = self._still[:, edges]
        if not len(times):
            return drive
        for index in self._moving[bisect_left(self._moving, edges[0]) : bisect_right(self._moving, edges[-1])]:
            first, last = np.searchsorted(edges, [index, index + 1])
            if first < last:
                drive[:, first:last] = self._pieces[index].at(times[first:last])
        return drive

    def recorded(self, times: Floats) -> Drive:
        """How far takes own each driver at `times` (sorted): array[row, time], 0..1."""
        owned = np.zeros((len(ROWS), len(times)))
        for item in self._under_takes(times):
            weight = item.weight(times)
            if item.recorded is not None:
                own = weight * item.recorded.recording.has[:, None]
                owned = owned * (1.0 - own) + own
            else:
                owned *= 1.0 - weight
        return owned

    def _under_takes(self, times: Floats) -> list[Layer]:
        """The takes that are played at some of these times, and the shows that may cover them."""
        first, last = (times[0], times[-1]) if len(times) else (0.0, -1.0)
        seen = [item for item in self.layers if item.base and item.rise.start <= last and item.fall.end >= first]
        begun = next((index for index, item in enumerate(seen) if item.recorded is not None), len(seen))
        return seen[begun:]


def _still(piece: Piece) -> Floats:
    return piece.at(np.array([piece.start]))[:, 0] if piece.layers else piece.settled


def layers(acts: Sequence[TimedAct]) -> list[Layer]:
    """The shows and adds among the acts of one face in one scene, in their order."""
    drops = _drops(acts)
    return [layer(act, drops) for act in acts if isinstance(act.verb, (Show, Add, Perform))]


def scene_pieces(layers: list[Layer], start: float, end: float) -> tuple[Piece, ...]:
    """The pieces of one scene for a face's layers in it; the first starts at `start`, the last ends at `end`."""
    cuts = {edge for item in layers for ramp in item.changes for edge in (ramp.start, ramp.end)}
    return tuple(_pieces(layers, [start, *sorted(cut for cut in cuts if start < cut < end), end]))


def layer(act: TimedAct, drops: Drops) -> Layer:
    """A show, an add or a take as a layer. It is at its apex before it lets go, however short it is."""
    if isinstance(act.verb, Perform):
        played = playing(act)
        return Layer(True, played.rise, played.fall, (), act, recorded=played)
    assert isinstance(act.verb, (Show, Add))
    timing, curve = act.verb.timing, easing(act.verb.timing.ease)
    over = act.settled - act.start if timing.over is None else number(timing.over)
    felt = timing.manner == "spontaneous"
    size = SMALLER if felt else 1.0
    parts = tuple(
        Part(size * term_column(term), drops.get((act.order, index), ()))
        for index, term in enumerate(act.verb.mix.terms)
    )
    rise = Ramp(act.start, min(act.start + over, act.released), curve)
    ripple = Ripple(rise.end, Dice(act.seed, (act.face,))) if felt else None
    return Layer(isinstance(act.verb, Show), rise, Ramp(act.released, act.end, curve), parts, act, ripple)


def _drops(acts: Iterable[TimedAct]) -> Drops:
    falls: dict[tuple[int, int], tuple[Ramp, ...]] = {}
    for act in acts:
        if isinstance(act.verb, Drop):
            fall = Ramp(act.start, act.settled, easing(act.verb.timing.ease))
            for key in act.drops:
                falls[key] = (*falls.get(key, ()), fall)
    return falls


def _pieces(layers: list[Layer], edges: list[float]) -> Iterator[Piece]:
    """One piece between each two edges; `layers` in the order of their starts."""
    live: list[Layer] = []
    settled = np.zeros(len(ROWS))
    coming = 0
    for start, end in pairwise(edges):
        while coming < len(layers) and layers[coming].rise.start <= start:
            live.append(layers[coming])
            coming += 1
        live = [item for item in live if _matters(item, start)]
        for item in live:
            if _folds(item, start):
                settled = settled + item.mix(np.array([start]))[:, 0]
        live = _uncovered([item for item in live if not _folds(item, start)], start)
        seen = tuple(_visible(live, start, end))
        yield Piece(start, seen, settled, any(_moves(item, start) for item in seen))


def _moves(item: Layer, start: float) -> bool:
    """Whether a layer changes in the piece that starts at `start` (the ends of ramps are edges of pieces)."""
    return (
        item.ripple is not None
        or item.recorded is not None
        or any(ramp.start <= start < ramp.end for ramp in item.changes)
    )


def _matters(item: Layer, start: float) -> bool:
    """Whether a layer can still be seen: a show has not let go, an add has also not been dropped."""
    if item.fall.end <= start:
        return False
    return item.base or not all(any(drop.end <= start for drop in part.drops) for part in item.parts)


def _folds(item: Layer, start: float) -> bool:
    return not item.base and item.kept and item.rise.end <= start


def _uncovered(live: list[Layer], start: float) -> list[Layer]:
    """Without the shows that a later one has covered for ever."""
    covers = [index for index, item in enumerate(live) if item.base and item.fall.start == np.inf]
    covers = [index for index in covers if live[index].rise.end <= start]
    last = covers[-1] if covers else 0
    return [item for index, item in enumerate(live) if index >= last or not item.base]


def _visible(live: list[Layer], start: float, end: float) -> Iterator[Layer]:
    """The layers that a piece shows: a show that holds through all of it hides those before it."""
    whole = [i for i, item in enumerate(live) if item.base and item.recorded is None]
    holds = [i for i in whole if live[i].rise.end <= start and live[i].fall.start >= end]
    last = holds[-1] if holds else 0
    return (item for index, item in enumerate(live) if index >= last or not item.base)
