"""Panels of curves to marks: an axis of values, the curves, what is behind them, and a legend at the top."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import SIDES
from facescript.performance.performance import FaceCurves
from facescript.plot.axis import Scale, round_step, ticks, written
from facescript.plot.channels import Curve, Panel
from facescript.plot.font import width
from facescript.plot.looks import GREY, INK, LIGHT, look
from facescript.plot.marks import SMALL, Area, Line, Mark, Text, box, level
from facescript.plot.sample import Envelope, envelopes, straightened
from facescript.plot.target import Course

LEGEND_ROW = 16
"""A row of the legend, px."""

SAMPLE, AFTER = 20, 16
"""The piece of line in the legend; what is free after an entry, px."""

INNER = 50
"""The least height of the curves of a panel as tall as others, px."""

GAP = 8
"""Pixels between panels."""

EDGE = 6
"""Pixels that curves keep from a panel's frame."""

APART = 19.0
"""Pixels from one tick of values to the next, at least."""

SAME = 0.003
"""Two sides that differ by no more than this part of the range that is always shown are one curve."""

SOUND, TARGET = "#e3e3e3", "#8a8a8a"
"""Colours of what is behind the curves."""

DOTTED = (1.5, 2.5)
"""The dash of the target's line."""


@dataclass(frozen=True, slots=True)
class PanelStrip:
    """One panel of the picture with all it shows; `sound` is array[column], 0..1, `targets` are directions in deg."""

    panel: Panel
    curves: tuple[tuple[Curve, Envelope], ...]
    legend: tuple[tuple[tuple[float, int], Curve], ...]
    targets: tuple[Course, ...] = ()
    sound: NDArray[np.float64] | None = None

    @property
    def fixed(self) -> float:
        return self._top + 2 * EDGE + GAP

    @property
    def weight(self) -> float:
        return self.panel.tall

    @property
    def _top(self) -> float:
        return LEGEND_ROW * (1 + max((place[1] for place, _ in self.legend), default=0)) + EDGE

    def marks(self, scale: Scale, top: float, height: float) -> Iterator[Mark]:
        bottom = top + height - GAP
        axis = _Axis(*self._range(), bottom - EDGE, top + self._top + EDGE)
        yield from self._sound(scale, axis, bottom)
        yield from self._grid(scale, axis)
        yield from self._targets(scale, axis)
        for curve, envelope in self.curves:
            points = straightened(_places(scale, envelope), axis.y(envelope.values.ravel()))
            yield Line((points,), curve.colour, curve.width, curve.dash, " ".join(curve.channels))
        yield Area(box(scale.left, top, scale.right, bottom, "").points, "", GREY)
        yield from self._legend(scale, top)

    def _range(self) -> tuple[float, float]:
        low = min([self.panel.least[0], *(envelope.low for _, envelope in self.curves)])
        high = max([self.panel.least[1], *(envelope.high for _, envelope in self.curves)])
        return low, high

    def _grid(self, scale: Scale, axis: _Axis) -> Iterator[Mark]:
        """Lines of equal value, and the values beside them."""
        if not self.curves:
            return
        step = round_step((axis.high - axis.low) * APART / (axis.bottom - axis.top))
        for value in ticks(axis.low, axis.high, step):
            y = axis.at(value)
            yield level(scale.left, scale.right, y, "#b0b0b0" if abs(value) < step / 2 else LIGHT)
            yield Text(scale.left - 8, y + 4, written(value, step), SMALL, "end", GREY)

    def _sound(self, scale: Scale, axis: _Axis, bottom: float) -> Iterator[Mark]:
        """The sound's energy from the panel's floor up."""
        if self.sound is None or not self.sound.any():
            return
        places = scale.left + (np.arange(len(self.sound)) + 0.5) * (scale.right - scale.left) / len(self.sound)
        tops = straightened(places, bottom - self.sound * (bottom - axis.top))
        yield Area(((tops[0][0], bottom), *tops, (tops[-1][0], bottom)), SOUND)

    def _targets(self, scale: Scale, axis: _Axis) -> Iterator[Mark]:
        side = self.panel.target
        if side is None or not self.targets:
            return
        parts = tuple(
            tuple((scale.x(time), axis.at(min(max(place[side], axis.low), axis.high))) for time, place in course)
            for course in self.targets
        )
        yield Line(parts, TARGET, 1.4, DOTTED, "target")

    def _legend(self, scale: Scale, top: float) -> Iterator[Mark]:
        """The panel's name, and a piece of each line beside its name."""
        yield Text(scale.left + 8, top + 13, self.panel.title, SMALL, "start", INK)
        for (x, row), curve in self.legend:
            y = top + 9 + row * LEGEND_ROW
            if curve.channels:
                yield Line((((x, y + 0.5), (x + SAMPLE, y + 0.5)),), curve.colour, curve.width + 0.2, curve.dash)
            else:
                yield box(x, y - 4, x + SAMPLE, y + 5, curve.colour)
            yield Text(x + SAMPLE + 5, y + 4, curve.label, SMALL, "start", GREY)


