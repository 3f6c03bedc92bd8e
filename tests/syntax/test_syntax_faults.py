"""Scripts with faults to exactly the diagnostics that are written above their lines, each with a fix that mends it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from outlines import HERE, codes, outline, read

from facescript.diagnostics.model import Diagnostic
from facescript.syntax.faults import MOST

FAULTS = sorted((HERE / "faults").glob("*.face"))
EXPECTED = re.compile(r"# (?:error|hint): (FS\d+(?: FS\d+)*)$")


def expected(text: str) -> list[tuple[int, str]]:
    """The line and the code of each diagnostic that a script says it has: of the line below the comment."""
    found = []
    for number, line in enumerate(text.split("\n"), 2):
        match = EXPECTED.match(line)
        found += [(number, code) for code in match[1].split()] if match else []
    return found


def place(item: Diagnostic) -> tuple[int, str]:
    assert item.span is not None
    return item.span.source.position(item.span.start)[0], item.code


def mended(text: str, item: Diagnostic) -> str:
    for edit in sorted(item.fixes[0].edits, key=lambda edit: -edit.span.start):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text


@pytest.mark.parametrize("path", FAULTS, ids=lambda path: path.stem)
def test_faults_are_told_where_they_are_and_nothing_else_is(path: Path) -> None:
    text = path.read_text("utf-8")
    assert sorted(place(item) for item in read(text)[1]) == sorted(expected(text))


@pytest.mark.parametrize("path", FAULTS, ids=lambda path: path.stem)
def test_a_fix_mends_its_fault(path: Path) -> None:
    text = path.read_text("utf-8")
    for item in read(text)[1]:
        if item.fixes and item.fixes[0].edits:
            assert codes(mended(text, item)).count(item.code) < codes(text).count(item.code), place(item)


def test_thirty_faults_give_thirty_diagnostics() -> None:
    path = HERE / "faults" / "thirty.face"
    assert len(read(path.read_text("utf-8"))[1].items) == 30


@pytest.mark.parametrize("text", ["", "\n", "# only this\n", "   \n\t\n"])
def test_an_empty_script_is_a_fault(text: str) -> None:
    assert codes(text) == ["FS123"]


def test_more_faults_than_anyone_reads_are_counted_and_not_told() -> None:
    assert codes("nod!\n" * (MOST + 100)) == ["FS105"] * MOST + ["FS119"]
    assert codes("nod!\n" * MOST) == ["FS105"] * MOST


def test_a_script_longer_than_any_is_refused() -> None:
    assert codes("nod\n" * (1024 * 1024 + 1)) == ["FS117"]


@pytest.mark.parametrize("sign", ["(", "a(", "a: ", "in turn: "])
def test_depth_is_bounded(sign: str) -> None:
    assert codes(f"show {sign * 900}\n" if "(" in sign else f"{sign * 900}nod\n") == ["FS118"]


def test_depth_by_indentation_is_bounded() -> None:
    assert codes("".join(" " * depth + "ada:\n" for depth in range(300)) + " " * 300 + "nod\nnod\n") == ["FS118"]


def test_what_stands_in_a_spoilt_block_is_still_read() -> None:
    assert codes('scene a!:\n    nod 2 s\n    say "x"\n        on "x": nod!\n') == ["FS105", "FS113", "FS105"]


def test_of_two_faults_in_a_line_the_first_is_told_and_the_lines_around_it_are_read() -> None:
    script, diagnostics = read("scene a:\n    nod\n    repeat 2 times nod)\n    blink\n")
    assert [item.code for item in diagnostics] == ["FS129"]
    assert outline(script) == "Scene a\n  Act nod\n  Act blink\n"
