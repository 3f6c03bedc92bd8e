"""A script that is edited: each state is told as a fresh compile tells it, and what stayed is not read again."""

from __future__ import annotations

import re
from dataclasses import fields, is_dataclass
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from textwrap import indent
from typing import Any

import pytest
from _authored import FILES, authored, put, revised
from _scripts import lines_of
from _wild import SIGNS, WORDS, wild
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from facescript.compile import Compiled, compile_source
from facescript.diagnostics.model import Diagnostics
from facescript.recompile import Recompiler
from facescript.resolve.memory import Memory
from facescript.resolve.resolver import resolve
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.faults import MOST
from facescript.syntax.parser import parse
from facescript.syntax.pieces import Pieces
from facescript.text import Source, Span
from facescript.world import World

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = [*(path.read_text("utf-8") for path in sorted(EXAMPLES.glob("*.face"))), lines_of(60)]
BLOCK = re.compile(r"^.*\n(?:[ \t].*\n|\n)*", re.MULTILINE)
"""A line and what hangs under it."""

DEFINERS = frozenset("action background event expression face film let scene target use view viseme when".split())

SEEDS = st.integers(0, 2**32)
LONGEST = 4_000
TYPED = ("", "", "\n", " ", "   ", "\t", '"', ",\n", "+\n", "\n    nod\n", "nod\n", "  \n", "#! x\n", 'say "hm",\n')
LINES = ("\t", "  ", " nod\n", "#", "#!", "nod,\n", "show smile +\n", "\n", "# x,\n", "\u00a0", "scene q:\n", "é", "(")
"""What is put in at the start of a line."""


def edited(text: str, chance: Random) -> str:
    """One edit: at the start of a line, or of a stretch of any length at any place."""
    at = chance.randrange(len(text) + 1)
    if chance.random() < 0.2:
        at = text.rfind("\n", 0, at) + 1
        return text[:at] + chance.choice(LINES) + text[at:]
    end = at + chance.choice((0, 0, 1, 1, 3, 30, 300))
    kind = chance.randrange(4)
    new = (chance.choice(TYPED), chance.choice(SIGNS), f" {chance.choice(WORDS)} ", text[at:end] * 2)[kind]
    return text[:at] + new + text[end:]


def placed(node: Any) -> Any:
    """Anything of a compiled script as nested tuples, with every place in it as file, offsets and text."""
    if isinstance(node, Span):
        return node.source.name, node.source.text, node.start, node.end
    if isinstance(node, dict):
        return {placed(name): placed(value) for name, value in node.items()}
    if isinstance(node, tuple | list):
        return tuple(placed(part) for part in node)
    if is_dataclass(node):
        return (type(node).__name__, *(placed(getattr(node, item.name)) for item in fields(node)))
    return node


def told(compiled: Compiled) -> list[Any]:
    script = compiled.script
    return [placed(part) for part in (compiled.diagnostics.items, script, compiled.play, compiled.score)]


def read(text: str, pieces: Pieces | None = None) -> tuple[Any, Any]:
    source, diagnostics = Source("edited.face", text), Diagnostics()
    script = pieces.parse(source, diagnostics) if pieces else parse(source, diagnostics)
    return placed(script), placed(diagnostics.items)


@given(SEEDS)
@settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_any_edits_are_read_as_a_fresh_parse_reads_them(seed: int) -> None:
    chance, pieces = Random(seed), Pieces()
    states = [wild(SCRIPTS, chance)[:LONGEST]]
    for _ in range(10):
        assert read(states[-1], pieces) == read(states[-1])
        states.append(chance.choice(states) if chance.random() < 0.1 else edited(states[-1], chance))


