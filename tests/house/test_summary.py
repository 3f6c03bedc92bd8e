"""The summary for programs: it names all that the tables have, is printed, and comes with the wheel."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from facescript.cli.list import LISTS
from facescript.cli.main import main
from facescript.resolve.words import EASES, FACE, FILM, MODIFIERS, VERBS

SUMMARY = Path(__file__).parents[2] / "docs" / "summary.md"
LINES = 150

NAMED = ("expressions", "lives", "muscles", "faces", "backends")
WORDS = {*VERBS, *MODIFIERS, *FACE, *FILM, *EASES} - {"rate", "size"}


@pytest.mark.parametrize("what", NAMED)
def test_it_names_all_there_is(what: str) -> None:
    words = set(SUMMARY.read_text("utf-8").replace("`", " ").replace(",", " ").split())
    units = {f"AU{number}" for number in (*range(51, 59), *range(61, 65))}  # "`AU51` to `AU58`"
    assert [name for name, _ in LISTS[what]() if name not in words | units] == []


def test_it_has_every_verb_modifier_and_setting() -> None:
    text = SUMMARY.read_text("utf-8")
    assert [word for word in sorted(WORDS) if word not in text] == []


def test_it_names_the_library_s_actions() -> None:
    text = SUMMARY.read_text("utf-8")
    names = [form.split(",")[0].split()[0] for form, _ in LISTS["actions"]()]
    assert [name for name in names if f"`{name}" not in text and name not in VERBS] == []


def test_it_fits_a_page() -> None:
    assert SUMMARY.read_text("utf-8").count("\n") <= LINES


def test_list_prints_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "summary"]) == 0
    assert capsys.readouterr().out == SUMMARY.read_text("utf-8")


def test_list_prints_the_schema(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "schema"]) == 0
    jsonschema.Draft202012Validator.check_schema(json.loads(capsys.readouterr().out))
