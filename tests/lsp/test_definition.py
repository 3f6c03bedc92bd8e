"""A name to where it is defined, what means the same, and what does not though it is spelled alike."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from analysing import analysis
from lsprotocol import types
from marking import marked
from pygls.uris import to_fs_path

from facescript.lsp.features.definition import definition
from facescript.lsp.features.highlight import highlights
from facescript.lsp.features.references import references

SCRIPT = """use "studio.face"
film 10s long, seed number
let number = 3
face ada = woman
    life mine
target cup at 10cm -12cm 20cm
target crowd of (-60cm 0cm 2m) cup
life mine = calm, blink 8/min
expression wry(lift = 40%) = smile.left 60% + brow.outer.right lift
action greet(who, warmth = 60%):
    look at who, speed warmth as looked
    at looked.end: show wry(lift = warmth)
    say "Good [wry 50%]evening[/], *dear* [look at who]friend."
scene opening:
    ada: greet cup, warmth 80%
    ada: say "I have lost my *cup*, my" as hello
        "good cup."
        on "lost": think
    at hello."cup".2: view ada 120%
    repeat one in crowd:
        glance one
        drop warm
when person arrives as guest:
    look at guest, latency beat
event cup arrives at beat
"""

STUDIO = """let beat = 400ms
expression warm = smile 60%
action think:
    look away
    wait beat
