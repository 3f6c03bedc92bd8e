"""`play` as a statement: what it means, what is said of a file that cannot be played, its form in JSON, its layout."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from plays import codes, play_of, resolved, verbs

from facescript.ir.acts import Perform, Timing
from facescript.ir.json_form import dump, load
from facescript.ir.values import Draw
from facescript.world import World
from facescript.writing.script import write

TAKE = "time,ada.lid.left,bruno.lid.left\n0,0,1\n0.5,0.5,1\n"


@pytest.fixture
def root(tmp_path: Path) -> Path:
    (tmp_path / "takes").mkdir()
    (tmp_path / "takes" / "take.csv").write_text(TAKE)
    return tmp_path


def test_what_a_line_means(root: Path) -> None:
    text = 'face ada = woman\nplay "takes/take.csv"\nplay "takes/take.csv" for 1s to 2s, speed 80%\n'
    plain, longer = verbs(text, root)
    assert isinstance(plain, Perform) and isinstance(longer, Perform)
    assert (plain.speed, plain.timing) == (1.0, Timing())
    assert (longer.speed, longer.timing.lasting) == (0.8, Draw(1.0, 2.0))
    assert plain.take is longer.take, "a file is read once"
    assert (plain.take.path, plain.take.kind, plain.take.columns) == ("takes/take.csv", "channels", ("lid.left",))
    assert (plain.take.frames, plain.take.duration) == (2, 1.0)


def test_of_a_table_of_several_faces_each_plays_its_own(root: Path) -> None:
    text = 'face ada = woman\nface bruno = man\nada: play "takes/take.csv"\nbruno: play "takes/take.csv"\n'
    ada, bruno = verbs(text, root)
    assert isinstance(ada, Perform) and isinstance(bruno, Perform)
    assert ada.take.data != bruno.take.data


def test_a_path_may_stand_in_a_cell_or_a_name(root: Path) -> None:
    (root / "trials.csv").write_text("file\ntakes/take.csv\n")
    text = 'face ada = woman\nlet take = "takes/take.csv"\nplay take\nrepeat row in "trials.csv":\n    play row.file\n'
    assert [type(verb) for verb in verbs(text, root)] == [Perform, Perform]


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ('play "nothing.csv"', "FS701"),
        ('play "../outside.csv"', "FS701"),
        ('play "wrong.csv"', "FS730"),
        ('play "takes/take.csv", speed 5%', "FS304"),
        ('play "takes/take.csv" over 1s', "FS309"),
        ("play", "FS312"),
    ],
)
def test_what_is_wrong_is_said_with_its_code(line: str, code: str, root: Path) -> None:
    (root / "wrong.csv").write_text("time,lid.left\n0,open\n")
    assert codes(f"face ada = woman\n{line}\n", root) == [code]


def test_the_fault_says_the_line_of_the_file(root: Path) -> None:
    (root / "wrong.csv").write_text("time,lid.left\n0,0\n1,nan\n")
    (item,) = resolved('face ada = woman\nplay "wrong.csv"\n', root)[1]
    assert item.message == "“wrong.csv” cannot be played: line 3: `nan` in the column `lid.left` is no finite number."


def test_a_play_in_json_has_the_take_and_is_written_as_its_line(root: Path) -> None:
    play = play_of('face ada = woman\nplay "takes/take.csv" for 400ms, speed 120% as mine\n', root)
    form = json.loads(dump(play))
    (item,) = form["play"]["scenes"][0]["body"]["items"]
    assert item["verb"]["type"] == "Perform" and item["verb"]["take"]["columns"] == ["lid.left"]
    assert load(dump(play)).scenes[0].body.items[0].verb == play.scenes[0].body.items[0].verb  # type: ignore[union-attr]
    assert 'play "takes/take.csv" for 400ms, speed 120% as mine' in write(play, World(root), "script.face").text


def test_a_face_that_is_only_heard_cannot_be_played(root: Path) -> None:
    text = 'face ada = woman\nface teller = unseen\nteller: play "takes/take.csv"\nada: nod\n'
    assert codes(text, root) == ["FS237"]
