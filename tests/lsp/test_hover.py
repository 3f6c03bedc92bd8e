"""What is said of a word where an author points at it."""

from __future__ import annotations

from functools import cache

import pytest
from analysing import analysis
from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.features.hover import hover
from facescript.lsp.places import position

SCRIPT = """\
use "studio.face"
film 640x480, seed 7
let beat = 400ms  # one beat
# where the tea is
target cup at 10cm -12cm 20cm
face ada = woman, voice en-gb female
expression wry(lift = 40%) = smile.left 60% + brow.inner lift
# A greeting. With a nod.
action greet(who, warmth = 60%):
    look at who
    show smile warmth
scene one:
    show wry 40% for 1s back in 500ms, posed as shown
    look at cup, eyes only
    together:
        greet cup, warmth 80%
    say "I lost it." as hello
    at hello.end: show long-smile
    life calm, blink 8/min
"""


@cache
def script() -> Analysis:
    return analysis(SCRIPT, studio="# from far\nexpression long-smile = smile 50% + head.roll 3deg\n")


def told(before: str, word: str) -> str:
    """What is said in the middle of a word that stands behind some text."""
    start = SCRIPT.index(before) + len(before)
    assert SCRIPT.startswith(word, start)
    found = hover(script(), position(script().source, start + len(word) // 2))
    if found is None:
        return ""
    assert isinstance(found.contents, types.MarkupContent) and found.range is not None
    assert found.range.end.character - found.range.start.character == len(word)
    return found.contents.value


@pytest.mark.parametrize(
    ("before", "word", "says"),
    [
        ("    ", "look", ("look at TARGET", "Turns the gaze")),
        ("scene one:\n    ", "show", ("show SUM", "starts 0.00 s, settled 1.00 s, ends 1.50 s")),
        ("show wry 40% ", "for", ("for TIME", "how long it lasts")),
        ("1s ", "back", ("back in TIME",)),
        ("500ms, ", "posed", ("as one made on purpose",)),
        ("at cup, eyes ", "only", ("the head stays",)),
        ("posed as ", "shown", ("show wry 40%", "starts 0.00 s")),
        ("posed ", "as", ("names the statement",)),
        ("scene one:\n    show ", "wry", ("expression wry(lift", "brow.inner 40%", "cheek.lower.left 60%")),
        ("o.end: show ", "long-smile", ("from far", "cheek.lower 50%", "head.roll 3deg", "studio.face:2")),
        ("action greet(who, warmth = 60%):\n    look at ", "who", ("parameter of `greet`",)),
        ("show smile ", "warmth", ("warmth = 60%",)),
        ("        ", "greet", ("action greet(who, warmth = 60%):", "A greeting. With a nod.")),
        (
            "scene one:\n    show wry 40% for 1s back in 500ms, posed as shown\n    look at ",
            "cup",
            ("where the tea is",),
        ),
        ("seed 7\nlet ", "beat", ("one beat", "let beat = 400ms")),
        ("face ", "ada", ("a cartoon woman",)),
        ("face ada = woman, ", "voice", ("voice VOICE", "the language")),
        ("eyes only\n    ", "together", ("starts all its statements at once",)),
        ("warmth\n", "scene", ("statements that begin afresh",)),
        ('studio.face"\n', "film", ("what the outputs are like",)),
        ("film 640x480, ", "seed", ("decides every draw",)),
        ("60% + ", "brow.inner", ("raises the brow's inner end",)),
        ("    say ", '"I lost it."', ("Speaks for about ", "voice en-gb female")),
        ("    at ", "hello.end", ('say "I lost it."', "Speaks for about")),
        ("    life calm, ", "blink", ("blinks a minute",)),
        ("    life ", "calm", ("life calm = blink 14/min",)),
    ],
)
def test_what_is_said(before: str, word: str, says: tuple[str, ...]) -> None:
    text = told(before, word)
    assert [each for each in says if each not in text] == []


@pytest.mark.parametrize(
    ("column", "says"),
    [
        (8, ("expression smile = AU12", "cheek.lower 100%")),
        (35, ("look at TARGET", "starts about ")),
        (44, ("straight ahead",)),
        (53, ("the head stays",)),
        (30, ("Speaks for",)),
    ],
)
def test_a_statement_in_a_text_is_told_of(column: int, says: tuple[str, ...]) -> None:
    found = analysis('say "[smile 40%]Good morning.[/] [look at camera, eyes only]All of you."\n')
    text = str(hover(found, types.Position(0, column)))
    assert [each for each in says if each not in text] == []


def test_a_statement_of_an_action_has_the_times_of_each_call() -> None:
    found = analysis("action a:\n    nod\na\na\na\na\na\n")
    text = str(hover(found, types.Position(1, 5)))
    assert text.count("starts") == 3 and "2 times more" in text


@pytest.mark.parametrize(
    ("text", "line", "column"), [("", 0, 0), ("nod  # look at cup", 0, 9), ("wait 2s", 0, 6), ("\U0001f600", 0, 1)]
)
def test_nothing_is_said_where_there_is_nothing(text: str, line: int, column: int) -> None:
    assert hover(analysis(text), types.Position(line, column)) is None


def test_a_broken_document_still_tells_what_words_are() -> None:
    found = analysis("show (\nlook at \nshow smile\n")
    assert "cheek.lower" in str(hover(found, types.Position(2, 7))) and "starts" not in str(
        hover(found, types.Position(2, 2))
    )
