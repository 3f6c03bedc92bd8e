"""Hair that trails: where it grows it stays, tips go farthest, nothing else moves, what hangs is as before."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.resolve.kinds.library import PEOPLE
from facescript.rig.cartoon.sway import shares
from facescript.rig.rigs import rig as rig_of
from rig.poses import plain, pose

RIGS = {name: rig_of(plain(name)) for name in PEOPLE}
KINDS = pytest.mark.parametrize("kind", sorted(RIGS))
ASIDE = {f"hair_{lock}_x": 5.0 for lock in ("slow", "middle", "quick")}
UP = {f"hair_{lock}_y": 5.0 for lock in ("slow", "middle", "quick")}


def test_long_hair_hangs_and_short_hair_stands() -> None:
    long = shares([(0.3, -1.8), (1.0, 0.1), (1.2, 1.2), (1.4, 2.4)])
    assert long[0] == long[1] == (0.0, 0.0, 0.0)
    assert 0.0 < sum(long[2]) < sum(long[3]) == pytest.approx(1.0)
    assert long[2][1] > long[2][0] and long[3][0] == pytest.approx(1.0)
    short = shares([(0.0, -2.0), (0.8, -1.0), (1.0, 0.2)])
    assert short[0][2] > 0.3 and short[1] == short[2] == (0.0, 0.0, 0.0)
    assert shares([]) == []


@KINDS
def test_only_hair_moves_and_it_moves_to_the_side_it_trails(kind: str) -> None:
    rig = RIGS[kind]
    rest, aside, up = rig.draw(np.array([pose(), pose(**ASIDE), pose(**UP)])).points
    hair = np.zeros(len(rest), dtype=bool)
    for shape in rig.shapes:
        for contour in shape.contours:
            hair[contour.first : contour.first + contour.count] = shape.group.startswith("hair")
    assert np.array_equal(aside[~hair], rest[~hair]) and np.array_equal(up[~hair], rest[~hair])
    moved = aside[hair] - rest[hair]
    assert moved[:, 0].max() > 3.0 and moved[:, 0].min() > -1.0 and np.abs(moved).max() < 15.0
    lifted = up[hair] - rest[hair]
    assert lifted[:, 1].min() < -0.8 and lifted[:, 1].max() < 0.5


@KINDS
def test_hair_that_hangs_is_drawn_to_the_bit_as_before(kind: str) -> None:
    """However the head is turned, and whether or not another frame of the chunk has hair that trails."""
    turned = pose(head_yaw=20.0, head_pitch=-8.0, head_roll=5.0)
    alone = RIGS[kind].draw(turned[None]).points[0]
    beside = RIGS[kind].draw(np.array([pose(**ASIDE), turned])).points[1]
    assert np.array_equal(alone, beside)