@given(SEEDS)
@settings(max_examples=6, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_any_edits_are_compiled_as_a_fresh_compile_does(seed: int) -> None:
    chance, recompiler, voice = Random(seed), Recompiler(), EstimatedVoice()
    text, world = chance.choice(SCRIPTS)[:LONGEST], World(EXAMPLES)
    for _ in range(6):
        fresh = told(compile_source(Source("edited.face", text), world, voice))
        assert told(recompiler.compile(Source("edited.face", text), world, voice)) == fresh
        text = edited(text, chance)


@given(SEEDS)
@settings(max_examples=8, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_any_edits_of_names_and_files_are_resolved_as_a_fresh_compile_does(seed: int) -> None:
    chance, memory, pieces = Random(seed), Memory(), Pieces()
    text = chance.choice((str, in_scenes))(authored(chance))
    with TemporaryDirectory() as folder:
        world = World(Path(folder))
        for name in FILES:
            put(world.root, name, chance)
        for _ in range(6):
            assert resolved(text, world, memory, pieces) == resolved(text, world)
            text = revised(text, chance)
            if chance.random() < 0.3:
                put(world.root, chance.choice(list(FILES)), chance)


def resolved(text: str, world: World, memory: Memory | None = None, pieces: Pieces | None = None) -> tuple[Any, Any]:
    source, diagnostics = Source("edited.face", text), Diagnostics()
    script = pieces.parse(source, diagnostics) if pieces else parse(source, diagnostics)
    play = resolve(script, world, diagnostics, memo=memory)
    return placed(diagnostics.items), placed(play)


def known(count: int, names: int) -> str:
    """Statements of which none is right, as many names that may have been meant."""
    return "".join(f"expression e{number} = smile\n" for number in range(names)) + "shw e1\n" * count


@pytest.mark.parametrize(
    "states",
    [
        (
            "expression wry = smile\nshow wry\n",
            "expression wry = AU12\nshow wry\n",
            "expression dry = smile\nshow wry\n",
        ),
        (
            "expression a = b\nexpression b = smile 140%\nshow a\nshow b\n",
            "expression a = b\nexpression b = smile\nshow b\n",
        ),
        (
            "expression a = b\nexpression b = a\nshow a\nshow b\n",
            "expression a = b\nexpression b = nod\nshow a\nshow b\n",
        ),
        ("let t = 2s\nwait t\n", "let t = 2cm\nwait t\n", "let t = 3s\nwait t\n", "wait t\n"),
        ("target q at 1cm 2cm 3cm\nlook at q\n", "target q of (1cm 2cm 3cm) (2cm 2cm 3cm)\nlook at q\n", "look at q\n"),
        (
            "face a = woman\nface b = man\na: nod\nb: nod\n",
            "face a = unseen\nface b = man\na: nod\nb: nod\n",
            "b: nod\n",
        ),
        (
            "nod as x\nat x.end: nod\ndrop x\n",
            "at x.end: nod\ndrop x\n",
            "let x = 3s\nnod as x\nat x.end: nod\ndrop x\n",
        ),
        ('say "a cup" as x\nat x."cup": nod\n', 'say "a mug" as x\nat x."cup": nod\n', 'nod as x\nat x."cup": nod\n'),
        ("action f(): nod as n\nf\nf\n", "action f(): nod as n\nf\nf\nf\n", "action f(): nod as n\nnod\nf\nf\n"),
        ("look at people.nearest\n", "target t at 1cm 2cm 3cm\nevent t arrives at 2s\nlook at people.nearest\n"),
        ("show wry\n", "expression wry = (\nshow wry\n", "expression wry = smile\nshow wry\n"),  # a line that is lost
        ("nod as say\nsay say\nnod say\n", "nod as y\nsay say\nnod say\n"),  # a word that is refused
        ('say "a [show] b"\nnod\n', '\nsay "a [show] b"\nnod\n', 'say "a [show smile] b"\nnod\n'),
        (known(48, 2), known(49, 2), known(50, 2), known(51, 1)),
        ("face ada = woman\nview ada 120%\n", "view somebody 120%\n", "face bob = man\nview somebody 120%\n"),
        (known(80, 1), "wat\n" * 110 + known(80, 1)),
        (
            "expression l(p) = p\nexpression q = smile\nshow q\nshow l(p = smile 140%)\n",
            "expression l(p) = p\nexpression q = l(p = q)\nshow q\nshow l(p = smile 140%)\n",
        ),
        (
            "expression a = b\nexpression b = smile\n" + "show a\n" * 3,
            "expression a = b\nexpression b = AU12\n" + "show a\n" * 3,
        ),
        ("expression wry = smile\nshow wryy\n", "expression wrx = smile\nshow wryy\n", "show wryy\n"),
        ("expression a = smile 140%\nnod\nshow a\nshow q\n", "expression a = smile 140%\nshow a\nshow q\n"),
        ("background #102030\nscene a:\n    nod\n", "background #405060\nscene a:\n    nod\n", "scene a:\n    nod\n"),
        ('when heard "a": nod as x\nwhen heard "b": nod as x\nnod\n', 'when heard "b": nod as x\nnod\n'),
        (
            "show smile\n" * 40,
            "show smile\n" * 20 + "let q = 3\nwait q\n" + "show smile\n" * 20,
            "wait q\n" + "nod\n" * 40,
        ),
        ("action f(): f\nf\nf\n", "action f(): nod\nf\nf\n", "nod\n", "action g(): f\naction f(): g\ng\nf\n"),
    ],
)
def test_what_statements_hang_on(states: tuple[str, ...], tmp_path: Path) -> None:
    world = World(tmp_path)
    for form in (str, in_scenes):
        memory, pieces = Memory(), Pieces()
        for text in map(form, (*states, *reversed(states), *states)):
            assert resolved(text, world, memory, pieces) == resolved(text, world)


def in_scenes(text: str) -> str:
    """A script with its statements in two scenes."""
    defined, stated = "", ""
    for block in BLOCK.findall(text):
        if block.partition(" ")[0] in DEFINERS:
            defined += block
        else:
            stated += indent(block, "    ")
    scenes = "".join(f"scene {name}:\n{stated}" for name in ("one", "two")) if stated.strip() else ""
    return defined + scenes


def test_a_script_that_grows_too_large_and_shrinks_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("project", "memory"):
        monkeypatch.setattr(f"facescript.resolve.{module}.MOST_WORDS", 500)
    memory, pieces, world = Memory(), Pieces(), World(tmp_path)
    head = (
        "let a = b + b\nlet b = c + c\nlet c = 1s\nexpression w(p) = p + p\nexpression v = w(p = smile) + w(p = AU4)\n"
    )
    found = []
    for count in (1, 5, *range(20, 28), *range(27, 20, -1), 2):
        text = head + "show v\n" + "wait a\n" * count
        found.append(resolved(text, world, memory, pieces))
        assert found[-1] == resolved(text, world)
    assert {play is None for _, play in found} == {True, False}


def test_a_script_that_unfolds_too_far_and_shrinks_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("facescript.resolve.resolver.EACH", -400)
    memory, pieces, world = Memory(), Pieces(), World(tmp_path)
    found = []
    for count in (18, 19, 20, 19, 20, 18):
        text = "action f():\n" + "    nod\n" * 4 + "f\n" * count
        found.append(resolved(text, world, memory, pieces))
        assert found[-1] == resolved(text, world)
    assert [play is None for _, play in found] == [False, False, True, False, True, False]


@pytest.mark.parametrize("name", FILES)
def test_files_are_read_again_once_they_changed(name: str, tmp_path: Path) -> None:
    memory, pieces, world, chance = Memory(), Pieces(), World(tmp_path), Random(1)
    text = 'use "other.face"\nshow theirs\nsay text "text.txt"\nsay ssml "x.ssml"\nrepeat r in "t.csv": nod r.degree\n'
    for _ in range(8):
        put(tmp_path, name, chance)
        assert resolved(text, world, memory, pieces) == resolved(text, world)


def test_what_hangs_on_nothing_that_changed_is_the_same_object(tmp_path: Path) -> None:
    memory, pieces, world = Memory(), Pieces(), World(tmp_path)

    def items(text: str) -> tuple[Any, ...]:
        script = pieces.parse(Source("a.face", text), Diagnostics())
        play = resolve(script, world, Diagnostics(), memo=memory)
        assert play is not None
        return play.scenes if len(play.scenes) > 1 else play.scenes[0].body.items

    before = items(text := "expression wry = smile\nnod\nshow wry\nwait 1s\n")
    after = items(text.replace("nod\n", "nod 30%\nblink\n"))
    assert after[2] is before[1] and after[3] is before[2] and after[2].span.text == "show wry"
    assert items(text.replace("= smile", "= AU12"))[2] is after[3]
    before = items(text := "action f(): nod\nscene a:\n    f\n    shake\nscene b:\n    f\n    blink\n")
    after = items(text.replace("(): nod", "(): nod 20%"))
    assert all(new.body.items[1] is old.body.items[1] for new, old in zip(after, before, strict=True))
    before = items(text := "scene a:\n    nod\nscene b:\n    shake\n")
    assert items(text.replace("nod", "nod 40%"))[1] is before[1] and before[1].span.text == "scene b:\n    shake"


@pytest.mark.parametrize(
    "states",
    [
        ("nod", "nod 3", "nod 30%\n", "nod 30%\nshake"),  # the last line is typed on
        ("nod\nshake\n", "nodshake\n", "nod,\nshake\n", "nod,\n# still\nshake\n", "nod,\n\nshake\n"),
        ("#! sh\nnod\n", "\n#! sh\nnod\n", "nod\n#! sh\nnod\n", "#! sh\nnod\n"),  # only a first line may begin so
        ("repeat 2 times:\n    nod\nin turn:\n nod\n nod\n", "repeat 2 times:\n    nod\n nod\nin turn:\n nod\n nod\n"),
        ("\tnod\nshake\n\tnod\n", "\tnod\n\tshake\n\tnod\n", "\tnod\n\n\tshake\n"),  # lines with tabs in a row
        ("nod\nrepeat 2 times:\n    nod\n nod\nshake\nrepeat 2 times:\n nod\n", "nod\nshake\nrepeat 2 times:\n nod\n"),
        ("nod\nshow smile +\n", "nod\nshow smile +\nbrows\n", "nod\nshow smile +\nscene a:\n"),
        ("", "nod\n", "# nod\n", "\n", " nod\n"),
        ("nod!\n" * MOST, "nod!\n" * (MOST + 1), "nod\n" + "nod!\n" * (MOST - 1)),  # as many faults as are told
        ("nod,\n" * 50, "nod,\n" * 51 + "nod\n", "nod\n" + "nod,\n" * 50),
    ],
)
def test_what_reaches_over_the_borders_of_pieces(states: tuple[str, ...]) -> None:
    pieces = Pieces()
    for text in (*states, *reversed(states)):
        assert read(text, pieces) == read(text)


def test_what_only_moved_is_the_same_object_at_its_new_place() -> None:
    pieces, text = Pieces(), 'nod\nscene a:\n    say "Ah."\nshake\n'
    before = pieces.parse(Source("a.face", text), Diagnostics()).items
    text = text.replace("nod\n", "nod 30%\nblink\n")
    script = pieces.parse(Source("a.face", text), Diagnostics())
    assert script.items[2:] == before[1:] and all(map(lambda one, other: one is other, script.items[2:], before[1:]))
    assert [item.span.text for item in script.items] == ["nod 30%", "blink", 'scene a:\n    say "Ah."', "shake"]
    assert [item.span.source.position(item.span.start) for item in script.items][2:] == [(3, 1), (5, 1)]
