"""Laws of a face's gaze over time: it never jumps, looks come back, and it is a function of time alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bars import Trace, largest_step, vergence
from gazing import face, film, moving, request, score, target, trace
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.ir.acts import GazeManner
from facescript.ir.values import AtCamera, Towards
from facescript.motion.gaze.aims import in_effect
from facescript.motion.gaze.track import GazeTrack
from facescript.schedule.score import Score, TimedAct, TimedScene
from facescript.space.planner import GazeRequest

PARTS = ("eyes then head", "head then eyes", "eyes only", "head only")
VISITOR = moving("visitor", [(0.2, -25, -5), (1.2, 20, 10), (2.0, 0, 0)])

aims = st.one_of(st.builds(Towards, st.floats(-60, 60), st.floats(-40, 35)), st.just(AtCamera()), st.just("visitor"))
looks = st.lists(
    st.tuples(
        aims,
        st.sampled_from(PARTS),
        st.floats(0.0, 2.0),
        st.one_of(st.none(), st.floats(0.05, 1.0)),
        st.one_of(st.none(), st.floats(0.05, 1.5)),
        st.booleans(),
    ),
    min_size=1,
    max_size=6,
)


def requests(drawn: list[tuple]) -> list[GazeRequest]:
    found = []
    for order, (aim, parts, start, over, lasts, glance) in enumerate(drawn):
        released = np.inf if lasts is None else start + lasts
        more = {"over": over, "released": released, "glance": glance}
        found.append(request(order, aim, start, GazeManner(parts), **more))
    return found


@settings(max_examples=60, deadline=None)
@given(looks)
def test_no_sequence_of_looks_jumps_or_jolts(drawn: list[tuple]) -> None:
    """A jump, or a jump of speed, would be as large on a grid 16 times as fine; a smooth movement's step is not."""
    coarse = trace([VISITOR], requests(drawn), 3.5, rate=1000)
    fine = trace([VISITOR], requests(drawn), 3.5, rate=16000)
    for name in ("head.yaw", "head.pitch", "eye.left.yaw", "eye.right.pitch"):
        assert largest_step(fine.channels[name]) <= 0.2 * largest_step(coarse.channels[name]) + 0.01, name
        jolts = [largest_step(each.speed(each.channels[name])) for each in (coarse, fine)]
        assert jolts[1] <= 0.6 * jolts[0] + 2.0, name


@settings(max_examples=25, deadline=None)
@given(looks, st.randoms(use_true_random=False))
def test_any_times_in_any_order_give_the_same(drawn: list[tuple], random: object) -> None:
    made = score([VISITOR], requests(drawn), face(), film(), 3.5)
    times = np.linspace(0, 3.4, 120)
    whole = GazeTrack(made, face()).sight(times)
    mixed = list(range(len(times)))
    random.shuffle(mixed)
    other = GazeTrack(made, face())
    assert np.array_equal(np.stack([other.sight(times[[index]])[0] for index in mixed]), whole[mixed])
    assert np.array_equal(other.head(times[mixed]), GazeTrack(made, face()).head(times)[mixed])


def settled(seen: Trace, time: float) -> tuple[float, float]:
    """Gaze and head yaw at a time, rounded."""
    at = round(time * 1000)
    return round(float(seen.gaze("yaw")[at]), 1), round(float(seen.head("yaw")[at]), 1)


def test_until_told_a_face_looks_at_the_camera() -> None:
    seen = trace([], [], 0.5)
    assert largest_step(seen.gaze("yaw")) == 0
    assert settled(seen, 0.3) == (0.0, 0.0)
    assert vergence(seen)[0] == pytest.approx(2 * np.degrees(np.arctan(3.15 / 60)), abs=0.01)


def test_eyes_only_leaves_the_head_with_its_older_goal() -> None:
    seen = trace([], [request(0, Towards(30, 0), 0), request(1, Towards(0, 0), 0.1, GazeManner("eyes only"))], 2.0)
    assert settled(seen, 1.5) == (0.0, 20.7)


def test_head_only_leaves_the_eyes_on_what_they_look_at() -> None:
    seen = trace([], [request(0, Towards(10, 0), 0), request(1, Towards(-20, 0), 0.8, GazeManner("head only"))], 2.0)
    assert settled(seen, 1.9) == (10.0, -20.0)
    assert np.abs(seen.gaze("yaw")[200:] - 10).max() < 0.3


def test_head_then_eyes_moves_the_head_first() -> None:
    seen = trace([], [request(0, Towards(30, 0), 0.2, GazeManner("head then eyes"))], 2.0)
    gaze = seen.times[np.flatnonzero(np.abs(seen.gaze("yaw")) > 1)[0]]
    head = seen.times[np.flatnonzero(np.abs(seen.head("yaw")) > 1)[0]]
    assert head < gaze - 0.05
    assert settled(seen, 1.9) == (30.0, 20.7)