@dataclass(frozen=True, slots=True)
class _Axis:
    """Values from `low` at `bottom` to `high` at `top`, px."""

    low: float
    high: float
    bottom: float
    top: float

    def y(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        return self.bottom - (values - self.low) * ((self.bottom - self.top) / (self.high - self.low))

    def at(self, value: float) -> float:
        return self.bottom - (value - self.low) * ((self.bottom - self.top) / (self.high - self.low))


def strips(
    panels: Sequence[Panel],
    face: FaceCurves | None,
    scale: Scale,
    targets: tuple[Course, ...],
    sound: NDArray[np.float64],
) -> Iterator[PanelStrip]:
    """The panels of one face (None: one that is only heard) with their curves sampled; those without any left out."""
    wanted = [curve for panel in panels for curve in panel.curves]
    found = envelopes(face, [curve.channels for curve in wanted], scale) if face is not None else []
    taken = iter(zip(wanted, found, strict=True))
    for panel in panels:
        curves = tuple(_styled(_moving(panel, _merged(panel, [next(taken) for _ in panel.curves]))))
        heard = sound if panel.heard and sound.any() else None
        if curves or heard is not None:
            aims = targets if panel.target is not None else ()
            yield PanelStrip(panel, curves, tuple(_entries(panel, curves, aims, heard, scale)), aims, heard)


def _merged(panel: Panel, curves: Sequence[tuple[Curve, Envelope]]) -> list[tuple[Curve, Envelope]]:
    """The curves, a left and a right side that are the same as one."""
    kept: list[tuple[Curve, Envelope]] = []
    for curve, envelope in curves:
        alike = (number for number, (other, _) in enumerate(kept) if _whole(other.label) == _whole(curve.label))
        number = next((number for number in alike if _same(panel, kept[number][1], envelope)), None)
        if number is None:
            kept.append((curve, envelope))
        else:
            channels = kept[number][0].channels + curve.channels
            kept[number] = replace(kept[number][0], label=_whole(curve.label), channels=channels), envelope
    return kept


def _whole(label: str) -> str:
    """The label without its side."""
    return ".".join(part for part in label.split(".") if part not in SIDES)


def _same(panel: Panel, one: Envelope, other: Envelope) -> bool:
    far = SAME * (panel.least[1] - panel.least[0])
    return bool(np.abs(one.values - other.values).max() <= far)


def _moving(panel: Panel, curves: Sequence[tuple[Curve, Envelope]]) -> list[tuple[Curve, Envelope]]:
    """Those that move, or where the panel does not tell one from another all if any does."""
    moving = [each for each in curves if max(each[1].high, -each[1].low) >= panel.moves]
    return moving if panel.each or not moving else list(curves)


def _styled(curves: Sequence[tuple[Curve, Envelope]]) -> Iterator[tuple[Curve, Envelope]]:
    """The curves, each without a colour with a look of its own."""
    for number, (curve, envelope) in enumerate(curves):
        colour, dash = (curve.colour, curve.dash) if curve.colour else look(number)
        yield replace(curve, colour=colour, dash=dash), envelope


def _entries(
    panel: Panel,
    curves: Sequence[tuple[Curve, Envelope]],
    targets: Sequence[Course],
    sound: NDArray[np.float64] | None,
    scale: Scale,
) -> Iterator[tuple[tuple[float, int], Curve]]:
    """The legend's entries at their places: (px, row)."""
    entries = [curve for curve, _ in curves]
    if targets:
        entries.append(Curve("target", ("target",), TARGET, DOTTED))
    if sound is not None and entries:
        entries.append(Curve("sound", (), SOUND))
    first = scale.left + 8 + width(panel.title, SMALL) + AFTER
    x, row = first, 0
    for entry in entries:
        long = SAMPLE + 5 + width(entry.label, SMALL)
        if x + long > scale.right and x > first:
            x, row = first, row + 1
        yield (x, row), entry
        x += long + AFTER


def _places(scale: Scale, envelope: Envelope) -> NDArray[np.float64]:
    return scale.left + (envelope.times.ravel() - scale.start) * scale.second
