"""Ears and muzzle: channels of the kinds that have them, driven as any other, flicked by a life, unseen elsewhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from living import life, lived, preset
from performing import Floats, add, grid, score, show

from facescript.ir.acts import Life
from facescript.motion.blend import ear_limit
from facescript.motion.perform import perform
from facescript.performance.channels import NAMES, OWN, channels_of
from facescript.performance.performance import Performance
from facescript.resolve.kinds.library import kind_names, kinds_with, library_head
from facescript.schedule.score import Score

EARS = ("ear.left", "ear.right")


HAS = {kind: library_head(kind).channels for kind in kind_names()}


def of_kind(played: Score, kind: str) -> Performance:
    faces = tuple(replace(face, kind=kind, parts=HAS[kind]) for face in played.faces)
    return perform(replace(played, faces=faces))


def flicked(kind: str, what: Life, duration: float = 600.0) -> dict[str, Floats]:
    performance = of_kind(score([], duration, what), kind)
    return dict(zip(performance.names, performance.sample(grid(duration, 60.0)).T, strict=True))


def test_which_kind_has_what() -> None:
    assert channels_of(HAS["woman"]) == channels_of(HAS["man"]) == NAMES
    assert channels_of(HAS["dog"]) == channels_of(HAS["rodent"]) == (*NAMES, *(channel.name for channel in OWN))
    assert channels_of(HAS["gorilla"]) == (*NAMES, "muzzle.left", "muzzle.right")
    assert kinds_with("ear.left") == ("dog", "rodent") and kinds_with("lid.left") == ()


def test_a_table_shows_what_its_face_has() -> None:
    """A sum with ears plays on every face; on a woman it is the sum without them, to the bit."""
    feeling = {"cheek.lower.left": 0.5, "ear.left": -0.6, "ear.right": 0.9, "muzzle.left": 0.4}
    human = {"cheek.lower.left": 0.5}
    times = grid(4.0, 30.0)
    dog = of_kind(score([show(0.5, feeling)]), "dog")
    assert dog.names == channels_of(HAS["dog"])
    assert [channel.name for channel in dog.channels] == list(dog.names)
    drawn = dog.pose(2.0)
    assert (drawn["ear.left"], drawn["muzzle.left"], drawn["muzzle.right"]) == pytest.approx((-0.6, 0.4, 0.0))
    assert 0.8 < drawn["ear.right"] < 0.9
    assert of_kind(score([show(0.5, feeling)]), "gorilla").pose(2.0)["muzzle.left"] == pytest.approx(0.4)
    woman = perform(score([show(0.5, feeling)]))
    assert woman.names == NAMES
    assert np.array_equal(woman.sample(times), perform(score([show(0.5, human)])).sample(times))


def test_two_faces_have_each_their_own() -> None:
    played = score()
    (ada,) = played.faces
    both = replace(played, faces=(ada, replace(ada, name="rex", kind="gorilla", parts=HAS["gorilla"])))
    names = perform(both).names
    assert len(names) == 2 * len(NAMES) + 2
    assert "rex.muzzle.left" in names and "ada.muzzle.left" not in names and "rex.ear.left" not in names
    assert perform(both).sample(grid(1.0, 10.0)).shape == (10, len(names))


def test_ears_add_and_are_limited_both_ways() -> None:
    up, down = {"ear.left": 0.5, "ear.right": -0.5}, {"ear.left": 0.2, "ear.right": -0.9}
    drawn = of_kind(score([show(0.0, up), add(0.0, down, order=1)]), "rodent").pose(2.0)
    assert drawn["ear.left"] == pytest.approx(0.7)
    assert -1.0 < drawn["ear.right"] < -0.9
    values = np.linspace(-3.0, 3.0, 121)
    assert np.array_equal(ear_limit(-values), -ear_limit(values)) and np.abs(ear_limit(values)).max() <= 1.0
    assert np.all(np.diff(ear_limit(values)) >= 0.0)


def test_ears_flick_now_and_then() -> None:
    """As often as the knob says, one ear mostly, back and not far; a life that is still has none."""
    drawn = flicked("dog", life(brows=6.0))
    both = np.array([drawn[name] for name in EARS])
    moving = (np.abs(both) > 0.02).any(axis=0)
    count = int((np.diff(np.flatnonzero(moving)) > 30).sum()) + 1
    assert 40 <= count <= 75
    assert 0.01 < moving.mean() < 0.1 and -0.65 < both.min() < -0.4 and both.max() < 0.2
    together = (np.abs(both) > 0.02).all(axis=0).sum() / moving.sum()
    assert 0.02 < together < 0.4
    assert not any(flicked("dog", preset("still"), 60.0)[name].any() for name in EARS)


def test_flicks_change_nothing_else() -> None:
    """A woman of the same name and seed lives as the dog does, but for the ears."""
    drawn, hers = flicked("dog", preset("conversation"), 60.0), lived(preset("conversation"), 60.0)
    assert all(np.array_equal(drawn[name], hers[name]) for name in NAMES)
