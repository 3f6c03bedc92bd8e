"""Which shifts a face's looks become, what comes back after them, and what stays out of reach."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.diagnostics.model import Diagnostics, Severity
from facescript.ir.acts import GazeManner, Life, Scan, Voice
from facescript.ir.play import Crowd, Face, Film, FixedTarget, MovingTarget, Target
from facescript.ir.values import AtCamera, AtTarget, Away, Point, Towards
from facescript.space.haste import haste
from facescript.space.main_sequence import head_time, peak_fraction, saccade_part, saccade_time, velocity_shape
from facescript.space.plan import GazePlan
from facescript.space.planner import GazeRequest, plan_gaze
from facescript.space.reach import extent, head_goal, in_head, in_room, reach, shortfall
from facescript.space.room import Room
from facescript.space.scans import scan_stops
from facescript.text import Source, Span

SOURCE = Source("made.face", "look at door\nlook at window, eyes only\n")
HERE = Span(SOURCE, 0, 12)
ADA = Face("ada", "woman", Voice(), Life("still"), HERE)
TARGETS = (
    FixedTarget("lamp", Point(100, 0, 173.2), HERE),
    FixedTarget("door", Point(100, 0, -173.2), HERE),
    MovingTarget("visitor", (1.0, 5.0), (Point(0, 0, 100), Point(300, 0, -50)), HERE),
    Crowd("crowd", (Point(-60, 0, 200), Point(0, 5, 100), Point(50, 10, 300)), HERE),
)
ROOM = Room(Film(screen=1.0, seed=3), (ADA,), TARGETS)


def look(order: int, aim: object, start: float, parts: str = "eyes then head", **more: object) -> GazeRequest:
    aim = AtTarget(aim) if isinstance(aim, str) else aim
    return GazeRequest((order, 0), aim, GazeManner(parts), start, **more)


def plans(*requests: GazeRequest) -> dict[int, tuple[GazePlan, ...]]:
    return {key[0]: found for key, found in plan_gaze(ROOM, ADA, requests).items()}


def story(*requests: GazeRequest) -> list[str]:
    """Each shift in time as text: when, which parts, at what, when the eyes are there and the head."""
    found = [(plan.starts, key, plan) for key, each in plan_gaze(ROOM, ADA, requests).items() for plan in each]
    return [
        f"{start:.2f} {plan.parts} {_name(plan.aim)} eyes {plan.landed:.3f} head {plan.head_done:.3f}"
        for start, _, plan in sorted(found, key=lambda each: each[:2])
    ]


def _name(aim: object) -> str:
    if isinstance(aim, Towards):
        return f"{aim.yaw:.0f}"
    return aim.name if isinstance(aim, AtTarget) else "camera"


# ------------------------------------------------------------------------------------------------ timing


def test_a_look_lasts_by_its_size() -> None:
    plan = plans(look(0, Towards(20, 0), 1.0))[0][0]
    assert plan.amplitude == pytest.approx(20)
    assert plan.landed == pytest.approx(1.0 + 0.079)
    assert plan.head_onset == pytest.approx(1.0 + 0.1093, abs=1e-4)
    assert plan.head_done == pytest.approx(plan.head_onset + 0.300 + 0.0045 * 13.8)
    assert plan.head_share == (0.69, 0.08)


def test_landing_waits_for_the_head_where_the_eyes_alone_do_not_reach() -> None:
    plan = plans(look(0, Towards(60, 0), 0.0))[0][0]
    assert plan.eye_done == pytest.approx(0.187)
    assert plan.eye_done + 0.02 < plan.landed < plan.head_done


def test_over_latency_and_speed() -> None:
    assert plans(look(0, Towards(20, 0), 1.0, over=0.9))[0][0].landed == pytest.approx(1.9)
    instant = plans(look(0, Towards(20, 0), 1.0, over=0.0))[0][0]
    assert (instant.instant, instant.landed, instant.head_done) == (True, 1.0, 1.0)
    late = GazeRequest((0, 0), Towards(20, 0), GazeManner(latency=0.15, speed=0.5), 1.0)
    assert plans(late)[0][0].eye_onset == pytest.approx(1.15)
    assert plans(late)[0][0].landed == pytest.approx(1.15 + 2 * 0.079)


@pytest.mark.parametrize("parts", ["eyes then head", "head then eyes", "eyes only", "head only"])
@pytest.mark.parametrize("yaw", [2, 10, 40, 80])
def test_nobody_is_faster_than_eyes_and_head_can_be(parts: str, yaw: int) -> None:
    hurried = plans(look(0, Towards(yaw, 0), 1.0, parts, over=0.005))[0][0]
    assert hurried.needs > 0.005
    if hurried.uses_eyes:
        assert 1.65 * yaw / (hurried.eye_done - hurried.eye_onset) < 550.1
    if hurried.uses_head:
        turn = hurried.amplitude if parts == "head only" else min(40.0, yaw * hurried.head_share[0])
        assert 1.875 * turn / (hurried.head_done - hurried.head_onset) < 250.1
    assert plans(look(0, Towards(yaw, 0), 1.0, parts, over=1.0))[0][0].needs == 0.0


def test_a_look_that_is_to_be_too_fast_is_warned_of_once_a_place() -> None:
    diagnostics = Diagnostics()
    made = plans(look(0, Towards(20, 0), 0.0, over=0.01), look(1, Towards(-40, 0), 1.0, over=0.01))
    haste(Acts((Act(made[0], HERE), Act(made[1], HERE))), diagnostics)
    (told,) = diagnostics
    assert (told.code, told.severity) == ("FS607", Severity.WARNING)
    assert "for 60deg this takes 180ms" in told.message


def test_what_a_hurried_look_needs_is_what_it_takes_when_it_interrupts_another() -> None:
    """Two saccades at once are slower than each alone: what is told and what is done agree."""
    story = plans(look(0, Towards(30, 0), 0.0), look(1, Towards(-30, 0), 0.03, over=0.01))
    hurried, free = story[1][0], plans(look(1, Towards(-30, 0), 0.03, over=0.01))[1][0]
    assert hurried.needs == pytest.approx(hurried.eye_done - hurried.eye_onset)
    assert hurried.needs / hurried.amplitude > 1.1 * free.needs / free.amplitude


def test_head_only_settles_with_the_head_and_head_then_eyes_with_the_eyes() -> None:
    head = plans(look(0, Towards(20, 0), 1.0, "head only"))[0][0]
    assert head.landed == head.head_done == pytest.approx(1.39)
    both = plans(look(0, Towards(20, 0), 1.0, "head then eyes"))[0][0]
    assert both.head_onset == 1.0
    assert both.eye_onset > 1.15
    assert both.landed > both.eye_onset


def test_habits_of_the_face() -> None:
    turned = {}
    for gaze in ("eye-mover", "", "head-mover"):
        who = Face("ada", "woman", Voice(), Life("still"), HERE, gaze=gaze)
        turned[gaze] = plan_gaze(ROOM, who, [look(0, Towards(20, 0), 0.0)])[0, 0][0].head_share[0]
    assert turned["eye-mover"] < 0.2 < turned[""] == 0.69 < turned["head-mover"]


# ------------------------------------------------------------------------------------------------ who has eyes and head


def test_what_a_look_with_for_covered_comes_back_once() -> None:
    assert story(look(0, "lamp", 0.0), look(1, Towards(-20, 0), 1.0, released=2.0)) == [
        "0.00 eyes then head lamp eyes 0.106 head 0.473",
        "1.00 eyes then head -20 eyes 1.160 head 1.476",
        "2.00 eyes then head lamp eyes 2.160 head 2.476",
    ]


def test_eyes_and_head_go_back_to_their_own() -> None:
    assert story(
        look(0, "lamp", 0.0), look(1, Towards(5, 0), 1.0, "eyes only"), look(2, Towards(-20, 0), 2.0, released=3.0)
    ) == [
        "0.00 eyes then head lamp eyes 0.106 head 0.473",
        "1.00 eyes only 5 eyes 1.093 head 1.000",
        "2.00 eyes then head -20 eyes 2.092 head 2.550",
        "3.00 eyes only 5 eyes 3.092 head 3.000",
        "3.00 head only lamp eyes 3.455 head 3.455",
    ]


def test_an_older_look_that_lets_go_underneath_moves_nothing() -> None:
    assert story(look(0, "lamp", 0.0, released=2.0), look(1, Towards(5, 0), 1.0)) == [
        "0.00 eyes then head lamp eyes 0.106 head 0.473",
        "1.00 eyes then head 5 eyes 1.093 head 1.472",
    ]


def test_the_later_line_wins_where_two_start_together() -> None:
    assert story(look(1, Towards(5, 0), 0.0), look(0, "lamp", 0.0), look(2, Towards(9, 0), 1.0, released=1.5))[-1] == (
        "1.50 eyes then head 5 eyes 1.536 head 1.952"
    )


def test_scan_stops_follow_each_other_and_go_back_at_the_end() -> None:
    stops = [GazeRequest((0, n), AtTarget("crowd", n + 1), GazeManner(), 0.6 * n, 1.8) for n in range(3)]
    assert [line[:25] for line in story(*stops)] == [
        "0.00 eyes then head crowd",
        "0.60 eyes then head crowd",
        "1.20 eyes then head crowd",
        "1.80 eyes then head camer",
    ]


@pytest.mark.parametrize(
    ("order", "numbers"), [("in order", [1, 2, 3]), ("nearest first", [2, 1, 3]), ("at random", [3, 1, 2])]
)
def test_the_order_of_a_scan(order: str, numbers: list[int]) -> None:
    aims = scan_stops(ROOM, ADA, Scan("crowd", 0.6, order), 0.0, 3, (), ("scene", 4))
    assert [aim.member for aim in aims] == numbers


def test_people_are_scanned_as_they_are_there() -> None:
    assert scan_stops(ROOM, ADA, Scan("people", 0.6), 0.0, 3) == ()
    assert scan_stops(ROOM, ADA, Scan("people", 0.6), 0.0, 3, ("lamp",)) == (AtTarget("lamp"),)


@given(st.integers(0, 10_000), st.floats(-28, 28), st.floats(-20, 14))
def test_away_is_somewhere_else_and_within_easy_reach(place: int, yaw: float, pitch: float) -> None:
    aim = plans(look(0, Towards(yaw, pitch), 0.0), look(1, Away(), 1.0, place=(place,)))[1][0].aim
    assert isinstance(aim, Towards)
    assert max(abs(aim.yaw - yaw), abs(aim.pitch - pitch)) > 9
    assert abs(aim.yaw) <= 28
    assert -20 <= aim.pitch <= 14


# ------------------------------------------------------------------------------------------------ reach


@given(st.floats(-80, 80), st.floats(-70, 50))
def test_head_and_eyes_together_reach_what_they_can(yaw: float, pitch: float) -> None:
    head = head_goal((yaw, pitch), (0.69, 0.52 if pitch > 0 else 0.08))
    assert abs(head[0]) <= 45
    assert abs(head[1]) <= 30
    if extent((yaw / 2, pitch / 2)) < 0.7:
        assert shortfall((yaw, pitch), head) == 0


@given(st.floats(-80, 80), st.floats(-50, 50), st.floats(-45, 45), st.floats(-30, 30))
def test_eye_in_head_and_back(yaw: float, pitch: float, turn: float, nod: float) -> None:
    assert in_room(in_head((yaw, pitch), (turn, nod)), (turn, nod)) == pytest.approx((yaw, pitch), abs=1e-6)


@pytest.mark.parametrize(
    ("aim", "parts", "short"),
    [
        (Towards(80, 0), "eyes then head", 0),
        (Towards(60, 0), "eyes only", 15),
        (Towards(60, 0), "head only", 15),
        ("door", "eyes then head", 60),
        (Towards(0, 70), "eyes then head", 12),
    ],
)
def test_how_far_out_of_reach(aim: object, parts: str, short: float) -> None:
    assert plans(look(0, aim, 0.0, parts))[0][0].unreachable == pytest.approx(short, abs=0.5)


def test_a_look_that_is_covered_as_it_begins_is_judged_by_that_moment() -> None:
    found = plans(look(0, "visitor", 5.0), look(1, AtCamera(), 5.0))
    assert found[0][0].unreachable > 5 and found[1][0].unreachable == 0


def test_a_moving_target_is_judged_while_it_is_looked_at() -> None:
    assert plans(look(0, "visitor", 0.0))[0][0].unreachable > 5
    assert plans(look(0, "visitor", 0.0), look(1, AtCamera(), 2.0))[0][0].unreachable == 0
    assert plans(look(0, "visitor", 0.0, released=2.0))[0][0].unreachable == 0


@dataclass(frozen=True)
class Act:
    plan: tuple[GazePlan, ...]
    span: Span
    estimated: bool = False


@dataclass(frozen=True)
class Acts:
    acts: tuple[Act, ...]
    faces: tuple[Face, ...] = ()
    targets: tuple[Target, ...] = TARGETS


def test_warnings_state_the_angle_once_a_place() -> None:
    second = Span(SOURCE, 13, 38)
    door, window = plans(look(0, "door", 0.0))[0], plans(look(0, Towards(60, 0), 0.0, "eyes only"))[0]
    diagnostics = Diagnostics()
    reach(Acts((Act(door, HERE), Act(door, HERE), Act(window, second))), diagnostics)
    assert [(each.code, each.severity, each.span, each.message) for each in diagnostics] == [
        (
            "FS601",
            Severity.WARNING,
            HERE,
            "At 0 s this target is 60deg beyond what eyes and head reach: the gaze stops short of it.",
        ),
        (
            "FS602",
            Severity.WARNING,
            second,
            "At 0 s the eyes alone stay 15deg short of this target; together eyes and head go further.",
        ),
    ]


# ------------------------------------------------------------------------------------------------ the laws of movement


@pytest.mark.parametrize(
    ("peak", "a", "b"), [(0.45, 2.222, 2.493), (0.40, 2.046, 2.569), (0.35, 1.859, 2.596), (0.30, 1.672, 2.569)]
)
def test_velocity_shapes_are_those_of_the_table(peak: float, a: float, b: float) -> None:
    """motion.md section 1, "Recommended generator"."""
    duration = saccade_time((0.47 - peak) / 0.004)
    assert peak_fraction(duration) == pytest.approx(peak)
    assert velocity_shape(duration) == pytest.approx((a, b), abs=0.001)


def test_a_saccade_runs_from_0_to_1_and_meets_in_the_middle() -> None:
    for duration in (0.03, 0.08, 0.13, 0.9):
        course = [saccade_part(part / 1000, duration) for part in range(1001)]
        steps = [after - before for before, after in pairwise(course)]
        assert (course[0], course[-1]) == (0, 1)
        assert min(steps) >= 0
        assert max(steps) * 1000 == pytest.approx(1.65, abs=0.001)
        assert steps[499] == pytest.approx(steps[500], rel=0.01)


def test_no_head_turns_faster_than_its_ceiling() -> None:
    assert head_time(20) == pytest.approx(0.39)
    assert 1.875 * 90 / head_time(90) == pytest.approx(185)


def test_a_head_is_judged_only_while_it_has_the_target() -> None:
    """The visitor passes behind the picture's plane at 5 s, where no head can follow."""
    long = plans(look(0, "visitor", 0.0, "head only"))
    short = plans(look(0, "visitor", 0.0, "head only"), look(1, "lamp", 0.5, "head only"))
    assert long[0][0].unreachable > 40.0
    assert short[0][0].unreachable == 0.0


def test_what_lies_under_many_movements_is_worked_out_all_the_same() -> None:
    requests = [look(order, Towards(20.0 - order % 41, 0.0), 0.02 * order, over=60.0) for order in range(300)]
    found = plans(*requests)
    assert all(0.0 <= found[order][0].amplitude <= 60.0 for order in range(300))


def test_the_eyes_have_a_target_at_the_reach_when_the_head_lets_them() -> None:
    """The waiting is sought in strides and then in steps: the eyes are there within a step, not before."""
    (plan,) = plans(look(0, Towards(80.0, 0.0), 0.0))[0]
    assert plan.eye_done < plan.landed < plan.head_done
