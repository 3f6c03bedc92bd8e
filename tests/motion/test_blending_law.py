"""The six rules of the blending law (`language.md` 9), and what holds besides, as properties of random performances."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scripted import (
    ADDS,
    BLINKS,
    FACE_SUM,
    FACES,
    GAZES,
    LENGTHS,
    LIVES,
    MOVES,
    SHOWS,
    SPELLS,
    Played,
    played,
    script,
    scripts,
    spoken,
    statements,
    turns,
)

from facescript.motion.compose import BLINK_TURN, TURNS
from facescript.motion.drivers import ROWS
from facescript.motion.gaze.track import GazeTrack, eyes
from facescript.performance.channels import INDEX, MOUTH, MUSCLES, SIDES
from facescript.performance.limits import KNEE, LID_FLOOR
from facescript.speech.mouth.mouthing import CLOSING
from facescript.speech.mouth.shape import AXES

TIMES = np.arange(0.0, 4.5, 0.001)
COARSE = np.arange(0.0, 4.5, 0.02)
MUSCLE_NAMES = [f"{muscle}.{side}" for muscle in MUSCLES for side in SIDES]
MUSCLE_ROWS = [INDEX[name] for name in MUSCLE_NAMES]

EYES = [f"eye.{side}.{axis}" for side in SIDES for axis in ("yaw", "pitch")]
GAZE = ["gaze.yaw", "gaze.pitch"]
HEAD = ["head.yaw", "head.pitch", "head.roll"]


def limited(total: np.ndarray) -> np.ndarray:
    """The soft limit, written out."""
    bent = KNEE + (1.0 - KNEE) * np.tanh((total - KNEE) / (1.0 - KNEE))
    return np.where(total <= KNEE, np.maximum(total, 0.0), bent)


def muscles(text: str) -> np.ndarray:
    """The muscles of a script as drawn, array[muscle, time]."""
    return played(text).motion.sample(COARSE).T[MUSCLE_ROWS]


# ------------------------------------------------------------------------------------------------ rule 1


@settings(max_examples=15, deadline=None)
@given(statements(ADDS, 4, 0), statements(ADDS, 4, 0), st.randoms(use_true_random=False))
def test_what_is_added_adds_up_under_the_soft_limit(one: list[str], other: list[str], random: object) -> None:
    """Halves of everything keep each muscle below the bend, so that what is drawn is the sum."""
    asked = [played(script(lines)).motion.asked(COARSE).expression[MUSCLE_ROWS] for lines in (one, other)]
    both = [*one, *other]
    random.shuffle(both)
    drawn = muscles(script(both))
    assert drawn == pytest.approx(limited(asked[0] + asked[1]), abs=1e-9)
    for lines, alone in zip((one, other), asked, strict=True):
        assert muscles(script(lines)) == pytest.approx(limited(alone), abs=1e-9)


@settings(max_examples=15, deadline=None)
@given(st.lists(FACE_SUM.map("add {}".format), min_size=2, max_size=5), st.integers(0, 100), st.data())
def test_the_order_of_what_is_added_at_once_does_not_matter(adds: list[str], start: int, data: st.DataObject) -> None:
    mixed = data.draw(st.permutations(adds))
    drawn = [muscles(script([f"at {start * 10}ms: {add}" for add in each])) for each in (adds, mixed)]
    assert drawn[0] == pytest.approx(drawn[1], abs=1e-12)


# ------------------------------------------------------------------------------------------------ rule 2


@settings(max_examples=25, deadline=None)
@given(scripts())
def test_lids_are_never_past_shut_nor_below_their_floor(text: str) -> None:
    drawn = played(text).channels(COARSE)
    for side in SIDES:
        assert drawn[f"lid.{side}"].min() >= LID_FLOOR and drawn[f"lid.{side}"].max() <= 1.0


@settings(max_examples=15, deadline=None)
@given(statements(st.one_of(GAZES, SPELLS, SHOWS.filter(lambda show: " - " not in show))), st.sampled_from(LIVES))
def test_a_shut_lid_stays_shut_wherever_the_eye_turns(lines: list[str], life: str) -> None:
    drawn = played(script(["add blink over 0ms", *lines], life)).channels(COARSE[1:])
    assert drawn["lid.left"].min() == drawn["lid.right"].min() == 1.0


@settings(max_examples=15, deadline=None)
@given(statements(BLINKS, 4, 0))
def test_blinks_that_overlap_multiply_what_they_leave_open(lines: list[str]) -> None:
    row = ROWS["blink.left"]
    alone = [played(script([line])).motion.asked(COARSE).gestures[row] for line in lines]
    shut = 1.0 - np.prod([1.0 - each for each in alone], axis=0)
    assert played(script(lines)).motion.asked(COARSE).gestures[row] == pytest.approx(shut, abs=1e-12)


# ------------------------------------------------------------------------------------------------ rules 3 and 4


@settings(max_examples=25, deadline=None)
@given(statements(st.one_of(FACES, SPELLS)), spoken(), st.sampled_from((24.0, 30.0, 60.0, 1000.0)))
def test_p_b_and_m_close_whatever_the_face_shows(lines: list[str], said: list[str], rate: float) -> None:
    """At every rate: a row that falls into a closure has lips that are closed, or as good as closed."""
    made = played(script([*lines, *said], "conversation"))
    times = np.arange(0.0, made.score.duration, 1.0 / rate)
    gap, track = made.channels(times)["mouth.open"], made.motion.mouth
    for shape in track.shapes:
        if shape.name == "m":
            assert np.abs(gap[(times >= shape.on) & (times <= shape.off)]).max(initial=0.0) == 0.0
    shut = [shape for shape in track.shapes if shape.name == "m"]
    for line in made.score.lines:
        for phone in line.spoken.phones:
            if phone.symbol in ("p", "b", "m"):
                burst = line.start + (phone.end if phone.symbol == "m" else phone.start)
                assert any(s.on <= burst and s.off >= burst - CLOSING - 0.03 for s in shut), (phone, burst)


@settings(max_examples=25, deadline=None)
@given(spoken())
def test_at_most_two_mouth_shapes_weigh(said: list[str]) -> None:
    """On each axis what is spoken lies on the way from one shape that holds it to the next one that does."""
    made = played(script(said))
    track = made.motion.mouth
    for axis, parts in AXES.items():
        held = np.flatnonzero([shape.holds(axis) for shape in track.shapes])
        firsts, seconds, share = track.weights(TIMES, parts[0])
        steps = np.searchsorted(held, seconds) - np.searchsorted(held, firsts)
        assert not held.size or np.isin(np.concatenate([firsts, seconds]), held).all()
        assert np.isin(steps, (0, 1)).all() and np.all((share >= 0.0) & (share <= 1.0))
        columns = [MOUTH.index(part) for part in parts]
        for shape in (track.shapes[index] for index in held):
            there = np.array([shape.on - 1e-7, shape.on, (shape.on + shape.off) / 2.0, shape.off, shape.off + 1e-7])
            alone = np.tile(np.array(shape.values)[columns], (5, 1))
            assert track.sample(there)[0][:, columns] == pytest.approx(alone, abs=1e-5), "it is there alone"


# ------------------------------------------------------------------------------------------------ rule 5


AIMS = ("at camera", "at lamp", "at shelf", "at floor", "at cup", "left 30deg", "up 15deg", "down 10deg")
PARTS = ("", ", eyes only", ", head only", ", head then eyes", ", head 40%")


@settings(max_examples=20, deadline=None)
@given(FACE_SUM, FACE_SUM, st.integers(0, 100), st.integers(1, 60), LENGTHS, statements(ADDS, 3, 0))
def test_a_later_show_has_the_base_and_the_older_one_comes_back(
    older: str, newer: str, first: int, after: int, length: str, beside: list[str]
) -> None:
    """At any time the base is the older one's as far as the newer one leaves it; a head that is moved tells how far."""
    a, b = f"at {first * 10}ms: show {older}", f"at {(first + after) * 10}ms: show {newer} + head.x 1cm{length}"
    shown = [played(script([*lines, *beside])).motion.asked(COARSE).expression for lines in ([a, b], [a], [b], [])]
    both, without, alone, added = shown
    weight = alone[INDEX["head.x"]]
    assert both == pytest.approx(added + (without - added) * (1.0 - weight) + (alone - added), abs=1e-9)
    assert weight.max() > 0.9 and ("for" not in length or weight[-1] == 0.0)


