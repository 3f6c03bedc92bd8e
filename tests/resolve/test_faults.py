"""Diagnostics: the examples of the catalogue, many faults at a time, and nothing that breaks the resolver."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plays import codes, resolved

from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.catalogue.model import Entry
from facescript.resolve.suggest import nearest, slips

OURS = [entry for entry in CATALOGUE.values() if entry.code[2] in "2378" and entry.stage == "check"]


@pytest.mark.parametrize("entry", OURS, ids=lambda entry: f"{entry.code}-{entry.name}")
def test_examples_of_the_catalogue(entry: Entry, tmp_path: Path) -> None:
    for name, text in entry.files.items():
        (tmp_path / name).write_text(text, "utf-8")
    bad = list(resolved(entry.bad, tmp_path)[1])
    assert [item.code for item in bad] == [entry.code]
    assert bad[0].span is not None
    assert bad[0].message[-1] in ".?", bad[0].message
    assert codes(entry.good, tmp_path) == []


THIRTY = [
    ("target cup at 0cm -12cm", "FS330"),
    ("let beat = 2s + 1deg", "FS306"),
    ("expression odd = smle", "FS201"),
    ("expression spread = smile 20deg", "FS302"),
    ("action bow(x):\n    nod\n    show smyle", "FS201"),
    ("life mine = clam", "FS206"),
    ("face ada = womn", "FS329"),
    ("ada: smile 40%", "FS221"),
    ("ada: follow camera", "FS222"),
    ("ada: glanc camera", "FS204"),
    ("ada: look camera", "FS312"),
    ("ada: look at camra", "FS202"),
    ("ada: look at cup, eyes olny", "FS308"),
    ("ada: nod over 1s", "FS309"),
    ("ada: show smile over 1s over 2s", "FS310"),
    ("wait 2m", "FS302"),
    ("wait 3", "FS301"),
    ("wait 3min", "FS303"),
    ("wait -1s", "FS304"),
    ("wait puase", "FS207"),
    ("ada: bow", "FS217"),
    ("ada: show AU19", "FS219"),
    ("ada: show AU26.left", "FS220"),
    ("ada: show smile 140%", "FS305"),
    ("ada: add head.roll", "FS234"),
    ("at helo.end: ada: blink", "FS205"),
    ('ada: say "A *cup." as hello', "FS317"),
    ('ada: say "A cup."\n    on "cap": nod', "FS228"),
    ("background blue", "FS314"),
    ("ada: stop", "FS227"),
    ("bruno: nod", "FS203"),
    ('ada: say "Hi." from "take.wav"', "FS701"),
]


def test_thirty_faults_give_thirty_diagnostics() -> None:
    found = codes("\n".join(line for line, _ in THIRTY) + "\nada: bow cup\n")
    assert sorted(code for code in found if code != "FS211") == sorted(code for _, code in THIRTY)


def test_the_same_fault_in_an_action_that_is_called_often_is_told_once() -> None:
    assert codes("action bow:\n    show smyle\nbow\nbow\nbow\n") == ["FS201"]


def test_suggestions() -> None:
    assert nearest("smle", ["smile", "sadness"]) == "smile"
    assert nearest("togehter", ["together", "choose"]) == "together"
    assert nearest("Smile", ["smile"]) == "smile"
    assert nearest("xyz", ["smile", "nod"]) is None
    (item,) = resolved("show smle 40%\n")[1]
    assert item.message == "`smle` is no expression, FACS unit, muscle or channel; did you mean `smile`?"
    (edit,) = item.fixes[0].edits
    assert (edit.span.text, edit.text) == ("smle", "smile")


letters = st.text(alphabet="abc", max_size=6)


@given(letters, letters)
def test_slips_are_a_distance(first: str, second: str) -> None:
    far = slips(first, second, 99)
    assert far == slips(second, first, 99)
    assert (far == 0) == (first == second)
    assert far <= max(len(first), len(second))


WORDS = (
    "look at nod show add drop say wait until over for back in ease as smile AU4 cup crowd.2 hello.end camera left "
    '20deg 40% 2s 3 + - * / , ( ) "cup" "[nod]a" when heard repeat times together : let target = of moves to 1.5'
)
PIECES = st.sampled_from(WORDS.split(" "))


@settings(max_examples=300, deadline=None)
@given(st.lists(st.lists(PIECES, min_size=1, max_size=8), min_size=1, max_size=4))
def test_no_script_breaks_the_resolver(lines: list[list[str]]) -> None:
    text = 'target cup at 0cm -12cm 20cm\ntarget crowd of (-60cm 0cm 2m) (0cm 5cm 2m)\nsay "A cup." as hello\n'
    play, diagnostics = resolved(text + "".join(" ".join(line) + "\n" for line in lines))
    assert (play is None) == diagnostics.failed
    assert all(item.span is not None and 0 <= item.span.start <= item.span.end for item in diagnostics)
