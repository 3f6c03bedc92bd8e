"""The times that are shown in a document."""

from __future__ import annotations

from analysing import analysis
from lsprotocol import types

from facescript.lsp.features.inlay_hints import inlay_hints


def hints(text: str, first: int = 0, last: int = 99) -> dict[int, types.InlayHint]:
    where = types.Range(types.Position(first, 0), types.Position(last, 0))
    return {hint.position.line: hint for hint in inlay_hints(analysis(text), where)}


def labels(text: str, first: int = 0, last: int = 99) -> dict[int, str]:
    return {line: str(hint.label) for line, hint in hints(text, first, last).items()}


def tooltip(hint: types.InlayHint) -> str:
    assert isinstance(hint.tooltip, types.MarkupContent)
    return hint.tooltip.value


def test_every_act_has_its_start_and_its_end() -> None:
    text = "scene opening:\n    nod\n    show smile over 1s  # why\n    wait 1s\n    background #ffffff\n"
    assert labels(text) == {0: "0 → 2.7 s", 1: "0 → 0.7 s", 2: "0.7 → 1.7 s", 4: "2.7 s"}
    assert hints(text)[2].position == types.Position(2, len("    show smile over 1s  # why"))


def test_a_statement_that_is_played_again_has_its_first_time_and_how_often() -> None:
    text = "repeat 3 times:\n    nod\naction bow(much):\n    blink\n    nod much\nbow 40%\nbow 20%\n"
    assert labels(text) == {
        1: "0 → 0.7 s, first of 3",
        3: "2.1 → 2.4 s, first of 2",
        4: "2.4 → 3.1 s, first of 2",
        5: "2.1 → 3.1 s",
        6: "3.1 → 4.1 s",
    }
    assert "played 3 times, at 0, 0.7, 1.4 s" in tooltip(hints(text)[1])


def test_a_line_of_speech_has_its_length_and_says_what_is_estimated() -> None:
    text = 'say "I have [smile 40%]lost[/] my cup."\nnod\n'
    first, then = labels(text).values()
    start, _, end = first.partition(" → ")
    length = end.partition("(")[2].rstrip(")")
    assert start == "0" and end.startswith("~") and length.startswith("~") and end.startswith(length[:-2])
    assert then.startswith("~")
    assert "add smile 40%" in tooltip(hints(text)[0]) and "no voice has spoken" in tooltip(hints(text)[0])


def test_the_tooltip_tells_when_an_act_lets_go() -> None:
    told = [tooltip(hint) for hint in hints("show smile for 2s\nlook left 20deg\n").values()]
    assert "lets go at 2.000 s, gone at 2.400 s" in told[0]
    assert "the eyes leave" in told[1] and "until something takes its place" in told[1]


def test_only_lines_of_the_range_have_hints_and_only_a_solved_script() -> None:
    text = "nod\nnod\nnod\n"
    assert labels(text, 1, 1) == {1: "0.7 → 1.4 s"}
    assert labels(text, 50, 60) == {} and labels(text + "show nothing-known\n") == {}
    assert labels("life still\n") == {0: "0 s"} and labels("nod\n") == {0: "0 → 0.7 s"}
