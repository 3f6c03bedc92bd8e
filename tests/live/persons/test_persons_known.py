"""What is made of sightings: late, out of order, wild, or of nobody; who is nearest, and who is forgotten."""

from __future__ import annotations

from math import inf, nan

import pytest

from facescript.ir.values import Point
from facescript.live.model import Sighting
from facescript.live.persons.estimate import Estimate
from facescript.live.persons.nearest import Nearest
from facescript.live.persons.persons import MOST, Persons


def sighting(time: float, x: float = 0.0, y: float = 0.0, z: float = 120.0, person: str = "person 1") -> Sighting:
    return Sighting(person, time, Point(x, y, z))


def seen(persons: Persons, until: float, start: float = 0.0, x: float = 0.0) -> None:
    for number in range(int(start * 30), int(until * 30)):
        persons.see(sighting(number / 30, x))
        persons.pass_to((number + 1) / 30)


@pytest.mark.parametrize("place", [(nan, 0, 100), (0, inf, 100), (0, 0, nan), (0, 0, -100), (0, 0, 0), (1e9, 0, 100)])
def test_a_place_at_which_nobody_can_be_is_none(place: tuple[float, float, float]) -> None:
    persons = Persons()
    persons.see(sighting(0.0, *place))
    assert persons.targets == ()
    assert persons.counts() == {"sightings nowhere": 1}


def test_sightings_out_of_order_and_from_the_future_change_nothing() -> None:
    persons = Persons()
    seen(persons, 1.0)
    persons.see(sighting(0.5, 90.0))
    persons.see(sighting(0.5, 90.0))
    persons.see(sighting(1e6))
    persons.pass_to(1.2)
    assert persons.target("person 1").trail.at(1.2).x == pytest.approx(0.0, abs=0.1)
    assert persons.counts() == {"sightings out of order": 2}


def test_one_wild_sighting_is_not_believed_and_two_that_agree_are() -> None:
    persons = Persons()
    seen(persons, 1.0)
    persons.see(sighting(1.0, 80.0))
    persons.pass_to(1.05)
    assert persons.target("person 1").trail.at(1.05).x == pytest.approx(0.0, abs=0.1)
    persons.see(sighting(1.034, 81.0))
    persons.pass_to(1.1)
    assert persons.target("person 1").trail.at(1.1).x == pytest.approx(81.0, abs=0.1)
    assert persons.counts() == {"sightings not believed": 1}


def test_how_far_off_sightings_are_is_learned() -> None:
    """The same wavering is nothing where all sightings waver, and a step where none did before."""

    def off(tremble: float) -> float:
        estimate = Estimate(0.0, (0.0, 0.0, 120.0))
        for number in range(1, 60):
            estimate.take(number / 30, ((-1) ** number * tremble, 0.0, 120.0))
        for number in range(60, 66):
            estimate.take(number / 30, (1.0, 0.0, 120.0))
        return estimate.place[0]

    assert off(0.0) > 0.95
    assert off(3.0) < 0.5


def test_who_is_not_seen_is_lost_and_found_and_each_is_told_once() -> None:
    persons = Persons()
    seen(persons, 1.0)
    version, trail = persons.version, persons.target("person 1").trail
    persons.pass_to(1.3)
    assert (persons.version, trail.gap(1.3)) == (version, None)
    persons.pass_to(1.6)
    persons.pass_to(1.8)
    assert persons.version == version + 1
    assert trail.gap(1.7) is not None
    seen(persons, 2.5, start=2.0, x=50.0)
    assert persons.version == version + 2
    assert trail.at(2.4).x == pytest.approx(50.0, abs=0.5)


def test_who_is_told_of_seldom_is_waited_for_longer_and_who_is_told_of_once_until_she_leaves() -> None:
    persons = Persons()
    for second in range(5):
        persons.pass_to(float(second))
        persons.see(sighting(float(second)))
        persons.see(sighting(0.0, person="ann"))
    persons.pass_to(6.5)
    seldom, once = (persons.target(name).trail for name in ("person 1", "ann"))
    assert seldom.gap(6.5) is None
    persons.pass_to(60.0)
    assert seldom.gap(60.0) is not None
    assert once.gap(60.0) is None
    persons.leave("ann")
    persons.pass_to(61.0)
    assert once.gap(61.0) is not None


def test_nobody_is_known_without_end() -> None:
    persons = Persons()
    for number in range(MOST + 10):
        persons.see(sighting(0.0, person=f"person {number}"))
        persons.see(sighting(0.04, person=f"person {number}"))
    assert len(persons.targets) == MOST
    persons.pass_to(1.0)
    persons.forget({"person 3"})
    assert [target.name for target in persons.targets] == ["person 3"]


def test_the_nearest_does_not_flicker() -> None:
    nearest, turns = Nearest(), []
    for step in range(100):
        one, other = (100.0 + sign * (-1) ** step * 4.0 for sign in (1.0, -1.0))
        turns.append(nearest.look(step * 0.05, {"ann": one, "ben": other}))
    assert turns.count(True) == 1
    assert turns[0]


def test_another_is_nearest_who_is_plainly_nearer_for_a_while() -> None:
    nearest = Nearest()
    assert nearest.look(0.0, {"ann": inf})
    assert nearest.look(0.1, {"ann": inf, "ben": 200.0})
    assert not nearest.look(0.2, {"ann": 150.0, "ben": 200.0})
    assert not nearest.look(0.4, {"ann": 150.0, "ben": 200.0})
    assert nearest.look(0.5, {"ann": 150.0, "ben": 200.0})
    assert not nearest.look(0.6, {})
    assert nearest.look(0.7, {"ben": 200.0})
