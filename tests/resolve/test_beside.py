"""What stands beside the faces in a book: titles of chapters, pictures and links, and what is said of those amiss."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from PIL import Image
from plays import codes, play_of, resolved, verbs

from facescript.ir.acts import AddLink, SetPicture
from facescript.ir.json_form import dump, load
from facescript.schedule.phrases import phrase
from facescript.syntax.formatter import format_source
from facescript.text import Source


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A project with a picture."""
    file = io.BytesIO()
    Image.new("RGB", (8, 8)).save(file, "PNG")
    (tmp_path / "lake.png").write_bytes(file.getvalue())
    return tmp_path


@pytest.mark.parametrize(
    ("lines", "meant"),
    [
        ('picture "lake.png"', SetPicture("lake.png")),
        ('picture "lake.png" "A \\"lake\\" at dusk" as lake', SetPicture("lake.png", 'A "lake" at dusk')),
        ("picture none", SetPicture(None)),
        ('let shown = "lake.png"\npicture shown "A lake"', SetPicture("lake.png", "A lake")),
        ('action leaf(file):\n    picture file\nleaf "lake.png"', SetPicture("lake.png")),
        ('link "https://a.org/b?c=d&e#f" "More"', AddLink("https://a.org/b?c=d&e#f", "More")),
        ('link "http://a.org"', AddLink("http://a.org", "http://a.org")),
        ('link "mailto:ada@a.org" "Write to us"', AddLink("mailto:ada@a.org", "Write to us")),
    ],
)
def test_what_a_line_means(lines: str, meant: SetPicture | AddLink, root: Path) -> None:
    assert meant in verbs(f"{lines}\n", root)


def test_no_face_is_named_for_it(root: Path) -> None:
    script = 'face ada = woman\nface bruno = man\nada: say "A lake."\n    on "lake": picture "lake.png"\nlink "http://a.org"\n'
    script += "bruno: nod\n"
    assert codes(script, root) == []


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ('picture "gone.png"', "FS701"),
        ('picture "../lake.png"', "FS701"),
        ('picture "https://a.org/lake.png"', "FS701"),
        ('picture "script.txt"', "FS720"),
        ('picture "large.png"', "FS701"),
        ("picture lake", "FS312"),
        ("picture", "FS312"),
        ('picture "lake.png" dark', "FS312"),
        ('picture "lake.png" over 2s', "FS309"),
        ('link "javascript:alert(1)" "Go"', "FS535"),
        ('link " JavaScript:alert(1)" "Go"', "FS535"),
        ('link "data:text/html,hello"', "FS535"),
        ('link "file:///etc/passwd"', "FS535"),
        ('link "//a.org"', "FS535"),
        ('link "lake.html"', "FS535"),
        ('link "https://"', "FS535"),
        ('link "https://a b.org"', "FS535"),
        ('link "https://[a.org"', "FS535"),
        ('link "mailto:"', "FS535"),
        ("link", "FS312"),
    ],
)
def test_what_cannot_be(line: str, code: str, root: Path) -> None:
    (root / "script.txt").write_text("no picture", "utf-8")
    with (root / "large.png").open("wb") as file:
        file.truncate(17 * 1024 * 1024)
    assert codes(f"{line}\n", root) == [code]


def test_an_address_without_its_beginning_gets_one(root: Path) -> None:
    _, diagnostics = resolved('link "www.example.org/lakes" "Lakes"\n', root)
    assert [edit.text for item in diagnostics for fix in item.fixes for edit in fix.edits] == [
        '"https://www.example.org/lakes"'
    ]


def test_titles_of_film_and_scenes() -> None:
    play = play_of(
        'film 640x360, title "By the  lake", author "Ada Stone"\nscene one "The \\"first\\" walk":\n    nod\n'
        "scene two:\n    nod\n"
    )
    assert (play.film.title, play.film.author) == ("By the lake", "Ada Stone")
    assert [(scene.name, scene.title) for scene in play.scenes] == [("one", 'The "first" walk'), ("two", "")]


def test_a_title_before_the_cast() -> None:
    play = play_of('face ada = woman\nface bruno = man\nscene one "First" with bruno:\n    nod\n')
    assert [(scene.title, scene.faces) for scene in play.scenes] == [("First", ("bruno",))]


def test_a_title_is_a_text() -> None:
    assert codes("film title Lake\nnod\n") == ["FS312"]
    assert codes('film title ""\nnod\n') == ["FS312"]


def test_they_stand_in_the_json_form(root: Path) -> None:
    script = 'scene one "First":\n    picture "lake.png" "A lake"\n    link "http://a.org" "More"\n    nod\n'
    text = dump(play_of(script, root))
    assert dump(load(text)) == text


def test_they_are_told_and_laid_out_as_they_are_written(root: Path) -> None:
    assert phrase(SetPicture("lake.png", "A lake")) == 'picture "lake.png"'
    assert phrase(SetPicture(None)) == "picture none"
    assert phrase(AddLink("http://a.org", "More")) == 'link "http://a.org"'
    text = 'scene one "First":\n    picture "lake.png" "A lake"\n    link "http://a.org" "More" as more\n    nod\n'
    assert format_source(Source("script.face", text)) == text
