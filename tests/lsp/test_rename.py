"""Names that are renamed everywhere, so that all compiles as before; and those that are refused, with the clash."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from analysing import analysis
from lsprotocol import types
from marking import marked
from pygls.workspace import Workspace

from facescript.diagnostics.model import Diagnostics
from facescript.ir.json_form import dump
from facescript.ir.play import Play
from facescript.lsp.desk import Desk, OpenWorld
from facescript.lsp.features.definition import definition
from facescript.lsp.features.rename import edits
from facescript.lsp.names.renaming import RenameRefused
from facescript.lsp.names.script import names_of
from facescript.lsp.names.symbols import ProjectNames
from facescript.resolve.resolver import resolve
from facescript.syntax.parser import parse
from facescript.text import Source, Span

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


LETTERS = "αβγδεζηθικλμνξοπρστυφχψω"
"""New names are old ones with another last letter, so that places stay."""


def played(world: OpenWorld, name: str) -> Play | None:
    found = Diagnostics()
    return resolve(parse(world.source(name), found), world, found)


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.face")))
def test_an_example_with_all_its_names_renamed_plays_the_same(name: str) -> None:
    world = OpenWorld(EXAMPLES)
    names = ProjectNames(world)
    script = names.script(name)
    assert script is not None
    symbols = {found.key: found for one in script.all() if one.defines and (found := names.symbol(one, name))}
    places: dict[str, list[tuple[Span, str]]] = {}
    back = {}
    for letter, symbol in zip(LETTERS, symbols.values(), strict=False):
        new = symbol.name[:-1] + letter
        back[new] = symbol.name
        for mention in names.mentions(symbol):
            places.setdefault(mention.span.source.name, []).append((mention.span, new))
    texts = {world.path(file): rewritten(found) for file, found in places.items()}
    before, after = played(world, name), played(replace(world, texts=texts), name)
    assert before is not None and after is not None
    words = re.compile("|".join([*sorted(map(re.escape, back), key=len, reverse=True), "$^"]))
    assert words.sub(lambda match: back[match[0]], dump(after)) == dump(before)


def rewritten(places: list[tuple[Span, str]]) -> str:
    """A file's text with other names at these places."""
    text = places[0][0].source.text
    for span, new in sorted(places, key=lambda place: place[0].start, reverse=True):
        text = text[: span.start] + new + text[span.end :]
    return text


@pytest.mark.parametrize("part", range(20))
def test_a_script_that_breaks_off_anywhere_has_the_names_of_what_is_there(part: int) -> None:
    text = (EXAMPLES / "evening.face").read_text("utf-8")
    cut = text[: len(text) * part // 20]
    found = names_of(parse(Source("cut.face", cut), Diagnostics())).all()
    assert all(mention.span.end <= len(cut) for mention in found)


def test_names_in_tables_and_files_of_text_are_renamed_too(tmp_path: Path) -> None:
    (tmp_path / "main.face").write_text(
        'target cup at 0cm 0cm 1m\nrepeat one in "rows.csv":\n    look at one.where\n    say one.words\n'
        'say text "story.txt"\n',
        "utf-8",
    )
    (tmp_path / "rows.csv").write_text('where,words,note\ncup,"cup, [look at cup]yes",cup\n  cup ,a,b\n', "utf-8")
    (tmp_path / "story.txt").write_text("A cup. [glance cup]There.", "utf-8")
    at = Desk(Workspace(tmp_path.as_uri())).analysis((tmp_path / "main.face").as_uri())
    spot = definition(at, types.Position(2, 18))
    assert spot is not None and spot.uri.endswith("rows.csv") and spot.range.end == types.Position(0, 5)
    told = {Path(uri).name: items for uri, items in edits(at, types.Position(0, 7), "mug").items()}
    rows = changed((tmp_path / "rows.csv").read_text("utf-8"), told["rows.csv"]).splitlines()
    assert rows[1:] == ['mug,"cup, [look at mug]yes",cup', "  mug ,a,b"]
    assert changed("A cup. [glance cup]There.", told["story.txt"]) == "A cup. [glance mug]There."
