"""Messages: what is said in JSON and in words, and what is none."""

from __future__ import annotations

import json
from contextlib import suppress

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.ir.values import Point
from facescript.live.messages import LARGEST, LONGEST, Nonsense, as_object, of_object, read
from facescript.live.model import Happening, Sighting

ANN = Sighting("ann", 0.0, Point(10.0, 0.0, 80.0))


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("heard no", (Happening("heard", 0.0, "no"),)),
        ('heard "No, thank you." at 3.5s', (Happening("heard", 3.5, "No, thank you."),)),
        ("key q", (Happening("key", 0.0, "q"),)),
        ("touched  start here ", (Happening("touched", 0.0, "start here"),)),
        ("arrives ann", (Happening("arrives", 0.0, person="ann"),)),
        ("arrives ann 10cm 0cm 0.8m", (ANN, Happening("arrives", 0.0, person="ann"))),
        ("sighting ann 10cm 0cm 80cm", (ANN,)),
        ('{"signal": "closing"}', (Happening("signal", 0.0, "closing"),)),
        ('{"leaves": "ann", "time": 4}', (Happening("leaves", 4.0, person="ann"),)),
        ('{"sighting": "ann", "at": [10, 0, 80]}', (ANN,)),
        ('{"arrives": "ann", "at": [10, 0, 80]}', (ANN, Happening("arrives", 0.0, person="ann"))),
    ],
)
def test_what_is_said_is_meant(said: str, meant: tuple[object, ...]) -> None:
    assert read(said) == read(said.encode()) == meant


@pytest.mark.parametrize(
    "said",
    [
        "", "no", "nearest ann", "open /etc/passwd", "sighting ann", "heard " + "x" * (LONGEST + 1),
        "x" * (LARGEST + 1),
        "heard \x1b[2J", b"heard \xff", "{", "{}", "{\"heard\": 1}", '{"heard": ""}', '{"heard": "a", "key": "b"}',
        '{"heard": "no", "file": "x.wav"}', '{"heard": "no", "at": [1, 2, 3]}', '{"heard": "no", "time": "now"}',
        '{"heard": "no", "time": NaN}', '{"heard": "no", "time": true}', '{"heard": "no", "time": -1}',
        '{"sighting": "ann", "at": [1, 2]}', '{"sighting": "ann", "at": [1, 2, 1e999]}', '{"sighting": "ann"}',
        "[" * 3000, '{"heard": ' * 400, '{"heard": "no", "time": 1' + "0" * 3000 + "}",
    ],
)  # fmt: skip
def test_nonsense_is_told(said: str | bytes) -> None:
    with pytest.raises(Nonsense) as told:
        read(said)
    assert len(told.value.args[0]) < 2 * LONGEST


@settings(max_examples=40, deadline=None)
@given(st.binary(max_size=200))
def test_bytes_are_a_message_or_none(said: bytes) -> None:
    with suppress(Nonsense):
        read(said)


PLAIN = st.text(st.characters(categories=["L", "N", "P"]), min_size=1, max_size=LONGEST)
TIME = st.floats(0.0, 1e6)
PLACE = st.builds(Point, *[st.floats(-1e4, 1e4)] * 3)


@settings(max_examples=40, deadline=None)
@given(
    st.one_of(
        st.builds(Happening, st.sampled_from(["heard", "touched", "key", "signal"]), TIME, PLAIN),
        st.builds(Happening, st.sampled_from(["arrives", "leaves"]), TIME, st.just(""), PLAIN),
        st.builds(Sighting, PLAIN, TIME, PLACE),
    )
)
def test_what_a_log_says_is_read_as_it_was(item: Happening | Sighting) -> None:
    assert of_object(json.loads(json.dumps(as_object(item)))) == (item,)
