"""What may be written at a place of a script; what is accepted compiles."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from analysing import analysis
from lsprotocol import types

from facescript.diagnostics.model import Severity
from facescript.lsp.desk import Analysis
from facescript.lsp.features.completion import completions, documentation
from facescript.lsp.places import position
from facescript.text import Source

SCRIPT = """\
use "studio.face"
film 640x480, 25fps
let beat = 400ms
target cup at 10cm -12cm 20cm
target crowd of (-60cm 0cm 2m) (0cm 5cm 2m)
face ada = woman, voice en-us
face bruno = man
face voice-over = unseen
expression wry(lift = 40%) = smile.left 60% + AU7 lift
action greet(who, warmth = 60%):
    look at who
    show smile warmth
scene one:
    ada: say "I have lost my cup." as hello
    ada: show wry as shown
"""


STUDIO = "let long = 2s\naction bow:\n    nod\n"


def items(text: str, **others: str) -> dict[str, types.CompletionItem]:
    """What is offered at the `|` of a text, by name."""
    start = text.index("|")
    source = Source("a.face", text[:start] + text[start + 1 :])
    found = completions(analysis(source.text, **others), source, position(source, start))
    return {item.label: item for item in found}


@cache
def scene() -> Analysis:
    return analysis(SCRIPT, studio=STUDIO)


def in_scene(line: str) -> dict[str, types.CompletionItem]:
    """The same in a last line of the scene, which was not there yet when the script was analysed."""
    text = SCRIPT + f"    {line}"
    source = Source("a.face", text.replace("|", ""))
    found = completions(scene(), source, position(source, text.index("|")))
    return {item.label: item for item in found}


@pytest.mark.parametrize(
    ("line", "there", "not_there"),
    [
        ("|", "ada: bruno: wait together: repeat", "look film greet on"),
        ("ada: |", "look show say play greet bow take-turn at", "film ada:"),
        ("ada: look |", "at left away", "camera"),
        ("ada: look at |", "camera cup crowd.nearest crowd.2 bruno bruno.mouth", "ada voice-over crowd crowd.3 smile"),
        ("ada: look left |", "up for over", "right left at"),
        ("ada: look at cup |", "for over as", "eyes back"),
        ("ada: look at cup, |", "eyes then head|head only|speed|latency", "for back in"),
        ("ada: look at cup, eyes |", "then head|only", "speed"),
        ("ada: look at cup, head only, |", "speed|latency", "eyes only"),
        ("ada: scan |", "crowd", "cup camera"),
        ("ada: show |", "smile AU12 wry neutral brow.inner lid head.roll", "cup smile.left brow.inner.left nod"),
        ("ada: show smile.|", "smile.left smile.right", "wry.left"),
        ("ada: show smile 40% + |", "AU6 happiness", "for"),
        ("ada: show smile 40% |", "over for ease as", "posed AU6"),
        ("ada: show smile 40%, |", "posed spontaneous", "over"),
        ("ada: show smile for |", "beat long", "smile"),
        ("ada: show smile for 3|", "3s 3ms", "3% 3deg"),
        ("ada: show smile 3|", "3%", "3s"),
        ("ada: show smile ease |", "linear in-out", "smile"),
        ("ada: show wry(|", "lift =|", "smile"),
        ("ada: drop |", "shown wry", "hello AU12"),
        ("ada: tilt |", "left right", "up"),
        ('ada: play "take.csv" |', "for as", "over speed"),
        ('ada: play "take.csv", |', "speed", "for rate"),
        ("ada: greet |", "cup camera bruno left", "smile ada"),
        ("ada: greet cup, |", "warmth", "for"),
        ("wait |", "until beat", "hello.end"),
        ("wait until |", "hello.start hello.end", "smile"),
        ("wait until hello.|", 'hello.end hello."lost"', "smile"),
        ('wait until hello."c|', 'hello."cup" hello."lost"', "beat"),
        ("wait 1s |", "to as", "for"),
        ("ada: show smile for 1s |", "over|back in|ease|to", "for"),
        ("view |", "all ada bruno", "cup"),
        ("ada: life |", "calm reading", "blink"),
        ("ada: life calm, |", "blink|sway", "over"),
        ('ada: say "a" as x|', "", "nod"),
        ('ada: say "Well [|', "smile look nod", "film"),
        ('ada: say "Well [look at |', "cup", "smile"),
        ("ada: nod  # look at |", "", "cup camera"),
        ("together:\n        ada: look at |", "cup", "smile"),
        ("repeat one in crowd:\n        ada: look at |", "one cup", "smile"),
        ("repeat one in |", "crowd", "cup"),
        ("repeat 3 |", "times", "in"),
    ],
)
def test_in_a_scene(line: str, there: str, not_there: str) -> None:
    found = in_scene(line)
    assert [name for name in there.split("|" if "|" in there else None) if name and name not in found] == []
    assert [name for name in not_there.split() if name in found] == []


@pytest.mark.parametrize(
    ("text", "there", "not_there"),
    [
        ("|", "film face scene let look take-turn", "on"),
        ("face ada = |", "woman dog unseen", "smile"),
        ("face ada = woman, |", "voice life hair at", "over"),
        ("face ada = woman\n    |", "voice life hair", "look nod"),
        ("face ada = woman\n    hair |", "bob auburn", "swept"),
        ("face ada = man\n    life calm, |", "blink", "life"),
        ("face ada = man\n    gaze |", "eye-mover", "smile"),
        ("life mine = |", "calm blink", "smile"),
        ("life mine = calm, blink 8|", "8/min", "8%"),
        ("film 640x480, |", "seed screen title", "size"),
        ("film screen |", "patent measured", "smile"),
        ("film 3|", "3fps 3s", ""),
        ("expression e = |", "smile AU1", "camera"),
        ("expression e(much) = smile |", "much", "AU1"),
        ("target lamp |", "at moves of from", "smile"),
        ('use "|', "studio.face", "a.face"),
        ("when |", "heard person", "smile"),
        ("when person |", "arrives", "smile"),
        ("action a(b):\n    look at |", "b camera", "smile"),
        ("face a = man\nface b = man\nscene s with |", "a b", "smile"),
        ('say "Two words."\n    |', 'on "Two":|on "words":', "look"),
        ('say "Two words."\n    on "|', "Two words", "look"),
        ('face a = man\nface b = man\na: say "Two words."\n    |', 'on "Two":|', "look"),
        ("when person arrives |", "as", "look"),
        ("show smile +\n    |", "AU12", "look"),
    ],
)
def test_outside_of_scenes(text: str, there: str, not_there: str) -> None:
    found = items(text, studio=STUDIO)
    assert [name for name in there.split("|" if "|" in there else None) if name and name not in found] == []
    assert [name for name in not_there.split() if name in found] == []


@pytest.mark.parametrize("line", ["look at |", "glance |", "show |", "show smile + |", "drop |", "life |", "greet |"])
def test_what_is_accepted_compiles(line: str) -> None:
    """Each offer in a line of its own."""
    found = in_scene(f"ada: {line}")
    lines = "".join(f"    ada: {line.replace('|', edited(item))}\n" for item in found.values())
    compiled = analysis(SCRIPT + lines, studio=STUDIO).compiled
    assert len(found) > 1
    assert [item.message for item in compiled.diagnostics if item.severity is Severity.ERROR] == []


@pytest.mark.parametrize(
    "line",
    [
        "wait until |",
        "at |: nod",
        "view |",
        "glance |, eyes only",
        "scan |, 600ms each",
        "show smile over 1s ease |",
        "tilt |",
        "look left |",
        "show smile 40% for 3|",
        "wait 3|",
        "drop |",
        "show smile for |",
    ],
)
def test_what_is_accepted_inside_of_a_line_compiles(line: str) -> None:
    head = "film 640x480, 30s long\nlet beat = 400ms\ntarget all-of-them of (1cm 2cm 1m) (3cm 2cm 1m)\n"
    head += 'show smile 40%\nsay "Two words." as hello\n'
    found = items(f"{head}{line}")
    values = {name: item for name, item in found.items() if name not in ("over", "for", "back in", "as", "up", "down")}
    lines = "".join(line.replace("3|" if "3|" in line else "|", edited(item)) + "\n" for item in values.values())
    faults = [item.message for item in analysis(head + lines).compiled.diagnostics if item.severity is Severity.ERROR]
    assert values or line == "look left |"
    assert faults == []


def edited(item: types.CompletionItem) -> str:
    assert isinstance(item.text_edit, types.TextEdit)
    return item.text_edit.new_text


def test_files_of_the_project_are_offered(tmp_path: Path) -> None:
    from pygls.workspace import Workspace

    from facescript.lsp.desk import Desk

    (tmp_path / "parts").mkdir()
    (tmp_path / "trials.csv").write_text("who,soa\ncup,200ms\n", "utf-8")
    for name in ("parts/studio.face", "story.txt", ".hidden.face", "track.csv"):
        (tmp_path / name).write_text("", "utf-8")
    text = 'use "p'
    workspace = Workspace(tmp_path.as_uri())
    workspace.put_text_document(types.TextDocumentItem((tmp_path / "a.face").as_uri(), "face", 1, text))
    found = Desk(workspace).analysis((tmp_path / "a.face").as_uri())
    (item,) = completions(found, found.source, types.Position(0, len(text)))
    takes = completions(found, Source("a.face", 'play "'), types.Position(0, 6))
    assert [each.label for each in takes] == ["track.csv", "trials.csv"]
    lines = Source("a.face", 'repeat trial in "trials.csv":\n    look at ')
    columns = [each.label for each in completions(found, lines, types.Position(1, 12))]
    assert "trial.who" in columns and "trial" not in columns
    assert item.label == "parts/studio.face" and item.kind == types.CompletionItemKind.File
    assert isinstance(item.text_edit, types.TextEdit) and item.text_edit.range.start.character == 5


@pytest.mark.parametrize(("line", "column"), [(0, 5), (0, 15), (1, 9), (7, 2), (99, 99)])
def test_places_outside_of_the_text_are_answered(line: int, column: int) -> None:
    found = analysis("show smile  # \U0001f600\nada: \x00 [[ ))\n")
    completions(found, found.source, types.Position(line, column))


def test_a_unit_of_facs_is_told_with_its_meaning() -> None:
    found = analysis("show ")
    item = next(each for each in completions(found, found.source, types.Position(0, 5)) if each.label == "AU12")
    assert item.detail == "lip corner puller: cheek.lower 100%"
    text = documentation(found, found.source, types.Position(0, 5), "smile")
    assert text and "cheek.lower 100%" in text
