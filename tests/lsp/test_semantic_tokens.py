"""What the words of a document are to an editor."""

from __future__ import annotations

from itertools import pairwise

import pytest
from analysing import analysis
from lsprotocol import types

from facescript.lsp.features.semantic_tokens import change, semantic_tokens
from facescript.lsp.offered import TOKEN_MODIFIERS, TOKEN_TYPES

SCRIPT = """\
face ada = woman  # brown
target lamp at 25deg 10deg 2m
let beat = 400ms
expression wry(much = 40%) = smile.left much / 2
action greet(who, warmth = 60%):
    look at who
scene opening "T" with ada:
    ada: say "A [wry 50%]b[/] | \\\\[c" as hello
        on "b".1: nod
    at hello.end + beat: ada: greet lamp, warmth 20%
    repeat trial in "trials.csv":
        ada: show brow.inner.left trial.degree
    background #dfe8f2
"""


def words(text: str, within: types.Range | None = None, **others: str) -> list[tuple[str, str]]:
    """Each token's text and type, `!` behind a definition, `*` behind what is the library's."""
    numbers = semantic_tokens(analysis(text, **others), within)
    lines = [line.encode("utf-16-le") for line in text.split("\n")]
    found = []
    line = column = 0
    for index in range(0, len(numbers), 5):
        down, right, length, kind, bits = numbers[index : index + 5]
        line, column = line + down, right if down else column + right
        said = lines[line][2 * column : 2 * (column + length)].decode("utf-16-le")
        signs = "".join(sign for number, sign in ((0, "!"), (2, "*")) if bits >> number & 1)
        assert bits < 1 << len(TOKEN_MODIFIERS)
        found.append((said, TOKEN_TYPES[kind].value + signs))
    return found


def test_words_are_what_they_mean() -> None:
    found = words(SCRIPT)
    for expected in [
        [("face", "keyword"), ("ada", "class!"), ("woman", "type*"), ("# brown", "comment")],
        [("target", "keyword"), ("lamp", "variable!"), ("at", "keyword"), ("25deg", "number")],
        [("let", "keyword"), ("beat", "variable!"), ("400ms", "number")],
        [("wry", "enumMember!"), ("much", "parameter!"), ("40%", "number"), ("smile", "enumMember*")],
        [("left", "property"), ("much", "parameter"), ("/", "operator"), ("2", "number")],
        [("look", "keyword"), ("at", "keyword"), ("who", "parameter")],
        [("opening", "namespace!"), ('"T"', "string"), ("with", "keyword"), ("ada", "class")],
        [('"A ', "string"), ("[", "operator"), ("wry", "enumMember"), ("50%", "number"), ("]", "operator")],
        [("b", "string"), ("[/]", "operator"), (" ", "string"), ("|", "operator")],
        [("as", "keyword"), ("hello", "event!"), ("on", "keyword"), ('"b"', "string"), ("1", "number")],
        [("hello", "event"), ("end", "property"), ("+", "operator"), ("beat", "variable")],
        [("greet", "function"), ("lamp", "variable"), ("warmth", "parameter"), ("20%", "number")],
        [("trial", "parameter!"), ("in", "keyword"), ('"trials.csv"', "string")],
        [("brow.inner.left", "property"), ("trial", "parameter"), ("degree", "property")],
        [("background", "keyword"), ("#dfe8f2", "number")],
    ]:
        assert any(found[at : at + len(expected)] == expected for at in range(len(found))), expected


def test_names_of_other_files_that_are_open_count() -> None:
    assert ("sly", "enumMember") in words('use "studio.face"\nshow sly\n', studio="expression sly = smile 20%\n")


def test_lines_that_cannot_be_read_have_their_words() -> None:
    found = words('face ada = woman\nada: look at lamp "\nada: say nothing [ "x" # why\nada: nod\n')
    assert found[3:6] == [("ada", "class"), ("look", "keyword"), ("at", "keyword")]
    assert ("# why", "comment") in found and found[-1] == ("nod", "keyword")


def test_places_count_as_editors_count_them() -> None:
    assert words('say "\U0001f600 [smile 20%]né" as a  # \U0001f600 b\n')[1:4] == [
        ('"\U0001f600 ', "string"),
        ("[", "operator"),
        ("smile", "enumMember*"),
    ]


def test_a_change_makes_the_old_numbers_the_new_ones() -> None:
    texts = ["nod\nblink\n", "nod\nnod 20%\nblink\n", "nod\n", "", "blink\nnod\n", "blink\nnod\n"]
    states = [semantic_tokens(analysis(text)) for text in texts]
    for before, after in pairwise(states):
        made = list(before)
        for edit in change(before, after):
            made[edit.start : edit.start + edit.delete_count] = edit.data or ()
        assert made == after
    assert change(states[-1], states[-1]) == []


def test_a_range_has_the_tokens_that_begin_in_it() -> None:
    within = types.Range(types.Position(2, 0), types.Position(2, 99))
    assert words(SCRIPT, within) == [("let", "keyword"), ("beat", "variable!"), ("400ms", "number")]


@pytest.mark.parametrize(
    "text", ["", "\n", "#", "\t", '"', "say", "in turn", "at", "[" * 40, "a\u2028b # \u00e9", "😀"]
)
def test_nonsense_has_no_token_that_is_wrong(text: str) -> None:
    words(text)
