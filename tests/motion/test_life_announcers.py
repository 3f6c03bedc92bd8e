"""Newsreaders' statistics, found again in the channels."""

from __future__ import annotations

import numpy as np
import pytest
from distributions import LAWS, announcer_p_values, kolmogorov_smirnov, measured, uniform
from living import preset

from facescript.ir.acts import Life
from facescript.motion.life.blinks import ANNOUNCER_RATE
from facescript.motion.life.stations import ANNOUNCER, DOUBLED, STATIONS

SURE = 0.01


def test_a_test_of_distributions_finds_what_is_not_so() -> None:
    values = np.random.default_rng(1).uniform(0.34, 0.94, 800)
    assert kolmogorov_smirnov(values, uniform(0.34, 0.94)) > SURE
    assert kolmogorov_smirnov(values[values < 0.85], uniform(0.34, 0.94)) < SURE
    assert kolmogorov_smirnov(values + 0.05, uniform(0.34, 0.94)) < SURE


def test_an_hour_of_the_announcer_has_the_distributions_of_the_thesis() -> None:
    found = announcer_p_values(2, rate=250.0)
    assert found.keys() == LAWS.keys()
    assert min(found.values()) > SURE, found


def test_pauses_with_little_room_make_no_nod_longer_or_shorter() -> None:
    found = measured(Life("announcer"), 1, 1200.0, 250.0, (1.2, 1.4))
    assert len(found["nod length"]) > 300
    for name in ("nod length", "nod to pause", "lift length"):
        assert kolmogorov_smirnov(found[name], LAWS[name]) > SURE


@pytest.mark.parametrize("name", [name for name in STATIONS if name != "announcer"])
def test_each_station_moves_by_its_own_tables(name: str) -> None:
    station = STATIONS[name]
    found = measured(Life(name), 1, 900.0, 250.0)
    own = {
        "brow interval": station.brow_gaps,
        "brow length": station.brow_lengths,
        "tilt interval": station.tilt_gaps,
        "tilt length": station.tilt_lengths,
        "turn interval": station.turn_gaps,
        "turn length": station.turn_lengths,
        "nod length": station.nod_lengths,
        "nod to pause": station.nod_ahead,
        "lift length": station.lift_lengths,
    }
    assert min(kolmogorov_smirnov(found[each], uniform(*own[each])) for each in own) > SURE / len(own)
    assert kolmogorov_smirnov(found["blink interval"], LAWS["blink interval"]) > SURE
    assert kolmogorov_smirnov(found["brow interval"], uniform(*ANNOUNCER.brow_gaps)) < SURE


def test_stations_have_what_the_thesis_makes_of_its_tables() -> None:
    ctn = STATIONS["announcer-ctn"]
    assert ctn.brow_gaps == pytest.approx((1.315 - 1.038, 1.315 + 1.038), abs=2e-3)
    assert ctn.turn_lengths == pytest.approx((2 * (0.307 - 0.124), 2 * (0.307 + 0.124)), abs=3e-3)
    assert STATIONS["announcer-ettoday"].nod_ahead[0] == 0.0
    assert len(DOUBLED) == 6
    assert all(0.0 <= low < high for each in STATIONS.values() for low, high in map(each.__getattribute__, DOUBLED))


@pytest.mark.parametrize("name", STATIONS)
def test_the_knobs_of_the_presets_are_the_statistics(name: str) -> None:
    knobs = dict(preset(name).knobs)
    assert knobs["blink"] == pytest.approx(ANNOUNCER_RATE, abs=0.01)
    assert knobs["brows"] == pytest.approx(STATIONS[name].brow_rate, abs=0.01)
    assert knobs["sway"] == knobs["nods"] == 1.0


def test_a_life_of_ones_own_grows_from_a_station() -> None:
    mine = preset("announcer-ctn, blink 8/min")
    assert mine.name == "announcer-ctn" and dict(mine.knobs)["blink"] == 8.0
