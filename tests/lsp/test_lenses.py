"""From where a document can be played."""

from __future__ import annotations

from analysing import analysis

from facescript.lsp.features.lenses import lenses


def plays(text: str) -> list[tuple[int, object]]:
    found = []
    for lens in lenses(analysis(text)):
        assert lens.command is not None and lens.command.command == "facescript.play" and lens.command.arguments
        uri, time = lens.command.arguments
        assert isinstance(uri, str) and uri.startswith("file:///")
        found.append((lens.range.start.line, time))
    return found


def test_scenes_and_named_statements_can_be_played_from() -> None:
    repeat = "    repeat 2 times:\n        nod as n\n"
    text = f"action bow:\n    nod\nscene a:\n    nod\n    bow as bowed\n{repeat}scene b:\n    nod\n"
    assert plays(text) == [(2, 0.0), (4, 0.7), (6, 1.4), (7, 2.8)]


def test_a_script_without_scenes_can_be_played_from_its_first_statement() -> None:
    assert plays("film 5s long\nnod\nblink as b\n") == [(1, 0.0), (2, 0.7)]


def test_what_is_not_solved_cannot_be_played() -> None:
    assert plays("scene a:\n    show nothing-known\n") == [] and plays("") == []