"""


analysed = cache(analysis)


def found(text: str, **others: str) -> str | None:
    """Where the definition of what `^` stands before is: file, line and the text there."""
    written, place = marked(text)
    spot = definition(analysed(written, **others), place)
    if spot is None:
        return None
    path = Path(to_fs_path(spot.uri) or "")
    content = {"main": written, **others}.get(path.stem) or path.read_text("utf-8")
    line = content.splitlines()[spot.range.start.line]
    return f"{path.stem}:{spot.range.start.line + 1} {line[spot.range.start.character : spot.range.end.character]}"


@pytest.mark.parametrize(
    ("before", "name", "expected"),
    [
        ("seed ", "number", "main:3 number"),
        ("life ", "mine\ntarget", "main:8 mine"),
        ("20cm\ntarget crowd of (-60cm 0cm 2m) ", "cup", "main:6 cup"),
        ("brow.outer.right ", "lift", "main:9 lift"),
        ("look at ", "who, speed", "main:10 who"),
        ("speed ", "warmth", "main:10 warmth"),
        ("at ", "looked.end", "main:11 looked"),
        ("show ", "wry(", "main:9 wry"),
        ("show wry(", "lift = warmth", "main:9 lift"),
        ("show wry(lift = ", "warmth)", "main:10 warmth"),
        ("Good [", "wry 50%", "main:9 wry"),
        ("[look at ", "who]", "main:10 who"),
        ("ada: ", "greet cup", "main:10 greet"),
        ("ada: greet cup, ", "warmth 80%", "main:10 warmth"),
        ("at ", 'hello."cup"', "main:16 hello"),
        ('at hello."', 'cup".2', "main:17 cup"),
        ('on "', 'lost"', "main:16 lost"),
        ("view ", "ada", "main:4 ada"),
        ("repeat one in ", "crowd", "main:7 crowd"),
        ("glance ", "one", "main:20 one"),
        ("look at ", "guest", "main:23 guest"),
        ("event ", "cup", "main:6 cup"),
        ("arrives at ", "beat", "studio:1 beat"),
        ("drop ", "warm", "studio:2 warm"),
        ('on "lost": ', "think", "studio:3 think"),
        ('use "', 'studio.face"', "studio:1 "),
        ("face ada = ", "woman", "woman:3 woman"),
        ("mine = ", "calm", "lives:5 calm"),
        ("= ", "smile.left", "expressions:6 smile"),
    ],
)
def test_a_name_leads_to_its_definition(before: str, name: str, expected: str) -> None:
    text = SCRIPT.replace(before + name, f"{before}^{name}", 1)
    assert found(text, studio=STUDIO) == expected


@pytest.mark.parametrize("name", ["^film", "(lift = ^40%", "^look at who", "seed 7, ^nothing", "brow^.outer"])
def test_what_is_no_name_leads_nowhere(name: str) -> None:
    assert found(SCRIPT.replace(name.replace("^", ""), name, 1), studio=STUDIO) is None


def spots(text: str, **others: str) -> list[str]:
    """The places that mean the same as what `^` stands before."""
    written, place = marked(text)
    at = analysis(written, **others)
    return [
        f"{Path(to_fs_path(one.uri) or '').stem}:{one.range.start.line + 1}:{one.range.start.character + 1}"
        for one in references(at, place, True)
    ]


def test_references_go_over_the_files_that_use_and_are_used() -> None:
    other = 'use "studio.face"\nwait beat\nlet halved = beat / 2\n'
    alone = "let beat = 1s\nwait beat\n"
    told = spots('use "studio.face"\nwait ^beat\n', studio=STUDIO, other=other, alone=alone)
    assert sorted(told) == ["main:2:6", "other:2:6", "other:3:14", "studio:1:5", "studio:5:10"]


def test_scripts_in_a_long_chain_and_in_a_circle_are_followed() -> None:
    chain = {f"part{number}": f'use "part{number + 1}.face"\n' for number in range(300)}
    assert found('use "part0.face"\nwait ^last\n', **chain, part300="let last = 1s\n") == "part300:1 last"
    assert found('use "a.face"\nwait ^far\n', a='use "main.face"\nuse "a.face"\nlet far = 1s\n') == "a:3 far"


def test_a_parameter_is_not_the_definition_that_it_covers() -> None:
    text = "target cup at 0cm 0cm 1m\naction see(cup):\n    look at cup\nsee cup\nlook at cup\n"
    assert spots(text.replace("look at cup", "look at ^cup", 1)) == ["main:2:12", "main:3:13"]
    assert spots(text.replace("target cup", "target ^cup", 1)) == ["main:1:8", "main:4:5", "main:5:9"]


def test_labels_of_passes_and_scenes_are_their_own() -> None:
    text = (
        "scene a:\n    nod as done\n    repeat 2 times:\n        at ^done.start: blink\n        nod as done\n"
        "    at done.end: blink\nscene b:\n    shake as done\n    at done.end: nod\n"
    )
    assert spots(text) == ["main:4:12", "main:5:16"]
    assert spots(text.replace("^", "").replace("b:\n    shake as ", "b:\n    shake as ^")) == ["main:8:14", "main:9:8"]


def test_a_parameters_references_are_its_calls_in_other_files_too() -> None:
    other = 'use "main.face"\ngreet camera, warmth 20%\n'
    told = spots("action greet(who, ^warmth = 50%):\n    show smile warmth\n", other=other)
    assert told == ["main:1:19", "main:2:16", "other:2:15"]


def test_a_label_called_like_an_expression_is_not_that_expression() -> None:
    text = 'say "Hello." as smile\nshow ^smile\nat smile.end: nod\n'
    assert "main:2:6" in spots(text) and "main:1:17" not in spots(text)


def test_highlights_tell_definition_and_uses_in_the_document_alone() -> None:
    written, place = marked('use "studio.face"\nlet pause = ^beat\nwait beat\n')
    told = highlights(analysis(written, studio=STUDIO), place)
    assert [(one.range.start.line, one.kind) for one in told] == [
        (1, types.DocumentHighlightKind.Read),
        (2, types.DocumentHighlightKind.Read),
    ]


BROKEN = ["", "let", "action greet(", "at hello.", 'say "[look at', "show smile +\n  x", "\ud83d", "repeat x in\n"]


@pytest.mark.parametrize("text", BROKEN)
def test_nonsense_is_answered(text: str) -> None:
    at = analysis(text + "\nlook at nowhere\n")
    for place in (types.Position(0, 0), types.Position(1, 500), types.Position(10**6, 10**6), types.Position(0, 7)):
        assert isinstance(references(at, place, True), list) and isinstance(highlights(at, place), list)
        definition(at, place)
