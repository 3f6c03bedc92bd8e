"""What calls an action and what it calls; and the symbols of a workspace by a few letters of their names."""

from __future__ import annotations

from pathlib import Path

from analysing import ROOT, analysis
from lsprotocol import types
from marking import marked
from pygls.workspace import Workspace

from facescript.lsp.desk import Desk
from facescript.lsp.features.calls import incoming, outgoing, prepared
from facescript.lsp.features.workspace_symbols import workspace_symbols

STUDIO = """action greet(who):
    look at who
    bow
    listen who
action ^bow:
    nod
scene opening:
    bow
    say "Good [greet camera]evening."
when key "q":
    bow
"""


def test_an_action_is_called_by_actions_scenes_reactions_and_scripts() -> None:
    text, place = marked(STUDIO)
    at = analysis(text, other='use "main.face"\nbow\nwait 1s\nbow\n')
    (item,) = prepared(at, place)
    assert (item.name, item.kind) == ("bow", types.SymbolKind.Method)
    told = {(call.from_.name, len(call.from_ranges)) for call in incoming(at, item)}
    assert told == {("greet", 1), ("opening", 1), ('when key "q"', 1), ("other.face", 2)}
    assert not outgoing(at, item)


def test_an_action_calls_others_and_those_of_the_library() -> None:
    text, place = marked(STUDIO.replace("^", "").replace("greet(", "^greet(", 1))
    at = analysis(text)
    (item,) = prepared(at, place)
    assert [call.to.name for call in outgoing(at, item)] == ["bow", "listen"]
    (opening,) = (call.from_ for call in incoming(at, item))
    assert [call.to.name for call in outgoing(at, opening)] == ["bow", "greet"]
    assert not incoming(at, opening)


def test_the_lines_of_a_script_call_too() -> None:
    text, place = marked("action bow:\n    nod\n^bow\n")
    at = analysis(text)
    (item,) = prepared(at, place)
    (call,) = incoming(at, item)
    assert call.from_.name == "main.face" and call.from_.kind == types.SymbolKind.File
    assert [one.to.name for one in outgoing(at, call.from_)] == ["bow"]
    assert not prepared(at, types.Position(1, 5))


def test_symbols_of_all_scripts_are_found_by_letters_in_order(tmp_path: Path) -> None:
    (tmp_path / "shows").mkdir()
    (tmp_path / "shows" / "one.face").write_text(
        "target lamp at 0cm 0cm 1m\nscene opening:\n    nod as lamped\n", "utf-8"
    )
    (tmp_path / "broken.face").write_text(
        "let limp = \nexpression limp = smile\naction lump(lamp):\n  nod\n x", "utf-8"
    )
    (tmp_path / ".hidden").mkdir()
    (tmp_path / ".hidden" / "no.face").write_text("let lamp = 1s\n", "utf-8")
    workspace = Workspace(tmp_path.as_uri())
    open_one = types.TextDocumentItem((tmp_path / "new.face").as_uri(), "face", 1, "let LaMp = 1s\n")
    workspace.put_text_document(open_one)
    told = workspace_symbols(Desk(workspace), "lmp")
    assert sorted((one.name, one.container_name) for one in told) == [
        ("LaMp", "new.face"),
        ("lamp", "shows/one.face"),
        ("lamped", "shows/one.face"),
        ("limp", "broken.face"),
        ("lump", "broken.face"),
    ]
    assert not workspace_symbols(Desk(workspace), "opening\ud83d")
    assert len(workspace_symbols(Desk(workspace), "")) == 6


def test_a_folder_that_is_not_there_has_no_symbols() -> None:
    assert not workspace_symbols(Desk(Workspace(ROOT.as_uri())), "")