def test_the_share_of_the_head_is_the_authors() -> None:
    seen = trace([], [request(0, Towards(30, 0), 0.2, GazeManner(head_share=0.4))], 2.0)
    assert settled(seen, 1.9) == (30.0, 12.0)


def test_a_look_with_for_gives_back_what_it_covered() -> None:
    asked = [request(0, Towards(30, 0), 0), request(1, Towards(-20, 0), 1.0, released=2.0)]
    seen = trace([], asked, 4.0)
    assert settled(seen, 1.9) == (-20.0, -13.8)
    assert settled(seen, 3.5) == (30.0, 20.7)


def test_a_later_look_is_not_undone_by_an_older_one_that_lets_go() -> None:
    asked = [request(0, Towards(30, 0), 0, released=1.0), request(1, Towards(-20, 0), 0.5)]
    assert settled(trace([], asked, 3.0), 2.5) == (-20.0, -13.8)


def test_a_glance_comes_back_and_leaves_the_head_nearly_still() -> None:
    seen = trace([], [request(0, Towards(12, 0), 0.2, released=0.7, glance=True)], 2.0)
    assert settled(seen, 0.6) == (12.0, 0.0)
    assert settled(seen, 1.5) == (0.0, 0.0)


def test_over_0ms_is_at_once_and_over_900ms_takes_that_long() -> None:
    at_once = trace([], [request(0, Towards(30, 0), 0.5, over=0.0)], 1.0)
    assert (settled(at_once, 0.499), settled(at_once, 0.501)) == ((0.0, 0.0), (30.0, 20.7))
    slowly = trace([], [request(0, Towards(30, 0), 0.5, over=0.9)], 2.0)
    assert settled(slowly, 1.0)[0] < 29
    assert settled(slowly, 1.401) == (30.0, 20.7)


def test_an_interrupted_slow_look_does_not_go_on() -> None:
    asked = [request(0, Towards(40, 0), 0, over=5.0), request(1, Towards(-10, 0), 1.0)]
    assert settled(trace([], asked, 4.0), 2.0) == (-10.0, -6.9)


def test_latency_delays_and_speed_slows() -> None:
    late = trace([], [request(0, Towards(20, 0), 0.2, GazeManner("eyes only", latency=0.15))], 1.0)
    assert settled(late, 0.349)[0] == 0.0
    assert settled(late, 0.44)[0] == 20.0
    slow = trace([], [request(0, Towards(20, 0), 0.2, GazeManner("eyes only", speed=0.5))], 1.0)
    assert slow.speed(slow.gaze("yaw")).max() == pytest.approx(late.speed(late.gaze("yaw")).max() / 2, rel=0.15)


def test_a_near_target_is_converged_on_more_slowly_than_the_eyes_get_there() -> None:
    seen = trace([target("cup", 5, 0, 20)], [request(0, "cup", 0.2)], 2.0)
    angle = vergence(seen)
    assert angle[300] < 0.8 * angle[-1]
    assert angle[-1] == pytest.approx(2 * np.degrees(np.arctan(3.15 / 20)), abs=0.2)


def test_every_scene_begins_at_the_camera_and_with_its_targets_at_their_start() -> None:
    first = score([VISITOR], [request(0, "visitor", 0.1)], face(), film(), 3.0)
    again: tuple[TimedAct, ...] = tuple(
        replace(act, scene=1, order=9, start=act.start + 3, plan=tuple(_later(plan, 3.0) for plan in act.plan))
        for act in first.acts
    )
    scenes = (*first.scenes, TimedScene("more", ("ada",), 3.0, 6.0))
    both: Score = replace(first, acts=first.acts + again, scenes=scenes, duration=6.0)
    track = GazeTrack(both, face())
    times = np.linspace(0, 2.9, 200)
    assert track.sight(times + 3.0) == pytest.approx(track.sight(times), abs=1e-6)
    assert track.sight(np.array([3.0]))[0, :2] == pytest.approx([0, 0], abs=1e-9)


def _later(plan: object, by: float) -> object:
    times = ("eye_onset", "eye_done", "landed", "head_onset", "head_done")
    return replace(plan, **{name: getattr(plan, name) + by for name in times})


def test_what_is_overtaken_before_it_sets_off_never_does() -> None:
    asked = [request(0, Towards(10, 0), 0.0), request(1, Towards(-50, 0), 0.1)]
    first, second = (act.plan[0] for act in score([], asked, face(), film(), 1.0).acts)
    assert second.head_onset < first.head_onset
    assert in_effect([first, second], lambda plan: plan.head_onset) == [second]
    assert in_effect([first, second], lambda plan: plan.eye_onset) == [first, second]
