"""Whole performances: functions of time, afresh in every scene, each channel the sum of its parts under the law."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bars import bar
from hypothesis import given, settings
from hypothesis import strategies as st
from performing import FROWN, SMILE, add, channels, gesture, grid, line, performed, score, show

from facescript.ir.acts import Life, Voice
from facescript.ir.play import Face
from facescript.motion.mouth import MouthTrack
from facescript.motion.perform import perform
from facescript.performance.channels import NAMES
from facescript.performance.limits import LID_GAIN, LID_TRAVEL
from facescript.schedule.score import TimedAct, TimedScene

LIVELY = Life(
    "conversation",
    (("blink", 30.0), ("brows", 12.0), ("sway", 1.0), ("nods", 1.0), ("saccades", 90.0), ("avert", 0.4)),
)
SPEECH = line(2.0, ("m", 0.1), ("ɑ", 0.2), ("", 0.3), ("p", 0.1), ("i", 0.2), ("b", 0.1), ("u", 0.3))
BUSY = (
    show(0.5, SMILE),
    gesture(1.0, "nod", {"head.pitch": -9.0}, order=1),
    add(1.2, {"brow.inner.left": 0.9, "mouth.jaw": 0.3, "eye.left.yaw": 4.0}, order=2, lasting=2.0),
    gesture(1.4, "wink", {"blink.right": 1.0}, order=3, lasting=0.4),
    show(2.5, FROWN, order=4, lasting=1.0),
    add(3.0, {"head.roll": 12.0, "head.scale": 0.1, "lid.left": 0.4}, order=5),
)


def busy(life: Life = LIVELY) -> object:
    return performed(*BUSY, duration=8.0, life=life, lines=(SPEECH,))


# ------------------------------------------------------------------------------------------------ a function of time


@pytest.mark.parametrize("size", [1, 2, 3, 7, 64, 500])
def test_chunks_give_the_same_to_the_bit(size: int) -> None:
    times = grid(8.0, 60.0)
    performance = busy()
    whole = performance.sample(times)
    parts = [performance.sample(times[at : at + size]) for at in range(0, len(times), size)]
    assert np.array_equal(np.concatenate(parts), whole)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.floats(-1.0, 10.0), min_size=1, max_size=40))
def test_any_times_in_any_order_give_the_same(times: list[float]) -> None:
    performance = busy()
    together = performance.sample(np.array(times))
    alone = np.concatenate([performance.sample(np.array([time])) for time in times])
    assert np.array_equal(together, alone)


def test_the_same_score_gives_the_same_bytes() -> None:
    times = grid(8.0, 60.0)
    assert busy().sample(times).tobytes() == busy().sample(times).tobytes()


def test_a_pose_has_every_channel_by_name() -> None:
    assert tuple(busy().pose(1.0)) == NAMES


def test_no_times_give_no_frames() -> None:
    assert busy().sample(np.array([])).shape == (0, len(NAMES))


def test_nothing_jumps() -> None:
    rate = 2000.0
    frames = busy().sample(grid(8.0, rate))
    speed = np.diff(frames, axis=0) * rate
    fastest = np.abs(speed).max(axis=0)
    corner = np.abs(np.diff(speed, axis=0)).max(axis=0)
    for name, top, bend in zip(NAMES, fastest, corner, strict=True):
        assert bend <= max(0.25 * top, 0.05), name


# ------------------------------------------------------------------------------------------------ scenes and faces


def test_every_scene_begins_afresh() -> None:
    scenes = TimedScene("one", ("ada",), 0.0, 2.0), TimedScene("two", ("ada",), 2.0, 4.0)
    smiling, nodding = show(0.0, SMILE, over=0.0), gesture(1.8, "nod", {"head.pitch": -9.0}, order=1)
    frames = perform(score([smiling, nodding], scenes=scenes)).sample(np.array([1.9, 1.999, 2.0, 3.0]))
    rest = performed().sample(np.array([0.0]))[0]
    assert not np.array_equal(frames[1], rest)
    assert np.array_equal(frames[2], rest) and np.array_equal(frames[3], rest)


def test_scenes_live_differently_and_one_played_again_lives_anew() -> None:
    named = [TimedScene(name, ("ada",), at, at + 4.0) for name, at in (("one", 0.0), ("two", 4.0), ("one", 8.0))]
    frames = perform(score(duration=12.0, life=LIVELY, scenes=named)).sample(grid(12.0, 60.0))
    first, second, third = np.split(frames, 3)
    assert not np.array_equal(first, second) and not np.array_equal(first, third)


def test_a_scene_put_before_leaves_a_scenes_life_as_it_is() -> None:
    later = [TimedScene("new", ("ada",), 0.0, 4.0), TimedScene("one", ("ada",), 4.0, 8.0)]
    alone = perform(score(duration=4.0, life=LIVELY, scenes=[TimedScene("one", ("ada",), 0.0, 4.0)]))
    after = perform(score(duration=8.0, life=LIVELY, scenes=later))
    assert after.sample(4.0 + grid(4.0, 60.0)) == pytest.approx(alone.sample(grid(4.0, 60.0)), abs=1e-9)


def test_a_face_outside_the_scene_is_neutral_and_an_unseen_one_is_not_performed() -> None:
    made = score([show(0.0, SMILE)], life=LIVELY)
    other = replace(made.faces[0], name="bruno")
    voice = replace(made.faces[0], name="narrator", kind="unseen")
    performance = perform(replace(made, faces=(*made.faces, other, voice)))
    assert list(performance.faces) == ["ada", "bruno"]
    still = performance.sample_face("bruno", grid(4.0, 30.0))
    assert len(np.unique(still, axis=0)) == 1


def test_two_faces_have_lives_of_their_own() -> None:
    made = score(life=LIVELY, scenes=[TimedScene("main", ("ada", "bruno"), 0.0, 4.0)])
    performance = perform(replace(made, faces=(made.faces[0], replace(made.faces[0], name="bruno"))))
    one, other = (performance.sample_face(name, grid(4.0, 30.0)) for name in ("ada", "bruno"))
    assert not np.array_equal(one, other)


def test_the_last_scene_holds_its_end() -> None:
    performance = performed(show(0.0, SMILE), duration=2.0)
    assert np.array_equal(*performance.sample(np.array([1.99, 2.5])))


# ------------------------------------------------------------------------------------------------ the sum of the parts


def test_smile_wink_and_a_turn_of_the_head_at_once_are_each_what_they_are_alone() -> None:
    smile, wink = show(0.5, SMILE), gesture(0.6, "wink", {"blink.left": 1.0, "cheek.upper.left": 0.3}, order=1)
    turn = add(0.5, {"head.yaw": 12.0}, order=2, lasting=1.0)
    times = grid(3.0)
    drawn = channels(performed(smile, wink, turn), times)
    smiled, winked, turned, rest = (channels(performed(*acts), times) for acts in ((smile,), (wink,), (turn,), ()))
    assert np.array_equal(drawn["lid.left"], winked["lid.left"])
    assert np.array_equal(drawn["head.yaw"], turned["head.yaw"])
    assert np.array_equal(drawn["cheek.lower.right"], smiled["cheek.lower.right"])
    both = smiled["cheek.upper.left"] + winked["cheek.upper.left"]
    assert both.max() < 0.8 and drawn["cheek.upper.left"] == pytest.approx(both, abs=1e-12)
    for name in ("eye.left.yaw", "eye.right.yaw", "eye.left.pitch"):
        parts = winked[name] - rest[name] + turned[name]
        assert drawn[name] == pytest.approx(parts, abs=1e-9)
    untouched = set(NAMES) - {n for n in NAMES if n.startswith(("cheek", "lid", "head", "eye", "gaze"))}
    assert all(np.array_equal(drawn[name], rest[name]) for name in untouched)


POSES = st.floats(-12.0, 12.0)


@settings(max_examples=50, deadline=None)
@given(POSES, POSES, POSES, st.sampled_from(["nod", "shake", "tilt"]))
def test_gaze_stays_on_its_target_whatever_the_head_does(yaw: float, pitch: float, roll: float, kind: str) -> None:
    moved = gesture(0.2, kind, {"head.yaw": yaw, "head.pitch": pitch, "head.roll": roll}, lasting=1.0)
    drawn = channels(performed(moved), grid(1.5, 200.0))
    off = np.hypot(drawn["gaze.yaw"], drawn["gaze.pitch"])
    assert off.max() <= bar("H7", "mean error")[1]


@settings(max_examples=50, deadline=None)
@given(st.floats(-200.0, 200.0), st.floats(-200.0, 200.0), st.floats(-200.0, 200.0))
def test_the_head_never_leaves_its_range(yaw: float, pitch: float, roll: float) -> None:
    drawn = performed(add(0.0, {"head.yaw": yaw, "head.pitch": pitch, "head.roll": roll}, over=0.0)).pose(1.0)
    for axis, limit in (("yaw", 45.0), ("pitch", 30.0), ("roll", 30.0)):
        assert abs(drawn[f"head.{axis}"]) <= limit + 1e-9


def test_gestures_and_what_is_added_to_the_head_add_up() -> None:
    nod, tilted = gesture(0.5, "nod", {"head.pitch": -9.0}), add(0.0, {"head.pitch": 5.0}, order=1)
    both, one, other = (
        channels(performed(*acts), grid(2.0))["head.pitch"] for acts in ((nod, tilted), (nod,), (tilted,))
    )
    assert both == pytest.approx(one + other)


def test_channels_of_an_eye_add_to_its_gaze() -> None:
    drawn = performed(add(0.0, {"eye.left.yaw": 6.0, "eye.left.roll": 3.0, "pupil.right": 0.5}, over=0.0)).pose(1.0)
    rest = performed().pose(1.0)
    assert drawn["eye.left.yaw"] == pytest.approx(rest["eye.left.yaw"] + 6.0)
    assert drawn["eye.left.roll"] == pytest.approx(rest["eye.left.roll"] + 3.0)
    assert drawn["eye.right.yaw"] == rest["eye.right.yaw"] and drawn["pupil.right"] == 1.5


# ------------------------------------------------------------------------------------------------ lids


def test_a_lid_follows_the_eye_up_and_down() -> None:
    low, high = bar("B7", "static gain")
    for pitch in (-25.0, -10.0, 10.0):
        drawn = performed(add(0.0, {"eye.left.pitch": pitch, "eye.right.pitch": pitch}, over=0.0)).pose(1.0)
        assert low <= -drawn["lid.left"] * LID_TRAVEL / drawn["eye.left.pitch"] <= high
    assert low <= LID_GAIN <= high


def test_a_squint_and_a_blink_multiply() -> None:
    squint = add(0.0, {"lid.left": 0.5, "lid.right": 0.5}, over=0.0)
    drawn = channels(performed(squint, add(0.0, {"blink.left": 0.6}, order=1, over=0.0)), np.array([1.0]))
    assert drawn["lid.left"][0] == pytest.approx(1.0 - 0.5 * 0.4)
    assert drawn["lid.right"][0] == pytest.approx(0.5)


# ------------------------------------------------------------------------------------------------ speech


OPEN = {"mouth.open": 0.8, "mouth.jaw": 0.6, "mouth.wide": 0.2}


@settings(max_examples=30, deadline=None)
@given(
    st.dictionaries(
        st.sampled_from(["mouth.open", "mouth.jaw", "lip.press.left", "cheek.lower.left"]), st.floats(-1, 1)
    )
)
def test_p_b_and_m_close_whatever_the_face_shows(shown: dict[str, float]) -> None:
    times = grid(4.0)
    spoken, activity = MouthTrack((SPEECH,)).sample(times)
    shut = (spoken[:, 0] == 0.0) & (activity == 1.0)
    assert all(shut[round(1000 * burst) - 10 : round(1000 * burst)].any() for burst in (2.1, 2.6, 2.9))
    drawn = channels(performed(add(0.0, shown, over=0.0), lines=(SPEECH,)), times)
    assert set(drawn["mouth.open"][shut]) == {0.0}


def test_speech_owns_gap_and_jaw_while_it_sounds_and_gives_them_back() -> None:
    times = np.array([1.0, 2.25, 3.9])
    shown = channels(performed(add(0.0, OPEN, over=0.0), duration=8.0, lines=(SPEECH,)), times)
    plain = channels(performed(duration=8.0, lines=(SPEECH,)), times)
    assert shown["mouth.open"][[0, 2]].tolist() == [0.8, 0.8] and shown["mouth.jaw"][0] == 0.6
    assert plain["mouth.open"][1] < shown["mouth.open"][1] <= 1.4 * plain["mouth.open"][1]
    assert shown["mouth.wide"][1] == pytest.approx(plain["mouth.wide"][1] + 0.2)


def test_a_smile_does_not_stop_speech() -> None:
    times = grid(4.0, 60.0)
    smiling, plain = (channels(performed(*acts, lines=(SPEECH,)), times) for acts in ((show(0.0, SMILE),), ()))
    assert np.array_equal(smiling["mouth.open"], plain["mouth.open"])
    assert smiling["cheek.lower.left"][150] == pytest.approx(0.7)


def test_a_face_speaks_only_its_own_lines() -> None:
    made = score(lines=(replace(SPEECH, face="bruno"),))
    silent = perform(made).sample(grid(4.0, 30.0))
    assert len(np.unique(silent, axis=0)) == 1


# ------------------------------------------------------------------------------------------------ what is asked


def test_the_sources_can_be_asked_one_by_one() -> None:
    motion = busy().faces["ada"]
    asked = motion.asked(grid(8.0, 30.0))
    smile, brow = NAMES.index("cheek.lower.left"), NAMES.index("brow.inner.left")
    assert asked.expression[smile].max() == pytest.approx(0.7)
    assert not asked.life[smile].any() and not asked.gestures[smile].any()
    assert asked.life[brow].any() and asked.gestures[NAMES.index("head.pitch")].any()


def test_a_hundred_scenes_and_a_thousand_acts_are_no_trouble() -> None:
    scenes = [TimedScene(f"s{n}", ("ada",), 2.0 * n, 2.0 * n + 2.0) for n in range(100)]
    acts: list[TimedAct] = []
    for order in range(1000):
        made = add(order / 5.0, {"brow.inner.left": 0.01}, order=order)
        acts.append(replace(made, scene=order // 10))
    drawn = channels(perform(score(acts, 200.0, scenes=scenes)), np.array([1.999, 2.0, 199.999]))
    assert drawn["brow.inner.left"][[0, 2]] == pytest.approx([0.09, 0.09], abs=0.01)
    assert drawn["brow.inner.left"][1] == 0.0


def test_a_face_of_another_film_size_moves_alike() -> None:
    face = Face("ada", "woman", Voice(), LIVELY, score().faces[0].span, size=2.0)
    made = score(BUSY, 8.0, LIVELY)
    large = perform(replace(made, faces=(face,)))
    muscles = slice(NAMES.index("brow.inner.left"), NAMES.index("mouth.open"))
    times = grid(8.0, 30.0)
    assert np.array_equal(large.sample(times)[:, muscles], perform(made).sample(times)[:, muscles])
