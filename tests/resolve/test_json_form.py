"""The JSON form of plays: there and back, its schema, what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest
from plays import play_of, resolved, shown

from facescript.ir.json_form import NotAPlay, dump, load, schema

SCRIPTS = Path(__file__).parent / "scripts"
RUNNING = [
    path for path in sorted(SCRIPTS.glob("*.face")) if "refused" not in path.with_suffix(".txt").read_text("utf-8")
]


@pytest.mark.parametrize("path", RUNNING, ids=lambda path: path.stem)
def test_there_and_back(path: Path) -> None:
    play, _ = resolved(path.read_text("utf-8"), SCRIPTS, path.name)
    assert play is not None
    text = dump(play)
    again = load(text)
    assert dump(again) == text
    assert shown(again) == shown(play)
    jsonschema.validate(json.loads(text), schema())


def test_spans_are_lines_and_columns() -> None:
    form = json.loads(dump(play_of("wait 1s\nshow smile 40%\n")))
    (wait, show) = form["play"]["scenes"][0]["body"]["items"]
    assert wait["span"] == {"file": "script.face", "line": 1, "column": 1, "end_line": 1, "end_column": 8}
    assert (show["span"]["line"], show["verb"]["type"]) == (2, "Show")


def test_fields_with_a_default_may_be_left_out() -> None:
    form = json.loads(dump(play_of("wait 1s\n")))
    del form["play"]["film"]["width"]
    assert load(json.dumps(form)).film.width == 1280


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"version": 2}, "version"),
        ({"play": {"type": "Play"}}, "play.film"),
        ({"extra": 1}, "extra"),
    ],
)
def test_other_json_is_no_play(change: dict[str, object], words: str) -> None:
    form = json.loads(dump(play_of("wait 1s\n")))
    with pytest.raises(NotAPlay, match=words):
        load(json.dumps({**form, **change}))


@pytest.mark.parametrize("text", ["", "[]", "{", "null", "[" * 100_000, '{"version": 1, "play": ' * 500])
def test_broken_json_is_no_play(text: str) -> None:
    with pytest.raises(NotAPlay):
        load(text)


def test_a_verb_of_no_kind_is_no_play() -> None:
    text = dump(play_of("wait 1s\n")).replace('"Wait"', '"Weight"')
    with pytest.raises(NotAPlay, match="Weight"):
        load(text)
