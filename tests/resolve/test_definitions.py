"""Definitions: films, faces, targets, lives, `use`, the one space of names, what nobody uses."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from plays import codes, play_of, resolved

from facescript.ir.acts import Life, SetBackground, SetLife, Voice
from facescript.ir.play import Crowd, Film, FixedTarget, MovingTarget, Play
from facescript.ir.values import PicturePlace, Point
from facescript.resolve.words import MODIFIERS, VERBS, WORDS


def test_a_script_of_one_line_has_one_face_and_one_scene() -> None:
    play = play_of('say "Hello."\n')
    assert [(face.name, face.kind, face.voice.language) for face in play.faces] == [("somebody", "woman", "en-us")]
    assert [(scene.name, scene.faces) for scene in play.scenes] == [("main", ("somebody",))]
    assert play.film == Film()


def test_film() -> None:
    film = play_of("film 1080x1920, 60fps, 35cm wide, 24s long, seed 5, screen measured\nnod\n").film
    assert film == Film(1080, 1920, 60.0, 5, 24.0, 0.6, 35.0)
    assert play_of("film screen 50%\nnod\n").film.screen == 0.5


@pytest.mark.parametrize(
    ("phrase", "code"),
    [
        ("8x8", "FS304"),
        ("2000fps", "FS304"),
        ("30fpss", "FS303"),
        ("seeds 5", "FS308"),
        ("screen petent", "FS329"),
        ("screen 200%", "FS304"),
        ("seed 2.5", "FS304"),
        ("20cm long", "FS302"),
        ("30fps, 25fps", "FS310"),
        ("wide", "FS308"),
    ],
)
def test_faults_of_films(phrase: str, code: str) -> None:
    assert codes(f"film {phrase}\nnod\n") == [code]


def test_faces() -> None:
    text = (
        "face ada = woman, voice en-gb female, rate 90%, pitch 110%\n    hair #5b3a22\n    clothes #FF0000\n"
        "    size 120%\n    at -25% 5%\n    gaze eye-mover\n    life calm, blink 8/min\n"
        "face bruno = man\nada: nod\nbruno: nod\n"
    )
    ada, bruno = play_of(text).faces
    assert ada.voice == Voice("en-gb", "female", 0.9, 1.1)
    assert (ada.looks, ada.size, ada.gaze) == ((("hair", "#5b3a22"), ("clothes", "#ff0000")), 1.2, "eye-mover")
    assert ada.place == PicturePlace(-0.25, 0.05)
    assert dict(ada.life.knobs)["blink"] == 8.0
    assert (bruno.kind, bruno.life.name, bruno.place) == ("man", "calm", None)


@pytest.mark.parametrize(
    ("written", "hair", "looks"),
    [
        ("hair still", "still", ()),
        ("hair #5b3a22 still", "still", (("hair", "#5b3a22"),)),
        ("hair #5b3a22", "", (("hair", "#5b3a22"),)),
    ],
)
def test_hair_that_is_still(written: str, hair: str, looks: tuple[tuple[str, str], ...]) -> None:
    (ada,) = play_of(f"face ada = woman\n    {written}\nada: nod\n").faces
    assert (ada.hair, ada.looks) == (hair, looks)


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("= womn", "FS329"),
        ("= woman, voice english", "FS326"),
        ("= woman, voice en-us female loud", "FS312"),
        ("= woman\n    hare #5b3a22", "FS308"),
        ("= woman\n    hair purpel", "FS249"),
        ("= woman\n    hair #5b3a22\n    hair #5b3a22", "FS310"),
        ("= woman\n    hair still purpel", "FS249"),
        ("= woman\n    gaze eyes-mover", "FS329"),
        ("= woman\n    life clam", "FS206"),
        ("= woman\n    size 2m", "FS302"),
        ("= woman\n    at 10cm 5cm 2m", "FS330"),
        ("= woman, rate 0%", "FS304"),
    ],
)
def test_faults_of_faces(line: str, code: str) -> None:
    assert codes(f"face ada {line}\nada: nod\nada: wink left\n") == [code]


@pytest.mark.parametrize(
    ("written", "place"),
    [
        ("0deg 0deg 2m", Point(0.0, 0.0, 200.0)),
        ("90deg 0deg 2m", Point(200.0, 0.0, 0.0)),
        ("-90deg 0deg 100cm", Point(-100.0, 0.0, 0.0)),
        ("0deg 90deg 2m", Point(0.0, 200.0, 0.0)),
        ("60deg 30deg 2m", Point(150.0, 100.0, 86.60254)),
        ("10cm -12cm 0.2m", Point(10.0, -12.0, 20.0)),
        ("(side * 2) -12cm 20cm", Point(10.0, -12.0, 20.0)),
        ("-25% 5%", PicturePlace(-0.25, 0.05)),
    ],
)
def test_places(written: str, place: Point | PicturePlace) -> None:
    (target,) = play_of(f"let side = 5cm\ntarget t at {written}\nlook at t\nadd head.x side for 1s\n").targets
    assert isinstance(target, FixedTarget)
    if isinstance(place, Point) and isinstance(target.place, Point):
        assert (target.place.x, target.place.y, target.place.z) == pytest.approx((place.x, place.y, place.z), abs=1e-5)
    else:
        assert target.place == place


angles = st.floats(-89, 89).map(lambda angle: round(angle, 3))


@given(angles, angles, st.integers(1, 5000))
def test_polar_places_are_as_far_as_they_say_and_on_the_side_they_say(azimuth: float, up: float, far: int) -> None:
    (target,) = play_of(f"target t at {azimuth}deg {up}deg {far}cm\nlook at t\n").targets
    assert isinstance(target, FixedTarget)
    assert isinstance(target.place, Point)
    place = target.place
    assert (place.x**2 + place.y**2 + place.z**2) ** 0.5 == pytest.approx(far, rel=1e-5)
    assert place.x * azimuth >= 0.0
    assert place.y * up >= 0.0
    assert place.z >= 0.0


def test_moving_targets_and_crowds() -> None:
    text = (
        "target bird moves\n    0s -80cm 0cm 2m\n    4s 0deg 0deg 1m\ntarget two of (-60cm 0cm 2m) bird (-10% 5%)\n"
        "look at bird\nscan two\n"
    )
    bird, two = play_of(text).targets
    assert isinstance(bird, MovingTarget)
    assert isinstance(two, Crowd)
    assert (bird.times, bird.places) == ((0.0, 4.0), (Point(-80.0, 0.0, 200.0), Point(0.0, 0.0, 100.0)))
    assert two.members == (Point(-60.0, 0.0, 200.0), "bird", PicturePlace(-0.1, 0.05))


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("at 25deg 2m", "FS330"),
        ("at 25deg 10deg 0m", "FS304"),
        ("at 25deg 10deg", "FS330"),
        ("at 25deg 10deg 2s", "FS330"),
        ("at 1cm + 2cm 3cm 4cm", "FS306"),
        ("at 1cm to 2cm 3cm 4cm", "FS207"),
        ("at 25 10 2", "FS330"),
        ("on 25deg 10deg 2m", "FS312"),
        ('from "track.csv"', "FS701"),
        ("from 3", "FS312"),
        ("from", "FS312"),
        ('from "track.csv" "other.csv"', "FS312"),
        ("at 99999999999m 0cm 1m", "FS304"),
        ("moves", "FS332"),
        ("moves\n    1s 1cm 1cm 1m\n    1s 2cm 2cm 2m", "FS324"),
        ("moves\n    1s 1cm 1cm 1m\n    2s -25% 5%", "FS330"),
        ("of (1cm 2cm 3m) lamb", "FS202"),
        ("of (1cm 2cm 3m) t", "FS214"),
        ("at 1cm 2cm 3m\n    1s 2cm 2cm 2m", "FS312"),
    ],
)
def test_faults_of_targets(line: str, code: str) -> None:
    use = "scan t" if line.startswith("of") else "look at t"
    assert codes(f"target t {line}\n{use}\n") == [code]


def test_lives() -> None:
    text = (
        "life mine = calm, blink 8/min\nlife own = blink 5/min, sway 10%\n"
        "life mine\nlife own over 1s\nlife mine, avert 30%\n"
    )
    first, second, third = (item.verb for item in play_of(text).scenes[0].body.items)  # type: ignore[union-attr]
    assert isinstance(first, SetLife)
    assert isinstance(second, SetLife)
    assert isinstance(third, SetLife)
    assert (first.life.name, dict(first.life.knobs)["blink"], dict(first.life.knobs)["sway"]) == ("calm", 8.0, 0.4)
    assert second.life == Life(
        "still", (("blink", 5.0), ("brows", 0.0), ("sway", 0.1), ("nods", 0.0), ("saccades", 0.0), ("avert", 0.0))
    )
    assert second.over == 1.0
    assert dict(third.life.knobs)["avert"] == 0.3
    assert codes("life a = b\nlife b = a\nlife a\n") == ["FS215"]


def test_what_stands_before_the_scenes_holds_for_all() -> None:
    text = (
        "face ada = woman\nface bruno = man\nbackground #dfe8f2\nview all\nada: life still\n"
        "scene one:\n    ada: nod\n    bruno: nod\nscene two:\n    ada: nod\n"
    )
    play = play_of(text)
    assert play.background == SetBackground("#dfe8f2", None)
    assert [scene.background for scene in play.scenes] == [play.background, play.background]
    assert [face.life.name for face in play.faces] == ["still", "calm"]


def test_definitions_may_stand_behind_their_use() -> None:
    text = "bow lamp, depth deep\naction bow(who, depth):\n    look at who\n    nod depth\n"
    assert codes(text + "let deep = 40%\ntarget lamp at 0deg 0deg 2m\n") == []


def used(folder: Path, files: dict[str, str]) -> tuple[Play | None, list[str]]:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")
    play, diagnostics = resolved(files["script.face"], folder)
    return play, [item.code for item in diagnostics]


def test_use_brings_definitions_of_files_of_files(tmp_path: Path) -> None:
    files = {
        "script.face": 'use "parts/a.face"\nuse "b.face"\nada: show grin\nada: bow\n',
        "parts/a.face": 'use "c.face"\nuse "../b.face"\nface ada = woman\n',
        "parts/c.face": "expression grin = AU12\nexpression spare = AU1\n",
        "b.face": "action bow:\n    nod\n",
    }
    play, found = used(tmp_path, files)
    assert play is not None
    assert found == []
    assert [face.name for face in play.faces] == ["ada"]


def test_faults_of_use(tmp_path: Path) -> None:
    circle = {"script.face": 'use "a.face"\nnod\n', "a.face": 'use "b.face"\n', "b.face": 'use "a.face"\n'}
    assert used(tmp_path, circle)[1] == ["FS702"]
    assert used(tmp_path, {"script.face": 'use "../outside.face"\nnod\n'})[1] == ["FS701"]
    assert used(tmp_path, {"script.face": 'use "/etc/passwd"\nnod\n'})[1] == ["FS701"]
    twice = {"script.face": 'use "a.face"\nlet beat = 1s\nwait beat\n', "a.face": "let beat = 2s\n"}
    assert used(tmp_path, twice)[1] == ["FS208"]
    play = {"script.face": 'use "a.face"\nwait beat\n', "a.face": "let beat = 2s\nscene one:\n    nod\n"}
    assert used(tmp_path, play)[1] == ["FS231"]


def test_a_script_of_definitions_is_for_others_to_use() -> None:
    assert codes("expression grin = AU12\nlet beat = 1s\n") == []


def test_a_second_definition_shows_the_first() -> None:
    (item,) = resolved("let beat = 1s\ntarget beat at 0deg 0deg 2m\nwait beat\n")[1]
    assert item.related[0].span.source.position(item.related[0].span.start) == (1, 5)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("let camera = 1s\n", "FS209"),
        ("expression wink = AU1\n", "FS209"),
        ("expression smile = AU1\n", "FS210"),
        ("let unused = 1s\n", "FS211"),
        ("expression odd = AU1\n", "FS211"),
        ("action odd:\n    blink\n", "FS211"),
        ("target odd at 0deg 0deg 2m\n", "FS211"),
        ("life odd = calm\n", "FS211"),
        ("expression odd = AU1 20deg\n", "FS302"),
        ("let odd = 2s + 1deg\n", "FS306"),
        ("let odd = even\n", "FS207"),
        ("expression odd(at) = AU1 at\n", "FS209"),
        ("expression odd(x, x) = AU1 x\n", "FS208"),
        ("expression odd = smile 20% to 40%\n", "FS307"),
    ],
)
def test_faults_of_definitions(text: str, code: str) -> None:
    found = codes(text + "nod\nshow smile\n")
    assert [item for item in found if item != "FS211" or code == "FS211"] == [code]


def test_nothing_is_called_unused_that_a_failed_line_may_have_used() -> None:
    assert codes("let beat = 1s\nwiat beat\n") == ["FS204"]
    assert codes("let beat = 1s\nlet rest = 2s\nwiat beat\n") == ["FS204", "FS211"]


def test_names_of_lines_that_cannot_be_read_are_not_called_unknown() -> None:
    found = codes("target lamp at 25deg (10deg 2m\nlook at lamp\n")
    assert "FS202" not in found
    assert len(found) == 1


def test_the_words_of_the_language() -> None:
    assert {"look", "together", "camera", "neutral", "when", "head"} <= WORDS
    assert not {"first", "crowd", "laugh", "smile", "beat", "guest"} & WORDS
    assert all(name in MODIFIERS for verb in VERBS.values() for name in verb.modifiers)
    assert MODIFIERS["over"].form == "over TIME"
    assert MODIFIERS["each"].form == "TIME each"


def test_scripts_that_use_each_other_without_end_are_refused(tmp_path: Path) -> None:
    chain = {f"s{number}.face": f'use "s{number + 1}.face"\n' for number in range(1200)}
    assert used(tmp_path, {"script.face": 'use "s0.face"\nnod\n', **chain})[1] == ["FS701"]
