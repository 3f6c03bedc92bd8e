"""What a face shows: the base chain, what is added and dropped, `for`, and interruptions."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from performing import FROWN, SMILE, Floats, act, add, drop, grid, mix, performed, show, term

from facescript.ir.acts import Add, Drop, Show, Timing
from facescript.motion.drivers import ROWS, mix_column
from facescript.motion.expression import Expression
from facescript.performance.easing import easing
from facescript.schedule.score import FOREVER, TimedAct

CORNER = ROWS["cheek.lower.left"]
BROW = ROWS["brow.lower.left"]


def shown(*acts: TimedAct, duration: float = 6.0, times: Floats | None = None) -> Floats:
    """What the acts of one scene ask: array[row, time]."""
    ordered = sorted(acts, key=lambda each: (each.start, each.order))
    return Expression(ordered, 0.0, duration).at(grid(duration, 100.0) if times is None else times)


def moment(time: float) -> int:
    return round(time * 100)


def test_a_show_rises_to_its_apex_and_stays() -> None:
    asked = shown(show(1.0, SMILE))[CORNER]
    assert asked[: moment(1.0) + 1].tolist() == [0.0] * 101
    assert asked[moment(1.25)] == pytest.approx(0.35)
    assert set(asked[moment(1.5) :]) == {0.7}


def test_a_show_at_once_is_there_at_once() -> None:
    asked = shown(show(1.0, SMILE, over=0.0))[CORNER]
    assert asked[moment(1.0) - 1] == 0.0 and asked[moment(1.0)] == 0.7


def test_with_for_what_it_covered_comes_back() -> None:
    acts = show(0.0, SMILE), show(2.0, FROWN, order=1, lasting=1.0)
    asked = shown(*acts)
    assert asked[CORNER, moment(2.75)] == 0.0 and asked[BROW, moment(2.75)] == 0.8
    assert asked[CORNER, moment(3.0)] == 0.0
    assert np.array_equal(asked[:, moment(3.4) :], shown(acts[0])[:, moment(3.4) :])


def test_an_interrupted_show_goes_on_from_where_it_is() -> None:
    asked = shown(show(0.0, SMILE, over=1.0), show(0.5, FROWN, order=1), times=grid(3.0))
    speed = np.diff(asked) * 1000.0
    assert np.abs(np.diff(asked[CORNER])).max() < 0.003
    assert np.abs(np.diff(speed)).max() < 0.05


def test_a_degree_scales_a_term_and_a_negative_one_takes_away() -> None:
    asked = shown(show(0.0, term("smile", SMILE, 0.5), term("made", {"cheek.lower.left": 0.2}, -1.0), over=0.0))
    assert asked[CORNER, 0] == pytest.approx(0.35 - 0.2)


def test_an_add_lies_on_top_until_it_is_dropped() -> None:
    acts = show(0.0, SMILE), add(1.0, FROWN, order=7), drop(3.0, (7, 0), order=8)
    asked = shown(*acts)
    assert asked[CORNER, moment(2.0)] == 0.7 and asked[BROW, moment(2.0)] == 0.8
    assert 0.0 < asked[BROW, moment(3.25)] < 0.8
    assert set(asked[BROW, moment(3.5) :]) == {0.0} and asked[CORNER, -1] == 0.7


def test_a_drop_takes_one_term_and_leaves_the_other() -> None:
    acts = show(0.0, term("smile", SMILE), term("frown", FROWN)), drop(2.0, (0, 1), order=1)
    asked = shown(*acts)
    assert asked[BROW, -1] == 0.0 and asked[CORNER, -1] == 0.7


def test_a_drop_lets_go_of_a_change_that_is_still_rising() -> None:
    asked = shown(add(1.0, SMILE, over=2.0), drop(2.0, (0, 0), order=1, over=0.5), times=grid(4.0))[CORNER]
    assert 0.3 < asked.max() < 0.4 and set(asked[2501:]) == {0.0}
    assert np.abs(np.diff(asked)).max() < 0.002


def test_something_short_is_at_its_apex_before_it_lets_go() -> None:
    asked = shown(add(1.0, {"lid.left": 1.0}, lasting=0.2))[ROWS["lid.left"]]
    assert asked[moment(1.2)] == pytest.approx(1.0) and asked[moment(1.6)] == 0.0


def test_back_and_ease_are_as_written() -> None:
    quick = shown(add(0.0, SMILE, lasting=1.0, back=0.1, ease="linear"))[CORNER]
    assert quick[moment(0.2)] == pytest.approx(0.35) and quick[moment(1.05)] == pytest.approx(0.35)


# ------------------------------------------------------------------------------------------------ against the plain law

DRIVERS = ["cheek.lower.left", "brow.lower.right", "lid.left", "mouth.jaw", "head.roll"]
TIMES = st.integers(0, 40).map(lambda tick: tick / 8.0)
LENGTHS = st.integers(0, 8).map(lambda tick: tick / 8.0)


@st.composite
def acts(draw: st.DrawFn) -> tuple[TimedAct, ...]:
    made: list[TimedAct] = []
    for order in range(draw(st.integers(0, 9))):
        terms = [
            term(f"t{index}", {draw(st.sampled_from(DRIVERS)): draw(st.floats(-1, 1))}, draw(st.floats(-1, 2)))
            for index in range(draw(st.integers(1, 3)))
        ]
        timing = Timing(draw(LENGTHS), draw(st.none() | LENGTHS), draw(LENGTHS), draw(st.sampled_from([None, "out"])))
        verb = draw(st.sampled_from([Show, Add]))(mix(*terms), timing)
        made.append(act(verb, draw(TIMES), order))
        if draw(st.booleans()):
            keys = [(order, index) for index in range(len(terms)) if draw(st.booleans())]
            gone = act(Drop("t0", Timing(draw(LENGTHS))), made[-1].start + draw(LENGTHS), 100 + order, drops=keys)
            made.append(gone)
    return tuple(sorted(made, key=lambda each: (each.start, each.order)))


def weight(start: float, length: float, time: float, ease: str | None) -> float:
    if length <= 0.0:
        return float(time >= start)
    return float(easing(ease)(np.array((time - start) / length)))


def plainly(acts: tuple[TimedAct, ...], time: float) -> Floats:
    """The law word by word: base_i = base_(i-1) (1 - w_i) + mix_i w_i, then everything added on top."""
    base, top = np.zeros(len(ROWS)), np.zeros(len(ROWS))
    drops = [(key, each) for each in acts if isinstance(each.verb, Drop) for key in each.drops]
    for each in acts:
        if isinstance(each.verb, Drop):
            continue
        asked = np.zeros(len(ROWS))
        for index, part in enumerate(each.verb.mix.terms):
            left = 1.0
            for key, gone in drops:
                if key == (each.order, index):
                    left *= 1.0 - weight(gone.start, gone.settled - gone.start, time, None)
            asked += left * mix_column(replace(each.verb.mix, terms=(part,)))
        ease = each.verb.timing.ease
        rise = weight(each.start, min(each.verb.timing.over, each.released - each.start), time, ease)
        fall = 0.0 if each.released == FOREVER else weight(each.released, each.end - each.released, time, ease)
        share = rise * (1.0 - fall)
        if isinstance(each.verb, Show):
            base = base * (1.0 - share) + asked * share
        else:
            top = top + asked * share
    return base + top


@settings(max_examples=150, deadline=None)
@given(acts())
def test_the_pieces_are_the_law(made: tuple[TimedAct, ...]) -> None:
    times = np.arange(0.0, 8.0, 0.0625)
    asked = Expression(made, 0.0, 7.0).at(times)
    for index, time in enumerate(times):
        assert asked[:, index] == pytest.approx(plainly(made, time), abs=1e-9)


@settings(max_examples=40, deadline=None)
@given(acts())
def test_a_muscle_is_drawn_within_its_range(made: tuple[TimedAct, ...]) -> None:
    performance = performed(*made, duration=7.0)
    frames = performance.sample(np.arange(0.0, 7.0, 0.05))
    muscles = [index for index, name in enumerate(performance.names) if name in ROWS and name.startswith(("ch", "br"))]
    assert frames[:, muscles].min() >= 0.0 and frames[:, muscles].max() <= 1.0
