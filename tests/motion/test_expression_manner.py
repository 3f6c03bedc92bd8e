"""Posed and spontaneous expressions against their bars, the apex that lives, and interruptions without a jump."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from bars import bar
from hypothesis import given, settings
from hypothesis import strategies as st
from performing import Floats, act, grid, mix, term

from facescript.compile import compile_source
from facescript.ir.acts import Add, Drop, Manner, Show, Timing
from facescript.motion.expression import Expression
from facescript.motion.perform import perform
from facescript.performance.performance import Performance
from facescript.schedule.score import TimedAct
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

CORNER, BROW = "cheek.lower.left", "brow.inner.left"


def played(script: str, seed: int = 1) -> Performance:
    text = f"film seed {seed}\nface ada = woman\n    life still\n{script}"
    score = compile_source(Source("made.face", text), World(Path(__file__).parent), EstimatedVoice()).score
    assert score is not None
    return perform(score)


def channel(performance: Performance, name: str, times: Floats) -> Floats:
    return performance.sample(times)[:, performance.names.index(name)]


def traced(script: str, name: str = CORNER, seed: int = 1) -> Floats:
    """A channel at 1000 Hz, from the film's start to a second after its end."""
    performance = played(script, seed)
    return channel(performance, name, grid(performance.duration + 1.0))


def onset_speed(values: Floats) -> float:
    """The greatest speed of a rise, 1/s."""
    return float(np.diff(values).max() * 1000.0)


def onset_time(values: Floats) -> float:
    """Bar E2: the time from 10 to 90 % of the rise, times 1.25, s; the apex is where the rise ends."""
    top = values[np.flatnonzero(np.diff(values) <= 0.0)[np.flatnonzero(values)[0] :][0]]
    low, high = (int(np.argmax(values >= part * top)) for part in (0.1, 0.9))
    return (high - low) / 1000.0 * 1.25


# ------------------------------------------------------------------------------------------------ the bars


@pytest.mark.parametrize("verb", ["show", "add"])
@pytest.mark.parametrize(("what", "name"), [("smile", CORNER), ("smile 60%", CORNER), ("brows 70%", BROW)])
def test_a_spontaneous_onset_is_slower_and_smaller(verb: str, what: str, name: str) -> None:
    posed, felt = (traced(f"{verb} {what}, {manner} for 3s\n", name) for manner in ("posed", "spontaneous"))
    low, high = bar("E1", "ratio")
    assert low <= onset_speed(felt) / onset_speed(posed) <= high
    low, high = bar("E2", "mean")
    assert low <= onset_time(felt) <= high
    assert onset_time(posed) < 0.7 * onset_time(felt)
    assert felt.max() < 0.95 * posed.max()


@pytest.mark.parametrize("manner", ["posed", "spontaneous"])
@pytest.mark.parametrize("lasting", [0.5, 2.0, 4.0])
def test_an_expression_takes_as_long_as_peoples(manner: str, lasting: float) -> None:
    seen = np.flatnonzero(traced(f"show smile, {manner} for {lasting}s\nwait 3s\n") > 0.01)
    low, high = bar("E3", "any")
    assert low <= (seen[-1] - seen[0]) / 1000.0 <= high


def test_a_spontaneous_offset_is_slower_and_slowest_at_its_end() -> None:
    posed, felt = (traced(f"show smile, {manner} for 3s\nwait 3s\n") for manner in ("posed", "spontaneous"))
    assert np.diff(felt).min() > 0.7 * np.diff(posed).min()
    assert felt[3700] < 0.3 * felt[3000] and felt[4390] > 0.0 == felt[4400]


@pytest.mark.parametrize("manner", ["", ", posed", ", spontaneous"])
def test_the_speed_of_lip_corners_grows_with_amplitude(manner: str) -> None:
    degrees = np.array([0.2, 0.4, 0.6, 0.75])
    speeds = np.array([onset_speed(traced(f"show smile {degree:.0%}{manner}\n")) for degree in degrees])
    assert speeds / degrees == pytest.approx(speeds[0] / degrees[0], rel=0.01)


def test_what_is_written_wins_over_the_manner() -> None:
    felt = traced("show smile over 300ms for 2s back in 200ms ease smooth, spontaneous\n")
    plain = traced("show smile 80% over 300ms for 2s back in 200ms\n")
    assert felt[:301] == pytest.approx(plain[:301], abs=1e-9)
    assert plain[2200] == felt[2200] == 0.0 < felt[2190]


# ------------------------------------------------------------------------------------------------ the apex that lives


def apex(script: str, seed: int = 1) -> Floats:
    """The lip corner from a second after the start to the fifth."""
    return channel(played(f"{script}\nwait 5s\n", seed), CORNER, grid(5.0))[1100:]


def test_a_spontaneous_apex_lives_and_no_other_does() -> None:
    felt = apex("show smile 70%, spontaneous")
    assert 0.02 < np.ptp(felt) / felt.mean() < 0.13
    assert np.ptp(apex("show smile 70%, posed")) == np.ptp(apex("show smile 70%")) == 0.0


