"""The library: every unit and expression that is promised, what it drives, and that it may be covered."""

from __future__ import annotations

import pytest
from plays import EMPTY, play_of, resolved, verbs

from facescript.ir.acts import Show
from facescript.motion.drivers import ROWS
from facescript.resolve.definitions import library_names
from facescript.resolve.uses import library

UNITS = [1, 2, *range(4, 8), *range(9, 19), 20, *range(22, 29), *range(41, 47), *range(51, 59), *range(61, 65)]
EXPRESSIONS = (
    "smile frown wink excitement inquisitive happiness sadness surprise fear anger disgust contempt brows "
    "patent-surprise patent-disgust patent-smile nodding shaking tilting blinking winking"
).split()
LIVES = ["still", "calm", "reading", "conversation", "announcer"]
LIVES += ["announcer-ctn", "announcer-ettoday", "announcer-other"]


def drivers(name: str) -> dict[str, float]:
    (show,) = verbs(f"show {name}\n")
    assert isinstance(show, Show)
    return {driver.name: driver.value for driver in show.mix.terms[0].drivers}  # type: ignore[misc]


def test_the_library_has_what_is_promised() -> None:
    names = library_names(library(EMPTY)).library
    assert {name for name, found in names.items() if found.kind == "expression"} == {f"AU{n}" for n in UNITS} | set(
        EXPRESSIONS
    )
    assert [name for name, found in names.items() if found.kind == "life"] == LIVES


@pytest.mark.parametrize("name", [f"AU{n}" for n in UNITS] + EXPRESSIONS)
def test_it_drives_channels_within_their_ranges(name: str) -> None:
    found = drivers(name)
    assert found
    for driver, value in found.items():
        assert driver in ROWS
        if driver.startswith("lid."):
            assert -0.35 <= value <= 1.0
        elif driver.startswith("ear."):
            assert -1.0 <= value <= 1.0
        elif not driver.startswith(("head.", "eye.", "mouth.")):
            assert 0.0 <= value <= 1.0


def test_emotions_hold_the_units_of_their_recipes() -> None:
    recipes = {
        "happiness": (6, 12, 25),
        "sadness": (1, 4, 15),
        "surprise": (1, 2, 5, 26),
        "fear": (1, 2, 4, 20, 26),
        "anger": (4, 7, 23),
        "disgust": (9, 15, 16),
        "smile": (6, 12),
        "frown": (4, 15),
    }
    for name, units in recipes.items():
        found = drivers(name)
        for unit in units:
            moved = {driver for driver in drivers(f"AU{unit}") if not driver.startswith("lid.")}
            assert moved <= found.keys(), (name, unit)


def test_left_is_the_faces_own() -> None:
    assert drivers("AU51") == {"head.yaw": 30.0}
    assert drivers("AU55") == {"head.roll": 20.0}
    assert drivers("AU61") == {"eye.left.yaw": 30.0, "eye.right.yaw": 30.0}
    assert all(driver.endswith(".right") for driver in drivers("contempt"))
    assert all(driver.endswith(".left") for driver in drivers("wink.left"))


def test_the_patents_figures_muscle_by_muscle() -> None:
    surprise, disgust = drivers("patent-surprise"), drivers("patent-disgust")
    assert surprise.keys() == {"cheek.upper.left", "cheek.upper.right", "brow.inner.left", "brow.inner.right"}
    assert disgust["cheek.lower.left"] == disgust["cheek.upper.left"] == 1.0
    assert 0.0 < disgust["cheek.lower.right"] == disgust["cheek.upper.right"] < 0.5
    assert 0.0 < disgust["lid.left"] == disgust["lid.right"] < 0.5
    assert disgust["eye.left.pitch"] == disgust["eye.right.pitch"] < 0.0
    assert drivers("patent-smile").keys() == {"cheek.upper.left", "cheek.upper.right"}


def test_covering_one_name_changes_what_the_library_builds_on_it() -> None:
    play, diagnostics = resolved("expression AU12 = lip.stretch 50%\nshow smile\n")
    assert [item.code for item in diagnostics] == ["FS210"]
    assert play is not None
    show = play.scenes[0].body.items[0].verb  # type: ignore[union-attr]
    assert "lip.stretch.left" in {driver.name for driver in show.mix.terms[0].drivers}  # type: ignore[union-attr]


def test_still_does_nothing() -> None:
    (face,) = play_of("face ada = woman\n    life still\nada: nod\n").faces
    assert all(value == 0.0 for _, value in face.life.knobs)
