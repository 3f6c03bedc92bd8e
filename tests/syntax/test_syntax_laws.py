"""Laws of parser and formatter: no text brings them down, faults keep to their lines, the layout changes no meaning."""

from __future__ import annotations

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from outlines import HERE, SCRIPTS, bare, read

from facescript.diagnostics.render import as_json, render
from facescript.syntax.faults import MOST
from facescript.syntax.formatter import format_source
from facescript.text import Source

TEXTS = [path.read_text("utf-8") for path in [*SCRIPTS, *sorted((HERE / "faults").glob("*.face"))]]
SIGNS = st.sampled_from('abnod:;,.+-=*/()"#\\ \t\n0123%“”：（é山\u202e\0\u3000\ud800\u0301😀')
WORDS = st.sampled_from(
    "scene at on nod : say ( ) = + - , face 2s in turn together repeat # .2 c.2 x( life target let as for with".split()
)
MARGINS = st.sampled_from(["\n", "\n    ", "\n        ", " ", "", "\n      "])
SOUP = st.lists(st.one_of(WORDS, MARGINS, SIGNS), max_size=80).map("".join)


@st.composite
def spoilt(draw: st.DrawFn) -> str:
    """A script with some stretches replaced by others."""
    text = draw(st.sampled_from(TEXTS))
    for _ in range(draw(st.integers(1, 6))):
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.integers(0, 5)))
        text = text[:start] + draw(st.one_of(st.just(""), SIGNS, WORDS, MARGINS)) + text[end:]
    return text


def holds(text: str) -> None:
    """What holds of any text at all."""
    script, diagnostics = read(text)
    assert len(diagnostics.items) <= MOST + 1
    for item in diagnostics:
        assert item.span is not None
        assert 0 <= item.span.start <= item.span.end <= len(text)
        assert all(0 <= edit.span.start <= edit.span.end <= len(text) for fix in item.fixes for edit in fix.edits)
        assert "{" not in item.message or "{" in text
        assert render(item, colour=True)
        assert as_json(item)["line"] >= 1
    if diagnostics.failed:
        assert format_source(script.source) == text


@settings(max_examples=300, deadline=None)
@given(SOUP)
def test_no_soup_of_words_brings_the_parser_down(text: str) -> None:
    holds(text)


@settings(max_examples=200, deadline=None)
@given(spoilt())
def test_no_spoilt_script_brings_the_parser_down(text: str) -> None:
    holds(text)


@settings(max_examples=100, deadline=None)
@given(st.text(max_size=200))
def test_no_text_brings_the_parser_down(text: str) -> None:
    holds(text)


PIECES = (
    *("!", "a:", "(", '"', '"\\', " ", ",", "a.", "a-", "1.", "9", "a\u0301", "\r", "choose: "),
    *(
        "!\n",
        "nod\n",
        "a:\n",
        "(\n",
        "a,\n",
        "a+\n",
        "\tnod\n",
        "#a\n",
        "“”\n",
        "：\n",
        "\u202e\n",
        "secne x:\n",
        "a,\nb:\n",
    ),
    *("a:\n  b\n   c\n b\n", "nod\n  nod\n"),
)


