"""The one layout: what it looks like, that it is stable, and that it changes no meaning."""

from __future__ import annotations

from pathlib import Path

import pytest
from outlines import HERE, SCRIPTS, bare, golden, read

from facescript.syntax.formatter import format_source
from facescript.text import Source

LAYOUTS = sorted((HERE / "layouts").glob("*.before.face"))
FAULTS = [path for path in sorted((HERE / "faults").glob("*.face")) if path.stem != "commas"]


def layout(text: str) -> str:
    return format_source(Source("script.face", text))


@pytest.mark.parametrize("path", LAYOUTS, ids=lambda path: path.name.split(".")[0])
def test_layouts_are_as_kept(path: Path) -> None:
    golden(path.with_name(path.name.replace("before", "after")), layout(path.read_text("utf-8")))


@pytest.mark.parametrize("path", [*SCRIPTS, *LAYOUTS, HERE / "faults" / "commas.face"], ids=lambda path: path.stem)
def test_the_layout_means_the_same_and_is_its_own_layout(path: Path) -> None:
    text = path.read_text("utf-8")
    done = layout(text)
    assert bare(read(done)[0]) == bare(read(text)[0])
    assert list(read(done)[1]) == []
    assert layout(done) == done


@pytest.mark.parametrize("path", FAULTS, ids=lambda path: path.stem)
def test_a_script_with_errors_stays_as_it_is(path: Path) -> None:
    text = path.read_text("utf-8")
    assert layout(text) == text


def test_scripts_written_by_hand_change_by_their_columns_alone() -> None:
    for path in SCRIPTS:
        text = path.read_text("utf-8")
        assert layout(text).replace(" ", "") == text.replace(" ", "")


def test_a_comment_that_a_fix_would_take_along_keeps_its_comma() -> None:
    text = "look at cup over 2s,  # why\n    for 3s\n"
    assert layout(text) == text


def test_a_long_line_breaks_after_a_comma_or_plus_and_before_nothing_that_begins_anew() -> None:
    text = "show " + " + ".join(f"muscle{number} 10%" for number in range(12)) + "\n"
    rows = layout(text).split("\n")
    assert max(map(len, rows)) <= 100
    assert rows[0].endswith("+")
    assert rows[1].startswith("    muscle")
    assert layout("ada: look at " + "x" * 90 + ", eyes only\n") == "ada: look at " + "x" * 90 + ",\n    eyes only\n"
    assert layout("say " + '"' + "x" * 200 + '"\n') == "say " + '"' + "x" * 200 + '"\n'
    with_body = layout("scene s with " + "a" * 90 + ", b:\n    nod\n")
    assert with_body == "scene s with " + "a" * 90 + ",\n        b:\n    nod\n"


def test_line_ends_of_other_systems_become_ours() -> None:
    assert layout("nod\r\n\r\n\r\nblink # twice\r\n") == "nod\n\nblink  # twice\n"


def test_the_first_of_two_names_stays_where_it_is() -> None:
    assert layout("nod  as a as b\n") == "nod as a as b\n"