@settings(max_examples=25, deadline=None)
@given(
    st.sampled_from(AIMS), st.sampled_from(PARTS), st.sampled_from(AIMS), st.sampled_from(PARTS),
    st.integers(0, 100), st.integers(1, 100), st.integers(150, 250),
)  # fmt: skip
def test_a_later_look_has_the_parts_it_uses_and_the_older_one_comes_back(
    older: str, own: str, newer: str, parts: str, first: int, after: int, lasts: int
) -> None:
    start = (first + after) / 100
    a = f"at {first * 10}ms: look {older}{own}"
    b = f"at {(first + after) * 10}ms: look {newer} for {lasts * 10}ms{parts}"
    both, without, alone = (played(script(lines, length=7.0)).motion.gaze for lines in ([a, b], [a], [b]))
    there, gone = np.array([start + lasts / 100 - 0.001]), np.array([6.9])
    looks, head = (without if only in parts else alone for only in ("head only", "eyes only"))
    if follows(both, there) and follows(looks, there):
        assert both.sight(there)[:, :2] == pytest.approx(looks.sight(there)[:, :2], abs=1e-9)
    assert both.head(there) == pytest.approx(head.head(there), abs=1e-9)
    assert both.sight(gone) == pytest.approx(without.sight(gone), abs=1e-9)
    assert both.head(gone) == pytest.approx(without.head(gone), abs=1e-9)


