"""Gaze against the bars of human motion, read from a 1000 Hz trace of the channels (screen none, life still, 3 m)."""

from __future__ import annotations

from itertools import pairwise

import pytest
from bars import (
    Movement,
    Trace,
    bar,
    eye_extremes,
    final_share,
    head_lag_ms,
    movement,
    share_at_landing,
    spearman,
    vergence_error,
    vergence_share,
    vor_error,
    vor_gain,
)
from gazing import face, request, target, trace

from facescript.ir.acts import GazeManner

EYES_ONLY = GazeManner("eyes only")
SIDEWAYS, UPRIGHT = (5, 10, 15, 20, 30, 40), (5, 10, 15, 20, -5, -10, -20)


def within(value: float, name: str, case: str) -> None:
    low, high = bar(name, case)
    assert low <= value <= high, f"{name} {case}: {value:.3f} is not in {low}..{high}"


def look(yaw: float, pitch: float = 0.0, manner: GazeManner | None = None, gaze: str = "") -> Trace:
    return trace([target("there", yaw, pitch)], [request(0, "there", 0.5, manner)], who=face(gaze))


def saccade(yaw: float, pitch: float = 0.0) -> Movement:
    seen = look(yaw, pitch, EYES_ONLY)
    return movement(seen, seen.eye("yaw" if yaw else "pitch"))


@pytest.mark.parametrize("yaw", [5, 10, 20, 30])
def test_s1_saccades_last_as_long_as_ours(yaw: int) -> None:
    within(saccade(yaw).lasts_ms, "S1", str(yaw))
    within(saccade(-yaw).lasts_ms, "S1", str(yaw))


@pytest.mark.parametrize("yaw", [5, 15, 30])
def test_s2_saccades_sideways_are_as_fast(yaw: int) -> None:
    within(saccade(yaw).peak, "S2", str(yaw))
    within(saccade(-yaw).peak, "S2", str(yaw))


@pytest.mark.parametrize("pitch", [5, 10, 20])
def test_s3_saccades_up_and_down_are_as_fast(pitch: int) -> None:
    within(saccade(0, pitch).peak, "S3", str(pitch))
    within(saccade(0, -pitch).peak, "S3", str(pitch))


@pytest.mark.parametrize(("yaw", "pitch"), [(size, 0) for size in SIDEWAYS[:-1]] + [(0, size) for size in UPRIGHT])
def test_s4_peak_over_mean_velocity(yaw: int, pitch: int) -> None:
    within(saccade(yaw, pitch).peak_over_mean, "S4", "5..30")


def test_s5_speed_saturates() -> None:
    within(saccade(40).peak / saccade(20).peak, "S5", "40/20")


def test_s6_long_saccades_peak_early() -> None:
    parts = [saccade(yaw).peak_part for yaw in SIDEWAYS]
    within(parts[0], "S6", "5")
    within(parts[SIDEWAYS.index(30)], "S6", "30")
    assert all(later <= part + 0.01 for part, later in pairwise(parts))


@pytest.mark.parametrize(("yaw", "pitch"), [(40, 0), (85, 0), (-85, 0), (0, 50), (0, -65), (60, 30), (-120, 70)])
@pytest.mark.parametrize("manner", [GazeManner(), EYES_ONLY])
def test_s8_eyes_stay_within_their_reach(yaw: int, pitch: int, manner: GazeManner) -> None:
    for side, furthest in eye_extremes(look(yaw, pitch, manner)).items():
        within(furthest, "S8", side)


@pytest.mark.parametrize("yaw", [10, 20, 30, 40])
def test_h1_the_head_follows_the_eyes(yaw: int) -> None:
    within(head_lag_ms(look(yaw), "yaw"), "H1", str(yaw))
    assert head_lag_ms(look(10), "yaw") > head_lag_ms(look(40), "yaw")


@pytest.mark.parametrize("yaw", [10, 20, 30, 40])
def test_h2_eye_speed_inside_a_gaze_shift(yaw: int) -> None:
    seen = look(yaw)
    within(float(abs(seen.speed(seen.eye("yaw"))).max()), "H2", str(yaw))


def test_h3_head_share_when_gaze_lands() -> None:
    within(share_at_landing(look(50), "yaw", 50), "H3", "50")


@pytest.mark.parametrize(
    ("axis", "angle", "case"),
    [("yaw", angle, "horizontal 20..60") for angle in (20, -30, 40, 50, -60)]
    + [("pitch", angle, "up 20..40") for angle in (20, 30, 40)]
    + [("pitch", -angle, "down 20..40") for angle in (20, 30, 40)],
)
def test_h4_final_head_share(axis: str, angle: int, case: str) -> None:
    seen = look(angle) if axis == "yaw" else look(0, angle)
    within(final_share(seen, axis, angle), "H4", case)
    assert seen.gaze(axis)[-1] == pytest.approx(angle, abs=0.3)


@pytest.mark.parametrize("yaw", [5, 10, -10])
def test_h5_the_head_of_an_eye_mover_stays_for_small_shifts(yaw: int) -> None:
    within(float(abs(look(yaw, gaze="eye-mover").head("yaw")).max()), "H5", "<=10")


def test_h6_head_speed_grows_with_the_shift_and_has_a_ceiling() -> None:
    sizes = [10.0, 20.0, 30.0, 40.0, 50.0]
    speeds = [movement(seen, seen.head("yaw")).peak for seen in map(look, sizes)]
    within(spearman(sizes, speeds), "H6", "rho")
    across = trace([target("a", -80), target("b", 80)], [request(0, "a", 0.2), request(1, "b", 1.5)], 4.0)
    within(float(abs(across.speed(across.head("yaw"))).max()), "H6", "max")


@pytest.mark.parametrize("yaw", [10, 20, 30, 40, 50])
def test_h7_h8_gaze_stays_while_the_head_arrives(yaw: int) -> None:
    seen = look(yaw)
    error, slip = vor_error(seen, "yaw", yaw)
    within(error, "H7", "mean error")
    within(slip, "H7", "retinal slip rms")
    within(vor_gain(seen, "yaw", yaw), "H8", "far target")


@pytest.mark.parametrize("distance", [30, 60, 100, 300, 600])
def test_v1_the_eyes_converge_on_the_target(distance: int) -> None:
    seen = trace([target("there", 0, 0, distance)], [request(0, "there", 0.5)])
    within(vergence_error(seen, distance), "V1", "0.3..6 m")


@pytest.mark.parametrize(("near", "case"), [((300, 40), "convergence"), ((40, 300), "divergence")])
def test_v2_saccades_carry_vergence_with_them(near: tuple[int, int], case: str) -> None:
    targets = [target("a", -12, 0, near[0]), target("b", 12, 0, near[1])]
    seen = trace(targets, [request(0, "a", 0.2, EYES_ONLY), request(1, "b", 1.5, EYES_ONLY)], 3.5)
    within(vergence_share(seen.part(1.4, 3.5), "yaw"), "V2", case)
