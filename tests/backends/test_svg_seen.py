"""What is hidden: how deep places lie in outlines, what others cover, and how far an edge may be off."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from facescript.backends.svg.depth import depths
from facescript.backends.svg.seen import MARGIN, Sight
from facescript.rig.picture import Contour, Linear, Paint, Shape, Stop

Floats = NDArray[np.float64]
OFF = 0.5
BOX = [(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0)]
CLEAR = Linear((Stop(0.0, "#102030", 1.0), Stop(1.0, "#102030", 0.0)))
SHADED = Linear((Stop(0.0, "#000000"), Stop(1.0, "#ffffff")))


def straight(corners: Floats) -> Floats:
    """A closed outline of straight cubics, array[point, xy]."""
    ends = np.roll(corners, -1, axis=0)
    parts = [corners, corners + (ends - corners) / 3, corners + (ends - corners) * (2 / 3)]
    return np.concatenate([np.stack(parts, axis=1).reshape(-1, 2), corners[:1]])


def wound(corners: Floats, place: Floats) -> bool:
    """Whether a polygon goes round a place, by the sum of the angles under which its edges are seen."""
    ways = corners - place
    angles = np.angle((ways[:, 0] + 1j * ways[:, 1]) / np.roll(ways[:, 0] + 1j * ways[:, 1], 1))
    return bool(abs(angles.sum()) > np.pi)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.floats(5, 60), min_size=3, max_size=9), st.tuples(st.floats(-70, 70), st.floats(-70, 70)))
def test_depth_is_the_distance_to_the_edge(radii: list[float], at: tuple[float, float]) -> None:
    """Positive inside, negative outside, whichever way a star runs."""
    turns = np.exp(2j * np.pi * np.arange(len(radii)) / len(radii)) * radii
    corners, place = np.stack([turns.real, turns.imag], axis=1), np.array(at)
    ends = np.roll(corners, -1, axis=0)
    along = np.linspace(0, 1, 4001)[:, None, None]
    near = np.linalg.norm(corners + (ends - corners) * along - place, axis=2).min()
    if near > 0.1:
        true = near if wound(corners, place) else -near
        for outline in (straight(corners), straight(corners)[::-1]):
            assert depths(place[None, None], outline[None])[0, 0] == pytest.approx(true, abs=0.05)


def sight(upper: Paint = "#102030", opacity: float = 1.0, moved: float = 0.0, fill: Paint = "#405060") -> Sight:
    """A box of 20 px under one of 40 px, from its middle moved aside, in one moment."""
    cover, own = straight(np.array(BOX)), straight(np.array(BOX) / 2 + (10 + moved, 10))
    shapes = [
        Shape("own", "face", (Contour(0, len(own)),), fill),
        Shape("cover", "face", (Contour(len(own), len(cover)),), upper),
    ]
    columns = [np.arange(len(own)), np.arange(len(own), len(own) + len(cover))]
    return Sight(shapes, columns, np.concatenate([own, cover])[None], np.array([[1.0, opacity]]))


def test_what_another_covers_is_not_shown() -> None:
    assert sight().shown(np.zeros(1))[0].tolist() == [0, 1]


@pytest.mark.parametrize("seen", [{"opacity": 0.9}, {"upper": CLEAR}, {"moved": 9.5}, {"moved": 30.0}])
def test_what_may_be_seen_is_shown(seen: dict[str, float]) -> None:
    """Something shines through, or an edge is nearer than the margin, or looks out."""
    assert sight(**seen).shown(np.zeros(1))[0, 0] == 1  # type: ignore[arg-type]


def test_what_is_hidden_for_a_moment_is_not_switched_off() -> None:
    """Half a second under the cover, and two and a half."""
    one, aside = sight(), sight(moved=60.0)
    times = np.arange(0, 6, 0.5)
    away = np.array([1, 1, 1, 0, 1, 1, 0, 0, 0, 0, 0, 1], dtype=bool)
    points = np.where(away[:, None, None], aside.points, one.points)
    shown = Sight(one.shapes, one.columns, points, np.ones((len(times), 2))).shown(times)
    assert shown[:, 0].tolist() == [1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1]


def corner_tolerances(view: Sight) -> Floats:
    spots = np.eye(len(view.columns[0]))[[0, 3, 6, 9]]
    allowed: Floats = view.tolerances(0, spots, OFF)[0]
    return allowed


def test_an_edge_may_be_off_by_as_much_as_it_is_hidden() -> None:
    """Left corners 10 px deep, right ones outside of the cover."""
    allowed = corner_tolerances(sight(moved=25.0))
    assert allowed == pytest.approx([5 - MARGIN, OFF, OFF, 5 - MARGIN])


def test_a_box_with_a_gradient_keeps_its_size() -> None:
    """Black to white over 20 px: a twelfth of a pixel a level."""
    allowed = corner_tolerances(sight(fill=SHADED))
    assert allowed == pytest.approx(OFF + 2 * 20 / 255)


def test_a_fill_that_fades_out_is_faint_there() -> None:
    """Its lower edge is as clear as can be, its upper one is not."""
    allowed = corner_tolerances(sight(fill=CLEAR, moved=60.0))
    assert allowed[[0, 1]] == pytest.approx(OFF)
    assert allowed[2] > OFF
