"""The outline of a document."""

from __future__ import annotations

from analysing import analysis
from lsprotocol import types

from facescript.lsp.features.symbols import symbols

SCRIPT = """\
face ada = woman
    hair #5b3a22
expression wry(much) = smile.left much
action greet(who, warmth = 60%):
    nod
scene opening "A title":
    ada: say "Hello." as hello
    repeat 2 times:
        nod as often
    together:
        blink
when key "q":
    stop
"""

Outline = list[tuple[str, str, "Outline"]]


def outline(found: list[types.DocumentSymbol]) -> Outline:
    return [(symbol.name, symbol.kind.name, outline(list(symbol.children or ()))) for symbol in found]


def test_what_is_named_is_nested_as_it_is_written() -> None:
    assert outline(symbols(analysis(SCRIPT))) == [
        ("ada", "Class", []),
        ("wry", "Function", []),
        ("greet", "Method", []),
        ("opening", "Module", [("hello", "Key", []), ("repeat 2 times", "Object", [("often", "Key", [])])]),
        ('when key "q"', "Event", []),
    ]


def test_every_name_is_marked_inside_of_what_it_names() -> None:
    def check(found: list[types.DocumentSymbol]) -> None:
        for symbol in found:
            assert symbol.range.start <= symbol.selection_range.start
            assert symbol.selection_range.end <= symbol.range.end
            check(list(symbol.children or ()))

    found = symbols(analysis(SCRIPT))
    check(found)
    assert found[0].range == types.Range(types.Position(0, 0), types.Position(1, 16))
    assert found[2].detail == "who, warmth = 60%"


def test_a_line_that_cannot_be_read_takes_nothing_else_away() -> None:
    assert [name for name, *_ in outline(symbols(analysis(SCRIPT + 'look at "\nlet beat = 2s\n')))][-1] == "beat"