def test_it_is_the_same_on_both_sides() -> None:
    performance = played("show smile, spontaneous\nwait 4s\n")
    sides = (channel(performance, f"cheek.lower.{side}", grid(4.0)) for side in ("left", "right"))
    assert np.array_equal(*sides)


def test_it_comes_from_the_seed_and_from_its_place_alone() -> None:
    felt = apex("show smile, spontaneous")
    assert np.array_equal(felt, apex("show smile, spontaneous"))
    assert not np.array_equal(felt, apex("show smile, spontaneous", seed=2))
    assert np.array_equal(felt, apex("at 500ms: add AU4, spontaneous\nnod for 0ms\nshow smile, spontaneous"))
    one, other = (traced("show smile, spontaneous\nwait 2s\n" * 2)[first + 1000 : first + 2900] for first in (0, 3000))
    assert not np.allclose(one, other, atol=1e-4)


def test_any_order_and_any_chunk_give_the_same() -> None:
    performance = played("show smile, spontaneous\nwait 3s\nadd brows, spontaneous for 2s\nwait 4s\n")
    times = np.random.default_rng(1).permutation(grid(9.0, 50.0))
    whole = performance.sample(times)
    for index, time in enumerate(times):
        assert np.array_equal(list(performance.pose(time).values()), whole[index])


# ------------------------------------------------------------------------------------------------ interruptions

NAMES = ["cheek.lower.left", "cheek.lower.right", "brow.inner.left", "head.roll"]
LENGTHS = st.integers(1, 12).map(lambda tick: tick / 8.0)
MANNERS: list[Manner] = ["", "posed", "spontaneous"]


@st.composite
def interrupted(draw: st.DrawFn, eases: tuple[str | None, ...]) -> tuple[TimedAct, ...]:
    """Shows, adds and drops that come in on each other, all with some length."""
    made: list[TimedAct] = []
    for order in range(draw(st.integers(2, 6))):
        moved = draw(st.sets(st.sampled_from(NAMES), min_size=1))
        terms = [term(f"t{index}", {name: draw(st.floats(-1, 1))}) for index, name in enumerate(sorted(moved))]
        timing = Timing(
            draw(LENGTHS),
            draw(st.none() | LENGTHS),
            draw(LENGTHS),
            draw(st.sampled_from(eases)),
            draw(st.sampled_from(MANNERS)),
        )
        made.append(act(draw(st.sampled_from([Show, Add]))(mix(*terms), timing), draw(LENGTHS), order))
        if draw(st.booleans()):
            keys = [(order, index) for index in range(len(terms)) if draw(st.booleans())]
            made.append(act(Drop("t0", Timing(draw(LENGTHS))), made[-1].start + draw(LENGTHS), 100 + order, drops=keys))
    return tuple(sorted(made, key=lambda each: (each.start, each.order)))


def bend(acts: tuple[TimedAct, ...], rate: float) -> float:
    """The greatest change of what is asked from one step to the next: with a quarter of the time between samples it is
    a 16th where speed is continuous, a quarter where it jumps, as much as before where a value does."""
    asked = Expression(acts, 0.0, 6.0).at(grid(6.0, rate))
    return float(np.abs(np.diff(asked, 2)).max())


@settings(max_examples=30, deadline=None)
@given(interrupted((None, "smooth", "out", "in", "in-out")))
def test_interruptions_jump_neither_in_value_nor_in_speed(acts: tuple[TimedAct, ...]) -> None:
    assert bend(acts, 4000.0) <= 0.1 * bend(acts, 1000.0) + 1e-12


def test_a_linear_change_does_jump_in_speed() -> None:
    acts = (act(Show(mix({CORNER: 1.0}), Timing(0.5, None, 0.4, "linear")), 1.0),)
    assert bend(acts, 4000.0) > 0.2 * bend(acts, 1000.0)


@pytest.mark.parametrize("later", ["show", "add"])
@pytest.mark.parametrize("manner", ["", ", posed", ", spontaneous"])
def test_sides_and_degrees_go_on_from_where_they_are(later: str, manner: str) -> None:
    script = f"{later} smile.left 60% + smile.right 20%{manner}\nat 250ms: {later} smile.left 10% + smile.right 70%\n"
    for side in ("left", "right"):
        values = traced(script, f"cheek.lower.{side}")
        alone = traced(f"{later} smile.left 60% + smile.right 20%{manner}\n", f"cheek.lower.{side}")
        assert np.array_equal(values[:250], alone[:250])
        assert abs(values[251] - values[250] - (values[250] - values[249])) < 1e-4


def test_a_drop_takes_a_living_apex_away_without_a_jump() -> None:
    values = traced("show smile, spontaneous\nwait 1s\ndrop smile\nwait 500ms\n")
    assert values[2500:].max() == 0.0 < values[2400]
    assert np.abs(np.diff(values, 2)).max() < 2e-5
