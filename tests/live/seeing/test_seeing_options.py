"""What stands behind the `?` of a camera's address, and what is said of what cannot stand there."""

from __future__ import annotations

import pytest

from facescript.ir.values import Point
from facescript.live.seeing.geometry import Camera
from facescript.live.seeing.options import DELAY, SIZE, Options, options


def test_without_options_the_camera_stands_level_on_top_of_the_screen() -> None:
    assert options("", 53.0) == Options(Camera(Point(0.0, 53.0, 0.0)), SIZE, DELAY, None)


def test_the_patents_camera() -> None:
    found = options("fov=90&tilt=-30deg&y=1.2m&z=-5cm&delay=80ms&size=1280x720&by=cascade&mirrored=yes", 53.0)
    camera = Camera(Point(0.0, 120.0, -5.0), tilt=-30.0, fov=90.0, mirrored=True)
    assert found == Options(camera, (1280, 720), pytest.approx(0.08), "cascade")
    assert options("distance=80cm", 0.0).camera.distance == 80.0


@pytest.mark.parametrize(
    ("query", "reason"),
    [
        ("lens=wide", "no option `lens`"),
        ("y=20", "`y=20` is written `y=30cm` or `y=30m`"),
        ("y=20m", "not within -1000 and 1000 cm"),
        ("fov=360", "not within 20 and 150 deg"),
        ("tilt=down", "`tilt=down` is written"),
        ("mirrored=1", "none of no, yes"),
        ("by=magic", "none of cascade, mediapipe"),
        ("size=9999x9999", "with sides of 120 to 1920"),
        ("delay=5s", "not within 0 and 1 s"),
        ("distance=0cm", "not within 10 and 1000 cm"),
        ("&".join(f"x={number}cm" for number in range(99)), "Max number of fields"),
    ],
)
def test_what_cannot_be_is_refused_with_a_sentence(query: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        options(query, 0.0)
