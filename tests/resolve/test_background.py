"""`background`: colours, gradients, pictures and nothing, and what is said of those that cannot be."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from PIL import Image
from plays import codes, play_of, resolved, verbs

from facescript.ir.acts import Gradient, SetBackground
from facescript.ir.json_form import dump, load
from facescript.pictures import MOST_PIXELS
from facescript.schedule.phrases import phrase
from facescript.syntax.formatter import format_source
from facescript.text import Source

DAWN, DUSK = "#102040", "#304060"


def picture(size: tuple[int, int] = (8, 8), kind: str = "PNG") -> bytes:
    file = io.BytesIO()
    Image.new("1" if kind == "PNG" else "RGB", size).save(file, kind)
    return file.getvalue()


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        (f"background {DAWN}", SetBackground(DAWN, None)),
        ("background #AABBCC80", SetBackground("#aabbcc80", None)),
        ("background none", SetBackground(None, None)),
        ("background none over 2s", SetBackground(None, None, 2.0)),
        (f"background {DAWN} to {DUSK}", SetBackground(None, None, gradient=Gradient((DAWN, DUSK), -90.0))),
        (f"background {DAWN} to {DUSK}, left to right over 1s",
         SetBackground(None, None, 1.0, Gradient((DAWN, DUSK), 0.0))),
        (f"background {DAWN} to {DUSK}, top to bottom",
         SetBackground(None, None, gradient=Gradient((DAWN, DUSK), -90.0))),
        (f"background {DAWN} to {DUSK}, towards -30deg",
         SetBackground(None, None, gradient=Gradient((DAWN, DUSK), -30.0))),
        (f"background {DAWN} to {DUSK} to #ffffff, round over 500ms as sky",
         SetBackground(None, None, 0.5, Gradient((DAWN, DUSK, "#ffffff"), None))),
    ],
)  # fmt: skip
def test_what_a_line_means(line: str, meant: SetBackground) -> None:
    assert verbs(f"{line}\n") == [meant]


@pytest.mark.parametrize(
    "lines",
    [
        f"let sky = {DAWN} to {DUSK}\nbackground sky\n",
        f"let top = {DAWN}\nlet low = {DUSK}\nlet sky = top to low\nlet other = sky\nbackground other\n",
        f"let low = {DUSK}\nbackground {DAWN} to low\n",
        f"action paint(sky = {DAWN} to {DUSK}):\n    background sky\npaint\n",
        f"action paint(sky):\n    background sky\npaint {DAWN} to {DUSK}\n",
    ],
)
def test_names_stand_for_colours(lines: str) -> None:
    assert verbs(lines) == [SetBackground(None, None, gradient=Gradient((DAWN, DUSK), -90.0))]


def test_cells_are_read_as_backgrounds(tmp_path: Path) -> None:
    (tmp_path / "room.png").write_bytes(picture())
    (tmp_path / "trials.csv").write_text(f"sky\nroom.png\nnone\n{DAWN}\n{DAWN} to {DUSK}\n", "utf-8")
    script = 'repeat trial in "trials.csv":\n    background trial.sky\n'
    assert verbs(script, tmp_path) == [
        SetBackground(None, "room.png"),
        SetBackground(None, None),
        SetBackground(DAWN, None),
        SetBackground(None, None, gradient=Gradient((DAWN, DUSK), -90.0)),
    ]


@pytest.mark.parametrize(
    ("line", "code", "said"),
    [
        ("background", "FS314", "is no colour"),
        ("background blue", "FS314", "`blue` is no colour"),
        ("background transparent", "FS314", "or `none`"),
        (f"background {DAWN} to", "FS314", "is no colour"),
        (f"background {DAWN} to blue", "FS314", "`blue` is no colour"),
        (f"background {DAWN} {DUSK}", "FS340", "between two colours stands `to`"),
        (f"background {DAWN}, round", "FS340", "one colour"),
        (f"background {DAWN} to none", "FS340", "`none` is no colour"),
        ("background none, left to right", "FS340", "`none` is no colour"),
        (f'background "room.png" to {DAWN}', "FS340", '`"room.png"` is no colour'),
        (f"background {' to '.join([DAWN] * 17)}", "FS340", "more than 16"),
        (f"background {DAWN} to {DUSK}, sideways", "FS308", "sideways"),
        (f"background {DAWN} to {DUSK}, round, left to right", "FS310", "twice"),
        (f"background {DAWN} to {DUSK}, towards 2s", "FS302", "an angle"),
        (f"background {DAWN} to {DUSK}, towards 10deg to 20deg", "FS307", "draw"),
        ('background "notes.png"', "FS720", "none of PNG, JPEG, WEBP, GIF, BMP"),
        ('background "cut.jpg"', "FS720", "it is broken"),
        ('background "huge.png"', "FS720", "64 million pixels"),
        ('background "vast.png"', "FS720", "64 million pixels"),
        ('background "nowhere.png"', "FS701", "there is no such file"),
        ('background ".."', "FS701", "outside the project's folder"),
        ('background "../room.png"', "FS701", "outside the project's folder"),
        ('background "/etc/passwd"', "FS701", "outside the project's folder"),
        ('background "http://example.com/sky.png"', "FS701", "it is an address"),
        ('background "HTTPS://example.com/sky.png"', "FS701", "it is an address"),
        ('background "//example.com/sky.png"', "FS701", "it is an address"),
        ('background "file:///etc/passwd"', "FS701", "it is an address"),
        ('background "data:image/png;base64,AAAA"', "FS701", "it is an address"),
    ],
)
def test_what_cannot_be_is_told_at_its_place(line: str, code: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "room.png").write_bytes(picture())
    (tmp_path / "notes.png").write_text("Buy a picture of the sea.")
    (tmp_path / "cut.jpg").write_bytes(picture((400, 400), "JPEG")[:800])
    if "huge" in line:
        (tmp_path / "huge.png").write_bytes(picture((MOST_PIXELS // 1000 + 1, 1000)))
    if "vast" in line:
        (tmp_path / "vast.png").write_bytes(picture((20_000, 20_000)))
    _, diagnostics = resolved(f"nod\n{line}\n", tmp_path)
    (found,) = diagnostics
    assert found.code == code
    assert said in found.message
    assert found.span is not None
    assert found.span.source.position(found.span.start)[0] == 2


def test_a_word_for_nothing_is_mended() -> None:
    for word in ("transparent", "nothing", "non"):
        (found,) = resolved(f"background {word}\n")[1]
        assert [edit.text for fix in found.fixes for edit in fix.edits] == ["none"]


def test_a_picture_named_often_is_opened_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from facescript import pictures

    (tmp_path / "room.png").write_bytes(picture())
    seen: list[bytes] = []
    opened = pictures.opened
    monkeypatch.setattr(pictures, "opened", lambda data: (seen.append(data), opened(data))[1])
    assert codes('background "room.png"\nwait 1s\nbackground "./room.png"\n', tmp_path) == []
    assert len(seen) == 1


def test_the_commas_are_mended() -> None:
    text = f"background {DAWN}, to {DUSK} round, over 2s\n"
    play, diagnostics = resolved(text)
    assert play is not None
    assert sorted({item.code for item in diagnostics}) == ["FS140", "FS141"]
    assert verbs(text) == [SetBackground(None, None, 2.0, Gradient((DAWN, DUSK), None))]


def test_there_and_back_as_json_and_as_words() -> None:
    text = (
        f"background none\nwait 1s\nbackground {DAWN} to {DUSK}, left to right\nwait 1s\n"
        f"background {DAWN} to {DUSK} to #ffffff, towards 45deg\nwait 1s\nbackground {DAWN} to {DUSK}, round\n"
    )
    play = play_of(text)
    assert dump(load(dump(play))) == dump(play)
    written = [phrase(verb) for verb in verbs(text) if isinstance(verb, SetBackground)]
    assert written == [line for line in text.splitlines() if line != "wait 1s"]
    assert format_source(Source("a.face", text)) == text