def follows(gaze: GazeTrack, times: np.ndarray) -> bool:
    """Whether no eye is near the end of its reach: there it waits for the head."""
    turned = np.concatenate([gaze.head(times), np.zeros((len(times), 1))], axis=1)
    yaw, pitch = np.moveaxis(eyes(gaze.sight(times), turned)[..., :2], -1, 0)
    return bool(np.hypot(yaw / 45.0, pitch / np.where(pitch > 0.0, 28.0, 47.0)).max() < 0.85)


# ------------------------------------------------------------------------------------------------ rule 6


STEADY = ("calm, avert 0%", "conversation, avert 0%", "reading, avert 0%", "announcer")
HEAD_MOVES = st.one_of(MOVES, turns().filter(lambda turn: "head" in turn))

PULL = hypot(*BLINK_TURN)
"""Deg that a blink turns an eye; it does so once it has shut as far as `TURNS`."""


@settings(max_examples=25, deadline=None)
@given(
    statements(GAZES, 5, 0), statements(HEAD_MOVES, 3, 0), st.sampled_from(STEADY),
    st.integers(0, 1000),
)  # fmt: skip
def test_gaze_stays_on_its_target_through_any_gesture_and_life(
    looks: list[str], moves: list[str], life: str, seed: int
) -> None:
    """Where the looks alone would have it, to a degree and the blink's pull, while the eyes are well within reach."""
    moved, alone = played(script([*looks, *moves], life, seed)), played(script(looks, seed=seed))
    asked = moved.motion.asked(COARSE)
    blink = np.maximum(*(np.clip(asked.sum[ROWS[f"blink.{side}"]], 0.0, 1.0) for side in SIDES))
    drawn, meant = moved.channels(COARSE), alone.channels(COARSE)
    reached = within_reach(drawn) & within_reach(meant)
    off = np.hypot(*(drawn[name] - meant[name] for name in GAZE))
    assert np.all(off[reached] <= 1.0 + PULL * (blink[reached] > TURNS))


