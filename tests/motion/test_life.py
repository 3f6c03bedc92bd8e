"""What living faces do unasked: how often, how far, when not, and that the seed decides it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bars import bar
from living import (
    LONG,
    MINUTES,
    blinked,
    far_off,
    gaps,
    jumps,
    lengths,
    life,
    lived,
    preset,
    stretches,
    talk,
)
from performing import HERE, STILL, Floats, act, channels, grid, performed, score

from facescript.ir.acts import Glance, Life, Look, SetLife, Timing
from facescript.ir.values import AtCamera, Draw
from facescript.motion.perform import perform
from facescript.performance.performance import REST
from facescript.schedule.score import FOREVER, TimedAct, TimedLine
from facescript.space.plan import GazePlan

FRAMES = grid(LONG, 60.0)
ANNOUNCER = Life("announcer")


def still_look(start: float, end: float, lasting: float | None = None, order: int = 0) -> TimedAct:
    plan = GazePlan(AtCamera(), "eyes then head", start, start + 0.05, start, start + 0.3, (0.69, 0.52), 0.0, end)
    verb = Look(AtCamera(), timing=Timing(lasting=lasting))
    return TimedAct(order, verb, "ada", 0, start, start + 0.05, end, end, HERE, plan=(plan,))


# ------------------------------------------------------------------------------------------------ still


def test_a_still_face_does_nothing_at_all() -> None:
    drawn = channels(performed(life=STILL, duration=60.0), grid(60.0, 30.0))
    assert all(len(set(values)) == 1 for values in drawn.values())


def test_a_still_face_is_at_rest_and_converges_on_the_camera() -> None:
    frames = performed(life=STILL).sample(np.array([0.0, 1.0, 3.9]))
    different = {
        name
        for name, row in zip(performed().names, np.abs(frames - REST[: frames.shape[1]]).T, strict=True)
        if row.max() > 1e-9
    }
    assert different == {"eye.left.yaw", "eye.right.yaw"}


# ------------------------------------------------------------------------------------------------ blinks


@pytest.mark.parametrize(("case", "rate"), [("rest", 15.0), ("reading", 4.5), ("conversation", 26.0)])
def test_blinks_come_as_often_as_the_knob_says(case: str, rate: float) -> None:
    found = len(blinked(lived(life(blink=rate)))) / MINUTES
    low, high = bar("B1", case)
    assert low <= found <= high
    assert found == pytest.approx(rate, rel=0.25)


def test_blinks_come_at_skewed_intervals() -> None:
    starts = np.concatenate([blinked(lived(life(blink=17.0)))[:, 0], LONG + blinked(lived(life(blink=16.0)))[:, 0]])
    gaps = np.diff(starts)
    skewness = np.mean((gaps - gaps.mean()) ** 3) / gaps.std() ** 3
    low, high = bar("B2", "rest")
    assert low <= skewness <= high
    assert 0.4 <= gaps.std() / gaps.mean() <= 0.75


def test_blinks_close_in_66_ms_and_few_are_complete() -> None:
    lid = lived(life(blink=17.0), 120.0, 1000.0)["lid.left"]
    each = stretches(lid > 1e-6, 1000.0)
    parts = [lid[round(start * 1000) : round(end * 1000)] for start, end in each]
    closing = [float(np.argmax(part >= part.max() - 1e-9)) for part in parts]
    assert bar("B3", "mean")[0] <= np.mean(closing) <= bar("B3", "mean")[1]
    assert np.mean(closing) == pytest.approx(66.0, abs=4.0)
    low, high = bar("B5", "mean")
    assert low <= np.mean([part.max() >= 0.9 for part in parts]) <= high


def shifted(amplitude: float, count: int, life: Life) -> Floats:
    """Blinks with `count` gaze shifts of a size, one every 2 s; the plans say so, the eyes stay where they are."""
    acts = []
    for index in range(count):
        start = 1.0 + 2.0 * index
        times = start, start + 0.1, start + 0.02, start + 0.5
        plan = GazePlan(AtCamera(), "eyes then head", *times, (0.7, 0.5), amplitude)
        look = Look(AtCamera())
        acts.append(TimedAct(index, look, "ada", 0, start, start + 0.1, FOREVER, FOREVER, HERE, plan=(plan,)))
    duration = 2.0 * count + 2.0
    lid = channels(perform(score(acts, duration, life)), grid(duration, 200.0))["lid.left"]
    return stretches(lid > 0.05, 200.0)


@pytest.mark.parametrize("name", ["calm", "conversation", "announcer-ctn"])
def test_large_gaze_shifts_bring_blinks_that_set_off_with_them(name: str) -> None:
    rare = preset(f"{name}, blink 0.001/min, saccades 0/min, avert 0%")
    found = shifted(35.0, 200, rare)
    low, high = bar("H10", "35..60")
    assert low <= len(found) / 200 <= high
    late = 1000.0 * ((found[:, 0] - 1.0 + 0.5) % 2.0 - 0.5)
    assert bar("H11", "any")[0] <= late.min() and late.max() <= bar("H11", "any")[1]
    assert len(shifted(8.0, 200, rare)) / 200 <= bar("H10", "<=8")[1]


def test_a_still_face_does_not_blink_when_it_looks() -> None:
    assert len(shifted(50.0, 5, STILL)) == 0


# ------------------------------------------------------------------------------------------------ the announcer


@pytest.fixture(scope="module")
def announcer() -> dict[str, Floats]:
    return lived(ANNOUNCER, lines=(talk(1.0, 500.0),))


FRAME = 0.05
"""Movements begin and end slowly: what is seen of them is a little shorter than they are."""


def test_the_announcer_blinks_by_a_gamma_of_1_48_s(announcer: dict[str, Floats]) -> None:
    waits = gaps(blinked(announcer))
    assert len(waits) == pytest.approx(60.0 * MINUTES / 3.196, rel=0.15)
    assert waits.mean() == pytest.approx(2 * 1.48, rel=0.15)
    assert waits.std() == pytest.approx(np.sqrt(2) * 1.48, rel=0.25)


def test_the_announcer_raises_brows_at_the_thesis_intervals(announcer: dict[str, Floats]) -> None:
    found = stretches(announcer["brow.inner.left"] > 0.002)
    assert np.array_equal(announcer["brow.inner.left"], announcer["brow.outer.right"])
    assert len(found) == pytest.approx(600.0 / 7.47, rel=0.2)
    assert gaps(found).min() >= 0.9 and gaps(found).max() <= 12.54 + 3 * FRAME
    assert lengths(found).min() >= 0.51 - 3 * FRAME and lengths(found).max() <= 0.99 + FRAME


@pytest.mark.parametrize(
    ("channel", "between", "length"),
    [("head.roll", (0.0, 6.64), (0.4, 1.0)), ("head.yaw", (0.08, 7.92), (0.4, 0.92))],
)
def test_the_announcer_tilts_and_turns_from_pose_to_pose(
    announcer: dict[str, Floats], channel: str, between: tuple[float, float], length: tuple[float, float]
) -> None:
    values = announcer[channel]
    moving = np.concatenate([[False], np.diff(values) != 0.0])
    found = stretches(moving)
    mean = (sum(between) + sum(length)) / 2
    assert len(found) == pytest.approx(600.0 / mean, rel=0.2)
    assert gaps(found).max() <= between[1] + 4 * FRAME
    assert np.mean(lengths(found)) == pytest.approx(sum(length) / 2, abs=0.1)
    assert np.abs(values).max() <= 15.0


def test_the_announcer_nods_before_a_pause_and_lifts_with_it(announcer: dict[str, Floats]) -> None:
    pauses = 1.0 + 2.3 * np.arange(217) + 2.0
    speed = np.concatenate([[0.0], np.diff(announcer["head.pitch"])])
    downs, ups = stretches(speed < 0.0), stretches(speed > 0.0)
    assert len(downs) == len(ups) == pytest.approx(len(pauses), rel=0.1)
    for down, up in zip(downs, ups, strict=True):
        pause = pauses[np.abs(pauses - up[0]).argmin()]
        assert abs(up[0] - pause) <= FRAME
        assert 0.07 - FRAME <= pause - down[1] <= 0.35 + FRAME
        assert all(0.34 - 2 * FRAME <= b - a <= longest + FRAME for (a, b), longest in ((down, 0.94), (up, 0.70)))


def test_a_knob_of_the_announcer_is_heeded() -> None:
    busy = blinked(lived(Life("announcer", (("blink", 40.0),))))
    assert len(busy) / MINUTES == pytest.approx(40.0, rel=0.15)
    assert not np.any(lived(Life("announcer", (("sway", 0.0),)), 60.0)["head.roll"])


# ------------------------------------------------------------------------------------------------ the other knobs


@pytest.mark.parametrize(
    ("knob", "value", "moved"),
    [
        ("blink", 20.0, "lid.left"),
        ("brows", 10.0, "brow.inner.left"),
        ("sway", 0.5, "head.yaw"),
        ("saccades", 60.0, "gaze.yaw"),
        ("avert", 0.3, "gaze.yaw"),
    ],
)
def test_every_knob_moves_something_and_its_zero_nothing(knob: str, value: float, moved: str) -> None:
    assert len(set(lived(life(**{knob: value}), 60.0)[moved])) > 2
    assert len(set(lived(life(**{knob: 0.0}), 60.0)[moved])) == 1


def test_brow_raises_in_speech_peak_just_before_an_accent() -> None:
    sung = accented(talk(1.0, 590.0), every=8)
    accents = np.array([1.0 + (phone.start + phone.end) / 2 for phone in sung.spoken.phones if phone.stress])
    brow = lived(life(brows=12.0), lines=(sung,), rate=200.0)["brow.inner.left"]
    peaks = [start + np.argmax(brow[round(start * 200) : round(end * 200)]) / 200 for start, end in
             stretches(brow > 0.01, 200.0)]  # fmt: skip
    leads = [1000.0 * (accents - peak)[np.abs(accents - peak - 0.06).argmin()] for peak in peaks]
    assert bar("L4", "median")[0] <= np.median(leads) <= bar("L4", "median")[1]
    assert np.mean(np.abs(np.array(leads) - 60.0) < 10.0) > 0.8


def accented(spoken: TimedLine, every: int) -> TimedLine:
    """The line with the stress on one phone in `every`."""
    phones = tuple(replace(phone, stress=index % every == 3) for index, phone in enumerate(spoken.spoken.phones))
    return replace(spoken, spoken=replace(spoken.spoken, phones=phones))


def test_nods_need_speech_and_grow_with_their_knob() -> None:
    small, large = (lived(life(nods=size), 60.0, lines=(talk(1.0, 50.0),))["head.pitch"].min() for size in (0.3, 1.0))
    assert large < small < 0.0 and small / large == pytest.approx(0.3)
    assert not np.any(lived(life(nods=1.0), 60.0)["head.pitch"])


def test_the_head_sways_slowly_and_not_far() -> None:
    yaw = lived(life(sway=1.0), 120.0)["head.yaw"]
    assert 1.0 < np.abs(yaw).max() < 3.0
    assert np.abs(np.diff(yaw)).max() * 60.0 < 8.0


def test_gaze_stays_on_the_camera_while_the_head_sways_and_nods() -> None:
    drawn = lived(life(sway=1.0, nods=1.0), 60.0, lines=(talk(1.0, 50.0),))
    assert np.hypot(drawn["gaze.yaw"], drawn["gaze.pitch"]).max() < bar("H7", "mean error")[1]


def test_idle_saccades_stay_within_a_degree() -> None:
    drawn = lived(life(saccades=75.0), 120.0, 1000.0)
    assert 0.2 < far_off(drawn).max() < 1.0
    found = jumps(drawn)
    assert bar("M1", "rate 1/s")[0] <= len(found) / 120.0 <= bar("M1", "rate 1/s")[1]
    assert len(found) / 2.0 == pytest.approx(75.0, rel=0.15)
    assert bar("M1", "size deg")[0] <= found[:, 2].min() and found[:, 2].max() <= bar("M1", "size deg")[1]


# ------------------------------------------------------------------------------------------------ looks away


def test_looks_away_go_as_far_as_the_knob_says() -> None:
    for knob in (0.1, 0.4):
        away = far_off(lived(life(avert=knob)))
        assert 0.6 * 30.0 * knob < away.max() <= 30.0 * knob + 0.1


def test_a_listener_looks_at_the_partner_most_of_the_time() -> None:
    on = far_off(lived(life(avert=0.4))) < 3.0
    assert bar("C1", "listening")[0] <= on.mean() <= bar("C1", "listening")[1]


def test_a_speaker_looks_away_more_and_back_before_the_end() -> None:
    lines = tuple(talk(3.0 + 24.0 * turn, 20.0) for turn in range(24))
    on = far_off(lived(life(avert=0.4), lines=lines)) < 3.0
    speaking = [on[slice(*np.searchsorted(FRAMES, [each.start, each.end]))] for each in lines]
    assert bar("C1", "speaking")[0] <= np.mean(np.concatenate(speaking)) <= bar("C1", "speaking")[1]
    episodes = [lengths(stretches(part)) for part in speaking]
    assert bar("C2", "speaking")[0] <= np.mean(np.concatenate(episodes)) <= bar("C2", "speaking")[1]
    ends = [on[np.searchsorted(FRAMES, each.end) - 1] for each in lines]
    starts = [not on[np.searchsorted(FRAMES, each.start)] for each in lines]
    assert np.mean(ends) >= bar("C3", "end on partner")[0] and np.mean(starts) >= bar("C3", "start away")[0]


def test_nobody_looks_away_in_a_look_with_for_or_a_glance() -> None:
    away = life(avert=0.5)
    assert far_off(channels(perform(score([still_look(1.0, FOREVER)], 60.0, away)), grid(60.0, 60.0))).max() > 5.0
    kept = still_look(1.0, 59.0, lasting=58.0)
    glance = TimedAct(0, Glance(AtCamera()), "ada", 0, 1.0, 59.0, 59.0, 59.0, HERE)
    for busy in (kept, glance):
        assert far_off(channels(perform(score([busy], 60.0, away)), grid(60.0, 60.0))).max() < 0.1


# ------------------------------------------------------------------------------------------------ seeds and changes


def test_the_seed_decides_and_nothing_else() -> None:
    what = life(blink=20.0, brows=8.0, sway=1.0, saccades=60.0, avert=0.3)
    one, same, other = (perform(score((), 30.0, what, seed=seed)).sample(grid(30.0, 60.0)) for seed in (1, 1, 2))
    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)


def test_a_longer_film_begins_the_same() -> None:
    what = life(blink=20.0, brows=8.0, sway=1.0, saccades=60.0)
    short, long = (perform(score((), duration, what)).sample(grid(10.0, 60.0)) for duration in (12.0, 40.0))
    assert np.array_equal(short, long)


def test_a_life_statement_changes_what_comes_after_it() -> None:
    change = act(SetLife(STILL), 30.0)
    lively = life(blink=20.0, sway=1.0, saccades=60.0)
    frames = perform(score([change], 60.0, lively)).sample(grid(60.0, 60.0))
    assert np.array_equal(frames[: 30 * 60], perform(score((), 60.0, lively)).sample(grid(30.0, 60.0)))
    assert len(np.unique(frames[31 * 60 :], axis=0)) == 1
    speed = np.diff(frames[29 * 60 : 31 * 60, :3], axis=0) * 60.0
    assert np.abs(speed).max() < 30.0


def test_a_knob_may_be_drawn() -> None:
    drawn = blinked(lived(Life("calm", (("blink", Draw(10.0, 30.0)),))))
    assert 8.0 < len(drawn) / MINUTES < 34.0
