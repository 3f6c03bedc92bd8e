"""Looks of a face: choices, colours by name, amounts, and strangers by a seed."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from plays import play_of, resolved

from facescript.diagnostics.catalogue.kinds import KINDS
from facescript.ir.play import Face

GOOD = next(entry.good for entry in KINDS if entry.code == "FS240")
ROWS = """\
    colours hair.base #302010, skin.light #ffffff
    look hair long, bob, none
    look glasses none, round
    amount age 20%
    tints skin pale #f0d0c0, deep #402818
    tints hair black #101010, blond #d8b36a with pale
"""


def face(looks: str) -> Face:
    """A face of a kind that has these looks."""
    head, mark, rest = GOOD.partition("    outline")
    return play_of((head + ROWS + mark + rest).replace("= dot\n", f"= dot, {looks}\n")).faces[0]


def codes(looks: str) -> list[str]:
    head, mark, rest = GOOD.partition("    outline")
    return [item.code for item in resolved((head + ROWS + mark + rest).replace("= dot\n", f"= dot, {looks}\n"))[1]]


def test_a_look_is_a_choice_a_colour_or_both() -> None:
    assert face("hair bob").choices == (("hair", "bob"),)
    assert face("hair blond").looks == (("hair", "#d8b36a"),)
    both = face("hair bob #335577, skin deep, age 70%")
    assert both.choices == (("hair", "bob"),)
    assert dict(both.looks) == {"hair": "#335577", "skin": "#402818"}
    assert both.amounts == (("age", 0.7),)


@pytest.mark.parametrize(
    ("looks", "code"),
    [
        ("hair bobb", "FS249"),
        ("hair purple", "FS249"),
        ("skin bob", "FS249"),
        ("beard full", "FS248"),
        ("width 20%", "FS248"),
    ],
)
def test_slips_and_what_a_kind_does_not_have_are_told(looks: str, code: str) -> None:
    assert codes(looks) == [code]


@given(st.integers(0, 10_000))
def test_a_stranger_is_the_same_each_time_and_goes_together(seed: int) -> None:
    one, again = face(f"seed {seed}"), face(f"seed {seed}")
    assert (one.looks, one.choices, one.amounts) == (again.looks, again.choices, again.amounts)
    colours, choices = dict(one.looks), dict(one.choices)
    assert set(choices) == {"hair", "glasses"} and set(colours) == {"skin", "hair"}
    assert not (colours["skin"] == "#402818" and colours["hair"] == "#d8b36a")
    assert all(0.0 <= amount <= 1.0 for _, amount in one.amounts)


def test_strangers_differ_and_what_is_written_stays() -> None:
    drawn = [face(f"seed {seed}, hair bob") for seed in range(40)]
    assert {dict(one.choices)["hair"] for one in drawn} == {"bob"}
    assert {dict(one.choices)["glasses"] for one in drawn} == {"none", "round"}
    assert {dict(one.looks)["skin"] for one in drawn} == {"#f0d0c0", "#402818"}
    assert len({one.amounts for one in drawn}) > 30
