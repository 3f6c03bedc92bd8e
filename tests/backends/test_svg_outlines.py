"""Outlines in few numbers and few key frames stay within half a pixel of the outlines they stand for."""

from __future__ import annotations

import re

import numpy as np
import pytest
from numpy.typing import NDArray

from facescript.backends.svg.curves import Curves, curves
from facescript.backends.svg.ease import Keys
from facescript.backends.svg.limit import Edge
from facescript.backends.svg.path import path_text
from facescript.ir.acts import Life, Voice
from facescript.ir.play import Face
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST
from facescript.rig.rigs import rig
from facescript.text import Source, Span

Floats = NDArray[np.float64]
UNIT, OFF = 0.5, 0.5
SLACK = 0.15
"""Pixels: between the samples an outline may be off by a little more."""

TIMES = np.arange(0, 1.2, 0.008)
T = np.linspace(0, 1, 200)[:, None]


def spoken() -> Floats:
    """Poses of a mouth that opens, shuts and widens under a turning head."""
    poses = np.tile(REST, (len(TIMES), 1))
    poses[:, INDEX["mouth.open"]] = 0.5 - 0.5 * np.cos(TIMES * 21)
    poses[:, INDEX["mouth.jaw"]] = 0.4 - 0.4 * np.cos(TIMES * 13)
    poses[:, INDEX["mouth.wide"]] = 0.1 * np.sin(TIMES * 17)
    poses[:, INDEX["head.yaw"]] = 4 * np.sin(TIMES * 3)
    return poses


def cubics(points: Floats, lengths: list[int]) -> Floats:
    """Many points of the outline."""
    drawn, first = [], 0
    for length in lengths:
        for at in range(first, first + length - 1, 3):
            a, b, c, d = points[at : at + 4]
            drawn.append((1 - T) ** 3 * a + 3 * T * (1 - T) ** 2 * b + 3 * T**2 * (1 - T) * c + T**3 * d)
        first += length
    return np.concatenate(drawn)


def quadratics(text: str) -> Floats:
    """Many points of a path of m, q and t."""
    drawn: list[Floats] = []
    at, handle = np.zeros(2), np.zeros(2)
    for command, words in re.findall(r"([mqt])([^mqt]*)", text):
        numbers = list(np.array(re.findall(r"-?\d+", words), dtype=float).reshape(-1, 2))
        if command == "m":
            at = at + numbers[0]
            continue
        ways = [numbers] if command == "q" else [[at * 0, row] for row in numbers]
        for bend, end in ways:
            handle = at + bend if command == "q" else 2 * at - handle
            drawn.append((1 - T) ** 2 * at + 2 * T * (1 - T) * handle + T**2 * (at + end))
            at = at + end
    return np.concatenate(drawn)


def nearest(points: Floats, others: Floats) -> float:
    """The farthest that any tenth point is from the nearest of the others."""
    return float(np.sqrt(((points[::10, None] - others) ** 2).sum(axis=2).min(axis=1).max()))


def followed(points: Floats, lengths: list[int]) -> tuple[Curves, Keys]:
    curve = curves(points[::5], lengths, 0.25)
    keys = Keys()
    rows = (curve.map @ points / UNIT).reshape(len(points), -1)
    keys.follow(TIMES, rows, Edge.of(curve, points, np.full((len(points), len(curve.spots)), OFF), UNIT))
    return curve, keys


@pytest.mark.parametrize("name", ["face-skin", "mouth-lip-lower", "mouth-line", "neck-under-jaw", "eye-lashes-left"])
def test_half_a_pixel(name: str) -> None:
    woman = rig(Face("ada", "woman", Voice(), Life("still"), Span(Source("here.face", ""), 0, 0)))
    shape = next(shape for shape in woman.shapes if shape.id == name)
    lengths = [contour.count for contour in shape.contours]
    first = shape.contours[0].first
    points = woman.draw(spoken()).points[:, first : first + sum(lengths)]
    curve, keys = followed(points, lengths)
    assert len(keys.times) < len(TIMES) / 2
    for moment in range(0, len(TIMES), 7):
        controls = keys.at(TIMES[[moment]])[0].reshape(-1, 2)
        whole = np.rint(controls * 1000).astype(np.int64)
        drawn, true = quadratics(path_text(whole, curve.chains)) * UNIT / 2000, cubics(points[moment], lengths)
        assert nearest(drawn, true) < OFF + SLACK
        assert nearest(true, drawn) < OFF + SLACK
