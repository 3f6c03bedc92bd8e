"""Opacity over time as attributes and animations: what is shown at each moment, and that nothing runs at rest."""

from __future__ import annotations

import numpy as np
from lxml import etree

from facescript.backends.svg.shade import shade
from facescript.backends.svg.track import Track, svg


def shaded(times: list[float], values: list[str]) -> etree._Element:
    path = svg("path")
    shade(path, Track(times, values))
    return path


def shown(path: etree._Element, time: float) -> float:
    """The opacity by SMIL's rules: the animation that began last and is in effect, else the attribute's."""
    value = float(path.get("opacity", "1"))
    for node in path:
        begin, length = float(node.get("begin", "0s")[:-1]), float(node.get("dur")[:-1])
        if begin <= time and (time < begin + length or node.get("fill") == "freeze"):
            keys = [float(word) for word in node.get("keyTimes").split(";")]
            value = float(np.interp((time - begin) / length, keys, list(map(float, node.get("values").split(";")))))
    return value


def test_what_never_changes_is_an_attribute() -> None:
    assert dict(shaded([0, 9], ["0.4", "0.4"]).attrib) == {"fill-opacity": "0.4"}
    assert dict(shaded([0, 9], ["1", "1"]).attrib) == {}


def test_it_shows_the_track_at_every_moment() -> None:
    tracks = (
        ([0, 0.664, 60], ["0", "0.06", "0.06"]),
        ([0, 8, 8.4, 20, 20.4, 60], ["0", "0", "1", "1", "0", "0"]),
        ([0, 2, 2, 30, 31, 40, 41, 60], ["1", "1", "0", "0", "1", "1", "0", "0"]),
        ([0, 1, 60], ["0.4", "0.8", "0.2"]),
        ([0, 5, 30], ["0", "1", "1"]),
    )
    for times, values in tracks:
        path = shaded(times, values)
        for time in np.arange(0.013, 61, 0.02):
            assert abs(shown(path, time) - np.interp(time, times, [float(value) for value in values])) < 0.02, time


def test_no_animation_is_in_effect_at_rest() -> None:
    path = shaded([0, 8, 8.4, 8.8, 40, 41, 42, 60], ["0.1", "0.1", "1", "0.1", "0.1", "0.5", "0.1", "0.1"])
    assert path.get("opacity") == "0.1"
    assert [(node.get("begin"), node.get("dur"), node.get("fill")) for node in path] == [
        ("8s", "0.8s", None),
        ("40s", "2s", None),
    ]


def test_a_picture_without_animation_is_like_the_first_frame() -> None:
    assert shaded([0, 1, 1, 60], ["1", "1", "0", "0"]).get("opacity") == "1"
