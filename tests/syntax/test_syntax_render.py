"""Diagnostics as a terminal and as JSON show them: exact places, true widths, nothing that steers, nothing endless."""

from __future__ import annotations

import json

import pytest
from outlines import read

from facescript.diagnostics.columns import columns
from facescript.diagnostics.model import Diagnostic, Edit, Fix, Related, Severity
from facescript.diagnostics.render import MOST_RELATED, WIDEST, as_json, render
from facescript.text import Source, Span


def first(text: str) -> Diagnostic:
    return read(text)[1].items[0]


def shown(text: str, start: int, end: int, message: str = "So it is.") -> list[str]:
    span = Span(Source("script.face", text), start, end)
    return render(Diagnostic("FS999", Severity.WARNING, message, span), colour=False).split("\n")


def test_a_diagnostic_shows_its_place_and_its_fix() -> None:
    assert render(first("scene a:\n    wait 2 s\n"), colour=False) == (
        "error FS113: Write the unit `s` touching its number.\n"
        " --> script.face:2:10\n"
        "  |\n"
        "2 |     wait 2 s\n"
        "  |          ^^^\n"
        "  = fix: write `2s`"
    )


def test_related_places_are_shown_and_bounded() -> None:
    source = Source("script.face", "let a = 1s\nlet a = 2s\n")
    related = Related(Span(source, 4, 5), "it is defined here first")
    item = Diagnostic("FS999", Severity.HINT, "So it is.", Span(source, 15, 16), related=(related,))
    assert render(item, colour=False).split("\n")[5:] == [
        "  = it is defined here first", " --> script.face:1:5", "  |", "1 | let a = 1s", "  |     -",
    ]  # fmt: skip
    many = Diagnostic("FS999", Severity.HINT, "So it is.", None, related=(related,) * (MOST_RELATED + 3))
    assert render(many, colour=False).endswith("= and 3 more places")


@pytest.mark.parametrize(
    ("text", "start", "end", "carets"),
    [
        ("小明 nod!", 6, 7, "         ^"),
        ("小明 nod", 0, 2, " ^^^^"),
        ("zoe\u0308 nod", 5, 8, "     ^^^"),
        ("nod", 3, 3, "    ^"),
        ("a\n\nnod", 2, 2, " ^"),
        ("ab\ncd", 0, 5, " ^^"),
        ("a\tnod", 2, 5, "      ^^^"),
        ("😀 nod", 2, 5, "    ^^^"),
    ],
)
def test_carets_stand_below_what_they_mean(text: str, start: int, end: int, carets: str) -> None:
    assert shown(text, start, end)[-1].split("|")[1] == carets


def test_of_a_huge_line_a_piece_around_the_place_is_shown() -> None:
    rows = shown("x" * 50_000 + "HERE" + "y" * 50_000, 50_000, 50_004)
    assert max(map(len, rows)) < WIDEST + 20
    place = rows[-1].index("^")
    assert rows[-2][place : place + 4] == "HERE"
    assert rows[-1].count("^") == 4
    assert rows[-2].count("…") == 2
    assert len(shown("x", 0, 1, message="z" * 10**6)[0]) < 2000


@pytest.mark.parametrize("sign", ["\x1b", "\x07", "\u202e", "\x9b", "\r", "\ud800", "\u2066"])
def test_nothing_steers_the_terminal(sign: str) -> None:
    rows = "\n".join(shown(f"a{sign}b", 0, 3, message=f"`{sign}`"))
    assert sign not in rows
    assert rows.count("\N{REPLACEMENT CHARACTER}") == 2


def test_colours_are_added_and_nothing_else() -> None:
    item = first("nod!\n")
    plain, coloured = render(item, colour=False), render(item, colour=True)
    assert coloured != plain
    for code in ("\x1b[1;31m", "\x1b[1m", "\x1b[2m", "\x1b[0m"):
        coloured = coloured.replace(code, "")
    assert coloured == plain


def test_a_record_has_lines_and_columns_from_one() -> None:
    source = Source("a/script.face", "nod\nshow smle\n")
    span = Span(source, 9, 13)
    fix = Fix("did you mean `smile`?", (Edit(span, "smile"),))
    other = Related(Span(source, 0, 3), "here too")
    record = as_json(Diagnostic("FS999", Severity.ERROR, "So it is.", span, (fix,), (other,)))
    place = {"file": "a/script.face", "line": 2, "column": 6, "end_line": 2, "end_column": 10}
    assert record == {
        "code": "FS999", "severity": "error", **place, "message": "So it is.",
        "fixes": [{"title": "did you mean `smile`?", "edits": [{**place, "text": "smile"}]}],
        "related": [{**place, "line": 1, "column": 1, "end_line": 1, "end_column": 4, "message": "here too"}],
    }  # fmt: skip
    assert json.loads(json.dumps(record)) == record


def test_a_record_without_a_place_says_so() -> None:
    record = as_json(Diagnostic("FS999", Severity.ERROR, "So it is.", None))
    assert [record[key] for key in ("file", "line", "column", "end_line", "end_column")] == [None] * 5


def test_columns_are_those_of_a_terminal() -> None:
    assert [columns(text) for text in ("", "abc", "小明", "e\u0301", "ｱ", "Ａ", "😀")] == [0, 3, 4, 1, 1, 2, 2]
