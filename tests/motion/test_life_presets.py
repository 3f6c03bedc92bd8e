"""The presets against the bars, and at 1000 Hz nothing that jumps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bars import Trace, bar, landing, largest_step, movement
from gazing import face, film, request, score, target
from living import LONG, PRESETS, blinked, far_off, gaps, jumps, lengths, lid, lived, preset, stretches, talk
from performing import HERE, Floats, act, channels, grid
from performing import score as made

from facescript.ir.acts import Look, SetLife, Timing
from facescript.ir.values import AtCamera
from facescript.motion.perform import perform
from facescript.schedule.score import TimedAct
from facescript.space.plan import GazePlan

HOLDING = ("calm", "reading", "conversation", "announcer", "announcer-ctn", "announcer-ettoday", "announcer-other")


def held(what: str, seconds: float) -> dict[str, Floats]:
    """A life that holds its gaze: in a look with `for`."""
    plan = GazePlan(AtCamera(), "eyes then head", 0.0, 0.05, 0.0, 0.1, (0.69, 0.52), 0.0)
    look = TimedAct(0, Look(AtCamera(), timing=Timing(lasting=seconds)), "ada", 0, 0.0, 0.05, seconds, seconds, HERE,
                    plan=(plan,))  # fmt: skip
    return channels(perform(made([look], seconds, preset(what))), grid(seconds))


# ------------------------------------------------------------------------------------------------ blinks


@pytest.mark.parametrize(("name", "case"), [("calm", "rest"), ("reading", "reading"), ("conversation", "conversation")])
def test_blinks_come_as_often_as_people_blink(name: str, case: str) -> None:
    found = len(blinked(lived(preset(name), 1800.0, 50.0), 50.0)) / 30.0
    low, high = bar("B1", case)
    assert low <= found <= high
    assert found == pytest.approx(dict(preset(name).knobs)["blink"], rel=0.15)


def test_an_hour_of_rest_has_skewed_intervals_between_blinks() -> None:
    starts = blinked(lived(preset("calm"), 3600.0, 25.0), 25.0)[:, 0]
    waits = np.diff(starts)
    low, high = bar("B2", "rest")
    assert low <= np.mean((waits - waits.mean()) ** 3) / waits.std() ** 3 <= high


@pytest.mark.parametrize("name", ["calm", "conversation"])
def test_lids_and_eyes_in_blinks_move_as_peoples_do(name: str) -> None:
    drawn = held(name, 150.0)
    shut, yaw, pitch = lid(drawn), drawn["eye.left.yaw"], drawn["eye.left.pitch"]
    each = [(round(1000 * start), round(1000 * end)) for start, end in stretches(shut > 1e-3, 1000.0)]
    parts = [shut[first:last] for first, last in each]
    assert bar("B3", "mean")[0] <= np.mean([part.argmax() for part in parts]) <= bar("B3", "mean")[1]
    speeds = [np.diff(part) for part in parts]
    assert bar("B4", "mean")[0] <= np.mean([-one.max() / one.min() for one in speeds]) <= bar("B4", "mean")[1]
    assert bar("B5", "mean")[0] <= np.mean([part.max() >= 0.9 for part in parts]) <= bar("B5", "mean")[1]
    for first, last in each:
        turned = np.hypot(yaw[first:last] - yaw[first], pitch[first:last] - pitch[first])
        assert bar("B6", "down+nasal")[0] <= turned.max() <= bar("B6", "down+nasal")[1] + 0.5


def test_the_eye_is_faster_than_the_lid_in_a_blink_and_back_before_it_opens() -> None:
    drawn = channels(perform(made((), 60.0, preset("calm, saccades 0/min, sway 0%, avert 0%"))), grid(60.0))
    for start, end in stretches(drawn["lid.left"] > 1e-4, 1000.0):
        part = slice(round(1000 * start), round(1000 * end))
        shut, down = drawn["lid.left"][part], drawn["eye.left.pitch"][part]
        moving = np.flatnonzero(down < down[0] - 1e-3)
        assert shut[moving[-1]] > 0.1
        arrived = np.flatnonzero(down <= 0.98 * down.min() + 0.02 * down[0])[0]
        assert arrived - moving[0] < shut.argmax()
        assert down.max() - down[0] <= bar("B6", "upward")[1]


# ------------------------------------------------------------------------------------------------ holding gaze


@pytest.mark.parametrize("name", HOLDING)
def test_eyes_that_hold_a_target_make_microsaccades_and_drift(name: str) -> None:
    drawn = held(f"{name}, blink 0/min", 60.0)
    found = jumps(drawn)
    assert bar("M1", "rate 1/s")[0] <= len(found) / 60.0 <= bar("M1", "rate 1/s")[1]
    assert bar("M1", "size deg")[0] <= found[:, 2].min() and found[:, 2].max() <= bar("M1", "size deg")[1]
    assert far_off(drawn).max() < 1.0
    assert far_off(drawn).mean() <= bar("H7", "mean error")[1]
    speed = 1000.0 * np.hypot(np.diff(drawn["gaze.yaw"]), np.diff(drawn["gaze.pitch"]))
    drift = speed[speed < 2.0]
    assert 0.05 < drift.mean() < 0.5 and np.quantile(drift, 0.9) < 0.6
    peaks = [speed[round(1000 * start) : round(1000 * end)].max() for start, end in found[:, :2]]
    assert np.corrcoef(peaks, found[:, 2])[0, 1] > 0.95
    assert 55.0 <= np.median(np.array(peaks) / found[:, 2]) <= 70.0  # 1.65 A over 2.7 A + 25 ms


@pytest.mark.parametrize("name", HOLDING)
def test_a_written_look_of_a_living_face_keeps_to_the_bars(name: str) -> None:
    who, times = replace(face(), life=preset(f"{name}, blink 0/min")), grid(3.0)
    for size in (10.0, 30.0):
        looked = score([target("it", size)], [request(1, "it", 1.0)], who, film(), 3.0)
        kept = replace(looked.acts[0].verb, timing=Timing(lasting=2.0))
        looked = replace(looked, acts=(replace(looked.acts[0], verb=kept, end=3.0),))
        seen = Trace(times, channels(perform(looked), times)).part(0.95, 3.0)
        saccade = movement(seen, seen.gaze("yaw"))
        within = bar("S1", str(int(size)))
        assert within[0] - 3.0 <= saccade.lasts_ms <= within[1] + 3.0
        after = seen.times > seen.times[landing(seen, "yaw", size)] + 0.02
        off = np.hypot(seen.gaze("yaw") - size, seen.gaze("pitch"))[after]
        assert off.max() < 1.0 and off.mean() <= bar("H7", "mean error")[1]


# ------------------------------------------------------------------------------------------------ nothing jumps


@pytest.mark.parametrize("name", PRESETS)
def test_no_life_jumps(name: str) -> None:
    """Whatever it does unasked, and where it is followed by another life: steps of 1 ms have bounds."""
    lines = tuple(talk(8.0 + 30.0 * turn, 15.0, f"turn {turn}") for turn in range(3))
    acts = [act(SetLife(preset("still")), 31.0), act(SetLife(preset(name)), 33.0, 1),
            act(SetLife(preset("conversation")), 61.3, 2)]  # fmt: skip
    drawn = channels(perform(made(acts, 90.0, preset(name), lines)), grid(90.0))
    for axis in ("yaw", "pitch"):
        gaze, head = drawn[f"gaze.{axis}"], drawn[f"head.{axis}"]
        assert largest_step(gaze) <= 0.75 and largest_step(head) <= 0.32
        assert largest_step(np.diff(head) * 1000.0) <= 10.0
        for side in ("left", "right"):
            assert largest_step(np.diff(drawn[f"eye.{side}.{axis}"]) * 1000.0) <= 100.0
    assert largest_step(drawn["head.roll"]) <= 0.32
    assert largest_step(np.diff(drawn["head.roll"]) * 1000.0) <= 10.0


# ------------------------------------------------------------------------------------------------ talking and listening


def test_the_conversation_looks_at_the_partner_as_people_do() -> None:
    what = preset("conversation")
    listening = far_off(lived(what, 900.0, 50.0)) < 3.0
    assert bar("C1", "listening")[0] <= listening.mean() <= bar("C1", "listening")[1]
    lines = tuple(talk(4.0 + 25.0 * turn, (14.0, 20.0)[turn % 2], f"turn {turn}") for turn in range(40))
    times = grid(1020.0, 50.0)
    on = far_off(channels(perform(made((), 1020.0, what, lines)), times)) < 3.0
    spoken = [on[slice(*np.searchsorted(times, [each.start, each.end]))] for each in lines]
    assert bar("C1", "speaking")[0] <= np.concatenate(spoken).mean() <= bar("C1", "speaking")[1]
    mutual = np.concatenate([lengths(stretches(part, 50.0)) for part in spoken])
    assert bar("C2", "speaking")[0] <= mutual.mean() <= bar("C2", "speaking")[1]
    assert np.mean([part[-1] for part in spoken]) >= bar("C3", "end on partner")[0]
    assert np.mean([not part[0] for part in spoken]) >= bar("C3", "start away")[0]


def test_a_long_look_away_has_further_saccades() -> None:
    drawn = lived(preset("conversation, saccades 0/min, blink 0/min"), 300.0, 500.0)
    away = stretches(far_off(drawn) > 2.9, 500.0)
    onsets = jumps(drawn, 500.0, 30.0)[:, 0]
    counts = np.array([np.sum((onsets > start) & (onsets < end - 0.1)) for start, end in away])
    long = lengths(away) > 1.5
    assert counts[long].mean() >= 2.0 and (counts[lengths(away) < 0.4] <= 1).all()
    assert far_off(drawn).max() <= 12.1


# ------------------------------------------------------------------------------------------------ reading


def test_eyes_that_read_go_along_lines_and_back() -> None:
    drawn = lived(preset("reading, saccades 0/min, blink 0/min, sway 0%"), 120.0, 500.0)
    found = jumps(drawn, 500.0, 20.0)
    stays = gaps(found)
    assert 0.2 <= stays.mean() <= 0.26 and 0.06 <= stays.std() <= 0.12
    yaw = drawn["gaze.yaw"]
    ends = np.rint(found[:, 1] * 500.0).astype(int)
    begins = np.rint(found[:, 0] * 500.0).astype(int)
    steps = yaw[np.minimum(ends, len(yaw) - 1)] - yaw[begins]
    forward, back = steps[steps < 0.0], steps[steps > 0.0]
    assert -2.4 <= np.median(forward) <= -1.6
    assert len(forward) > 1.5 * len(back) and back[1:].min() > 2.0
    assert far_off(drawn).max() <= 3.1


def test_a_face_that_looks_with_for_does_not_read() -> None:
    assert far_off(held("reading, saccades 0/min, blink 0/min", 20.0)).max() < 0.1
    assert far_off(lived(preset("reading, avert 0%, saccades 0/min, blink 0/min"), LONG, 30.0)).max() < 0.1


def test_a_still_face_stays_still_whatever_it_says() -> None:
    drawn = lived(preset("still"), 60.0, 30.0, (talk(1.0, 50.0),))
    for name in ("head.yaw", "head.pitch", "head.roll", "eye.left.yaw", "lid.left", "brow.inner.left", "gaze.yaw"):
        assert len(set(drawn[name])) == 1
