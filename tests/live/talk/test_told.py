"""What is told to a running script: resolved by its names, without files, definitions or more than it may be."""

from __future__ import annotations

from pathlib import Path

import pytest

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Reaction
from facescript.resolve.told import LONGEST, Prompter
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

SCRIPT = """\
face ada = woman
target lamp at 25deg 10deg 2m
action greet:
    nod
    say "Hello." from "hello.wav"
greet
"""


@pytest.fixture(scope="module")
def prompter(tmp_path_factory: pytest.TempPathFactory) -> Prompter:
    folder = tmp_path_factory.mktemp("told")
    for name in ("hello.wav", "secret.wav", "secret.txt", "secret.csv", "secret.png"):
        (folder / name).write_bytes(b"RIFF")
    found = Prompter(parse(Source("x.face", SCRIPT), Diagnostics()), World(Path(folder)), Diagnostics())
    assert found.play is not None
    return found


def told(prompter: Prompter, text: str) -> tuple[Reaction | None, list[str]]:
    diagnostics = Diagnostics()
    return prompter.reaction(text, diagnostics), [one.code for one in diagnostics]


@pytest.mark.parametrize("text", ["nod", "look at lamp, eyes only", 'ada: say "Hi."\n    on "Hi": nod', "greet"])
def test_statements_are_those_of_the_script(prompter: Prompter, text: str) -> None:
    reaction, codes = told(prompter, text)
    assert reaction is not None and reaction.body.items and not codes


@pytest.mark.parametrize(
    "text",
    [
        'say "x" from "secret.wav"',
        'say "x" timed "secret.txt"',
        'say text "secret.txt"',
        'say ssml "secret.txt"',
        'background "secret.png"',
        'say "x" from "../../etc/passwd"',
        'repeat row in "secret.csv":\n    nod',
        'nod\non_way: nod\nsay "x" from "/etc/passwd"',
    ],
)
def test_no_file_is_named_but_those_of_the_script(prompter: Prompter, text: str) -> None:
    reaction, codes = told(prompter, text)
    assert reaction is None and set(codes) & {"FS990", "FS203"}


@pytest.mark.parametrize("text", ["face bob = man", 'use "other.face"', 'when heard "x":\n    nod', "film 9s long"])
def test_nothing_is_defined(prompter: Prompter, text: str) -> None:
    assert told(prompter, text) == (None, ["FS991"])


def test_what_is_told_is_bounded(prompter: Prompter) -> None:
    assert told(prompter, "nod\n" * (LONGEST // 4 + 1)) == (None, ["FS992"])
    assert told(prompter, "repeat 100 times:\n    nod\n" * 150)[1] == ["FS322"]


def test_each_has_names_of_its_own(prompter: Prompter) -> None:
    first, second = (told(prompter, 'say "Hello there." as hello\nat hello."there": nod') for _ in range(2))
    assert first[1] == second[1] == []
    assert told(prompter, 'at hello."there": nod')[0] is None
