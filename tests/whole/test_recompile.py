"""A script that is edited: each state is told as a fresh compile tells it, and what stayed is not read again."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from pathlib import Path
from random import Random
from typing import Any

import pytest
from _scripts import lines_of
from _wild import SIGNS, WORDS, wild
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from facescript.compile import Compiled, compile_source
from facescript.diagnostics.model import Diagnostics
from facescript.recompile import Recompiler
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.faults import MOST
from facescript.syntax.parser import parse
from facescript.syntax.pieces import Pieces
from facescript.text import Source, Span
from facescript.world import World

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = [*(path.read_text("utf-8") for path in sorted(EXAMPLES.glob("*.face"))), lines_of(60)]
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
