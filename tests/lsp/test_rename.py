"""Names that are renamed everywhere, so that all compiles as before; and those that are refused, with the clash."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from analysing import analysis
from lsprotocol import types
from marking import marked
from pygls.exceptions import JsonRpcException
from pygls.uris import to_fs_path
from pygls.workspace import Workspace
from pytest_lsp import LanguageClient

from facescript.compile import compile_source
from facescript.ir.json_form import dump
from facescript.lsp.desk import Analysis, Desk
from facescript.lsp.features.rename import edits
from facescript.lsp.names.renaming import RenameRefused
from facescript.lsp.names.script import names_of
from facescript.lsp.names.symbols import ProjectNames, Symbol
from facescript.lsp.places import range_of
from facescript.speech.voices.known import KnownTimes
from facescript.text import Source

EXAMPLES = Path(__file__).parents[2] / "examples"


def changed(text: str, told: list[types.TextEdit]) -> str:
    """A text after edits, told in any order."""
    lines = text.split("\n")
    for edit in sorted(told, key=lambda one: (one.range.start.line, one.range.start.character), reverse=True):
        line = lines[edit.range.start.line].encode("utf-16-le")
        start, end = 2 * edit.range.start.character, 2 * edit.range.end.character
        lines[edit.range.start.line] = (line[:start] + edit.new_text.encode("utf-16-le") + line[end:]).decode(
            "utf-16-le"
        )
    return "\n".join(lines)


def renamed(text: str, new: str, **others: str) -> dict[str, str]:
    """The files after a rename of what `^` stands before, those that change."""
    written, place = marked(text)
    files = {"main": written, **others}
    told = edits(analysis(written, **others), place, new)
    return {name: changed(files[name], items) for uri, items in told.items() if (name := Path(uri).stem)}


def test_a_name_is_renamed_in_all_files_that_mean_it() -> None:
    studio = "let beat = 400ms\naction think:\n    wait beat\n"
    other = 'use "studio.face"\nsay "I [wait beat]think." as beaten\nthink\n'
    alone = "let beat = 1s\nwait beat\n"
    told = renamed('use "studio.face"\nwait ^beat * 2\n', "pulse", studio=studio, other=other, alone=alone)
    assert told == {
        "main": 'use "studio.face"\nwait pulse * 2\n',
        "studio": studio.replace("beat", "pulse"),
        "other": other.replace("wait beat]", "wait pulse]"),
    }


def test_a_parameter_is_renamed_with_its_calls_and_not_what_it_covers() -> None:
    text = "target cup at 0cm 0cm 1m\naction see(^cup, long = 1s):\n    look at cup for long\nsee cup, long 2s\n"
    told = renamed(text, "thing")["main"]
    assert told.endswith("action see(thing, long = 1s):\n    look at thing for long\nsee cup, long 2s\n")
    assert "long" not in renamed(text.replace("^", "").replace("cup, long =", "cup, ^long ="), "span")["main"]


def test_names_beyond_ascii_are_renamed_at_their_places() -> None:
    text = '# \U0001f600\ntarget ^山 at 0cm 0cm 1m\nsay "\U0001f600 hm [look at 山]ah[/] [glance 山]oh"\n'
    assert renamed(text, "山頂")["main"] == text.replace("^", "").replace("山", "山頂")


@pytest.mark.parametrize(
    ("text", "new", "reason"),
    [
        ("show ^smile\n", "grin", "the library's"),
        ("^show smile\n", "grin", "no name that the script defines"),
        ("expression ^nodding = head.pitch -2deg\nnod\n", "bow", "covers the library's expression"),
        ("let ^beat = 1s\nwait beat\n", "wait", "a word of the language"),
        ("let ^beat = 1s\nwait beat\n", "two words", "is no name"),
        ("let ^beat = 1s\nwait beat\n", "3s", "is no name"),
        ("let ^beat = 1s\nwait beat\n", "", "is no name"),
        ("let ^beat = 1s\nwait beat\n", "\n", "is no name"),
        ("let ^beat = 1s\nwait beat\n", "x" * 9999, "is no name"),
        ("let ^beat = 1s\nwait beat\n", "smile", "a name of the library"),
        ("let ^beat = 1s\nwait beat\ntarget cup at 0cm 0cm 1m\n", "cup", "a target already, in main.face line 3"),
        ("nod as ^done\nat done.end: blink\nlet beat = 1s\nwait beat\n", "beat", "a let already, in main.face line 3"),
        ("nod as ^done\nat done.end: blink\nshake as gone\n", "gone", "main.face line"),
        ("let ^beat = 1s\naction pause(long):\n    wait beat\npause 2s\n", "long", "main.face line 3"),
        ("action pause(^long):\n    wait beat\n    wait long\nlet beat = 1s\npause 2s\n", "beat", "main.face line 2"),
        ("scene ^a:\n    nod\nscene b:\n    nod\n", "b", "main.face line"),
        ("face ^ada = woman\nada: nod\n", "ada-", "is no name"),
        ('use "a.face"\nlet ^beat = lamp\nwait beat\n', "lamp", "a let already, in a.face line 1"),
    ],
)
def test_a_rename_that_would_change_what_is_meant_is_refused(text: str, new: str, reason: str) -> None:
    with pytest.raises(RenameRefused, match=re.escape(reason)):
        renamed(text, new, a="let lamp = 1s\nwait lamp\n")


def test_a_definition_that_another_script_has_too_is_refused_there() -> None:
    user = 'use "main.face"\nlet pulse = 2s\nwait beat + pulse\n'
    with pytest.raises(RenameRefused, match=r"a let already, in user\.face line 2"):
        renamed("let ^beat = 1s\n", "pulse", user=user)


@pytest.fixture(scope="module")
def desk() -> Desk:
    return Desk(Workspace(EXAMPLES.as_uri()))


def own_symbols(at: Analysis) -> list[Symbol]:
    """What the document itself defines, each once."""
    names = ProjectNames(at.world, at.compiled.script)
    found = (names.symbol(one, at.source.name) for one in names_of(at.compiled.script).all() if one.defines)
    return list({symbol.key: symbol for symbol in found if symbol is not None and symbol.kind != "viseme"}.values())


SOME = ("conversation", "cueing", "evening", "kiosk", "mandarin", "track", "words")
LETTERS = "αβγδεζηθικλμνξοπρστυφχψω"


@pytest.mark.parametrize("name", SOME)
def test_an_example_with_all_its_names_renamed_plays_the_same(name: str, desk: Desk) -> None:
    """Each new name is as long as the old one, so that places stay."""
    at = desk.analysis((EXAMPLES / f"{name}.face").as_uri())
    told: dict[str, list[types.TextEdit]] = {}
    back: dict[str, str] = {}
    for letter, symbol in zip(LETTERS, own_symbols(at), strict=False):
        new = symbol.name[:-1] + letter
        back[new] = symbol.name
        for uri, found in edits(at, range_of(symbol.span).start, new).items():
            told.setdefault(uri, []).extend(found)
    texts = {
        Path(to_fs_path(uri) or ""): changed(Path(to_fs_path(uri) or "").read_text("utf-8"), items)
        for uri, items in told.items()
    }
    world = replace(at.world, texts=texts)
    again = compile_source(Source(at.source.name, texts[EXAMPLES / f"{name}.face"]), world, KnownTimes(world))
    assert at.compiled.play is not None and again.play is not None
    assert len(again.diagnostics.items) == len(at.compiled.diagnostics.items)
    words = re.compile("|".join(sorted(map(re.escape, back), key=len, reverse=True)))
    assert words.sub(lambda match: back[match[0]], dump(again.play)) == dump(at.compiled.play)


def test_names_in_tables_and_files_of_text_are_renamed_too(tmp_path: Path) -> None:
    (tmp_path / "main.face").write_text(
        'target cup at 0cm 0cm 1m\nrepeat one in "rows.csv":\n    look at one.where\n    say one.words\n'
        'say text "story.txt"\n',
        "utf-8",
    )
    (tmp_path / "rows.csv").write_text('where,words,note\ncup,"cup, [look at cup]yes",cup\n "cup",a,b\n', "utf-8")
    (tmp_path / "story.txt").write_text("A cup. [glance cup]There.", "utf-8")
    at = Desk(Workspace(tmp_path.as_uri())).analysis((tmp_path / "main.face").as_uri())
    told = {Path(uri).name: items for uri, items in edits(at, types.Position(0, 7), "mug").items()}
    assert changed((tmp_path / "rows.csv").read_text("utf-8"), told["rows.csv"]).splitlines()[1] == (
        'mug,"cup, [look at mug]yes",cup'
    )
    assert changed("A cup. [glance cup]There.", told["story.txt"]) == "A cup. [glance mug]There."


async def test_an_editor_is_told_of_the_range_of_the_edits_and_of_the_clash(
    client: LanguageClient, tmp_path: Path
) -> None:
    uri = (tmp_path / "main.face").as_uri()
    text = "let beat = 1s\nlet long = 2s\nwait beat + long\n"
    client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "face", 7, text)))
    here, place = types.TextDocumentIdentifier(uri), types.Position(2, 6)
    ready = await client.text_document_prepare_rename_async(types.PrepareRenameParams(here, place))
    wanted = types.Range(types.Position(2, 5), types.Position(2, 9))
    assert ready == types.PrepareRenamePlaceholder(wanted, "beat")
    told = await client.text_document_rename_async(types.RenameParams(here, place, "pulse"))
    assert told is not None and told.document_changes is not None
    (one,) = told.document_changes
    assert isinstance(one, types.TextDocumentEdit) and one.text_document.version == 7 and len(one.edits) == 2
    with pytest.raises(JsonRpcException, match=r"a let already, in main\.face line 2"):
        await client.text_document_rename_async(types.RenameParams(here, place, "long"))
    with pytest.raises(JsonRpcException, match="no name"):
        await client.text_document_prepare_rename_async(types.PrepareRenameParams(here, types.Position(0, 0)))