@pytest.mark.parametrize("piece", PIECES)
def test_64_kib_of_anything_is_read(piece: str) -> None:
    _, diagnostics = read((piece * (65536 // len(piece) + 1))[:65536])
    assert len(diagnostics.items) <= MOST + 1


@settings(max_examples=100, deadline=None)
@given(st.integers(0, 2**32), st.sampled_from(TEXTS[: len(SCRIPTS)]))
def test_a_fault_stays_in_its_line(seed: int, text: str) -> None:
    """A sign that means nothing, put into any line of words, gives one diagnostic, and it is in that line."""
    rows = text.split("\n")
    chosen = random.Random(seed).choice([number for number, row in enumerate(rows) if row.strip() and "#" not in row])
    rows[chosen] = rows[chosen].rstrip(",") + " ;" + ("," if rows[chosen].endswith(",") else "")
    _, diagnostics = read("\n".join(rows))
    assert [(item.code, item.span.source.position(item.span.start)[0]) for item in diagnostics if item.span] == [
        ("FS105", chosen + 1)
    ]


# ----------------------------------------------------------------------------------------------- scripts made at random

NAME = st.sampled_from(["ada", "bruno", "smile", "cup", "brow-up", "x_1", "阿梅"])
VALUE = st.sampled_from(
    ["300ms", "-12cm", "80%", "1.5s", "17/min", "3", "2 * beat", "(lift / 2)", "(0cm -5cm 2m)", "wry(80%, a = 2s)"]
)
WORD = st.one_of(NAME, VALUE, st.sampled_from(['"a text"', "smile.left", "crowd.2", "#dfe8f2", 'hello."cup".2.end']))
SPACE = st.sampled_from([" ", "  ", "   "])
COMMA = st.sampled_from([", ", " , ", " ,", ",\n  ", ",  # why\n"])
COMMENT = st.sampled_from(["", "", "", " # a note", "  #"])
BETWEEN = st.sampled_from(["", "", "", "\n", "\n\n\n", "# a remark\n", "      # deep\n"])


@st.composite
def phrases(draw: st.DrawFn) -> str:
    rows = draw(st.lists(st.lists(WORD, min_size=1, max_size=4), min_size=1, max_size=3))
    text = draw(st.sampled_from(["show", "look at", "say", "unit"]))
    for number, words in enumerate(rows):
        text += draw(COMMA) if number else draw(SPACE)
        text += draw(SPACE).join(words)
    return text + draw(st.sampled_from(["", " over 2s", ", over 2s for 3s", " as hello, eyes only", " as last"]))


@st.composite
def statement(draw: st.DrawFn, indent: int, depth: int) -> str:
    margin = " " * indent
    kind = draw(st.sampled_from(["act", "act", "act", "say", "block", "inline"] if depth else ["act"]))
    tail = draw(COMMENT) + "\n"
    if kind == "act":
        return draw(BETWEEN) + margin + draw(phrases()) + tail
    if kind == "say":
        return f'{margin}say "a"{tail}{margin}   "more"\n{margin}   on  "a" : {draw(phrases())}\n'
    head = draw(
        st.sampled_from(["ada", "together", "in  turn", "choose", "repeat 3 times", "at 2s", "at hello.end + 3s"])
    )
    if kind == "inline":
        return f"{margin}{head} :{draw(phrases())}{tail}"
    inner = indent + draw(st.sampled_from([2, 3, 4]))
    return f"{margin}{head}:{tail}" + draw(block(inner, depth - 1))


def block(indent: int, depth: int) -> st.SearchStrategy[str]:
    return st.lists(statement(indent, depth), min_size=1, max_size=3).map("".join)


@st.composite
def whole(draw: st.DrawFn) -> str:
    head = draw(
        st.sampled_from(
            ["", "film 1280x720,30fps\n", "face ada=woman, voice en-gb # who\n  hair #5b3a22\n", "let beat=2s\n"]
        )
    )
    middle = draw(
        st.sampled_from(
            ["", "target t moves\n 0s -1cm 2cm\n  # then\n 10s 30cm 4cm\n", "expression e(a=1%)=smile+\n AU6 a\n"]
        )
    )
    return head + middle + "scene a:\n" + draw(block(draw(st.sampled_from([1, 4, 8])), 2)) + draw(BETWEEN)


def comments(text: str) -> list[str]:
    return sorted(
        "#" + row.split("#")[-1].rstrip() for row in text.split("\n") if " # " in f" {row} " or row.endswith(" #")
    )


@settings(max_examples=200, deadline=None)
@given(whole())
def test_the_layout_keeps_meaning_and_comments_and_is_stable(text: str) -> None:
    script, diagnostics = read(text)
    assert not diagnostics.failed
    done = format_source(script.source)
    again, _ = read(done)
    assert bare(again) == bare(script)
    assert comments(done) == comments(text)
    assert format_source(Source("script.face", done)) == done
    assert "\n\n\n" not in done
    assert all(row == row.rstrip() for row in done.split("\n"))


def test_a_line_that_was_mended_is_not_read_again_with_a_colon() -> None:
    """`let x: times` is meant as `let x = times`, which no colon makes the head of a block."""
    _, diagnostics = read("let x: times\n    wait 1s\n")
    assert [item.code for item in diagnostics][:1] == ["FS124"]