def within_reach(drawn: dict[str, np.ndarray]) -> np.ndarray:
    """When neither eye is near the end of its reach."""
    near = np.zeros(len(COARSE), dtype=bool)
    for side in SIDES:
        pitch = drawn[f"eye.{side}.pitch"]
        near |= np.hypot(drawn[f"eye.{side}.yaw"] / 45.0, pitch / np.where(pitch > 0.0, 28.0, 47.0)) > 0.9
    return ~near


# ------------------------------------------------------------------------------------------------ continuity


GAZE_STEP, HEAD_STEP = 0.75, 0.32
"""Deg from row to row at 1000 Hz at most."""

EYE_JOLT, HEAD_JOLT = 100.0, 10.0
"""Deg/s that the speed changes by from row to row at most."""


def smooth_enough(made: Played) -> None:
    drawn = made.channels(TIMES)
    for name in (*GAZE, *EYES, *HEAD):
        steps = np.diff(drawn[name])
        step, jolt = np.abs(steps).max(), np.abs(np.diff(steps)).max() * 1000.0
        head = name in HEAD
        assert head or name in EYES or step <= GAZE_STEP, (name, step)
        assert not head or step <= HEAD_STEP, (name, step)
        assert jolt <= (HEAD_JOLT if head else EYE_JOLT), (name, jolt)


SHAKEN = (
    ["at 0ms: look at camera", "at 1160ms: glance fly", "at 10ms: look at shelf, head only",
     "at 20ms: scan crowd, 300ms each", "at 30ms: scan crowd, 300ms each", "at 1050ms: shake"],
    ["at 0ms: look at camera", "at 1160ms: glance camera", "at 10ms: look at shelf, head only",
     "at 20ms: glance shelf", "at 30ms: shake"],
)  # fmt: skip
"""A shake while gaze turns the head, to the end of its range."""


@settings(max_examples=40, deadline=None)
@given(scripts())
@example(script(SHAKEN[0]))
@example(script(SHAKEN[1]))
def test_nothing_jumps_or_jolts(text: str) -> None:
    smooth_enough(played(text))


@settings(max_examples=30, deadline=None)
@given(statements(GAZES, 12, 0))
@example(
    ["at 10ms: glance shelf for 300ms, head 1%", "at 0ms: glance fly, head 88%", "at 20ms: glance shelf for 300ms"]
)
def test_no_storm_of_looks_jumps_or_jolts(lines: list[str]) -> None:
    smooth_enough(played(script(lines)))


FAR = ("left 88deg", "up 58deg", "down 70deg", "left 60deg up 40deg", "right 50deg")


@pytest.mark.parametrize("aim", FAR)
@pytest.mark.parametrize("parts", PARTS)
def test_nothing_strikes_the_end_of_its_reach(aim: str, parts: str) -> None:
    """Eyes that are called beyond their reach, and a head that nods, shakes and tilts at the end of its own."""
    lines = [
        f"look {aim}{parts}",
        *(f"at {start}s: {move}" for start, move in ((1, "shake"), (2, "nod"), (3, "tilt left"))),
    ]
    smooth_enough(played(script(lines)))


# ------------------------------------------------------------------------------------------------ purity


@settings(max_examples=15, deadline=None)
@given(scripts(), st.integers(1, 200), st.randoms(use_true_random=False))
def test_any_chunks_order_and_rate_give_the_same_finite_values(text: str, size: int, random: object) -> None:
    motion = played(text).motion
    times = np.arange(0.0, 4.5, 1 / 60)
    whole = motion.sample(times)
    assert np.isfinite(whole).all()
    chunks = [motion.sample(times[first : first + size]) for first in range(0, len(times), size)]
    assert np.array_equal(np.concatenate(chunks), whole)
    order = list(range(len(times)))
    random.shuffle(order)
    assert np.array_equal(motion.sample(times[order]), whole[order])
    assert np.array_equal(motion.sample(times[::7]), whole[::7])
    assert played(text).motion.sample(times).tobytes() == whole.tobytes()
