"""The grammar and its table: no conflicts, the same language as Lark's machine, and kept as it was made."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest
from lark import Lark, Token
from lark.common import ParserConf
from lark.parsers.lalr_analysis import LALR_Analyzer
from outlines import SCRIPTS

from facescript.resources import folder
from facescript.syntax import cache
from facescript.syntax.blocks import cut
from facescript.syntax.faults import Faults
from facescript.syntax.lexer import Line, lex
from facescript.syntax.machine import SOFT
from facescript.syntax.table import STARTS, build, table
from facescript.text import Source

GRAMMAR = (folder("grammar") / "face.lark").read_text("utf-8")


@pytest.fixture(scope="module")
def lark() -> Lark:
    return Lark(GRAMMAR, parser="lalr", lexer="contextual", maybe_placeholders=False, start=list(STARTS))


def test_the_grammar_has_no_conflicts(lark: Lark) -> None:
    LALR_Analyzer(ParserConf(lark.rules, {}, list(STARTS)), strict=True).compute_lalr()  # type: ignore[no-untyped-call]


def kinds(block: list[Line]) -> list[str]:
    found: list[str] = []
    level = 0
    for line in block:
        found += ["_INDENT"] * (line.level - level) + ["_DEDENT"] * (level - line.level)
        found += [*(token[0] for token in line.tokens), "_NL"]
        level = line.level
    return found + ["_DEDENT"] * level


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_the_machine_of_lark_takes_the_same_tokens(path: Path, lark: Lark) -> None:
    source = Source(path.name, path.read_text("utf-8"))
    for block in cut(lex(source, Faults(source)).lines, Faults(source)):
        machine: Any = lark.parse_interactive(start="start")
        for kind in kinds(block):
            soft = kind in SOFT and kind not in machine.accepts()
            machine.feed_token(Token("NAME" if soft else kind, ""))
        assert "$END" in machine.accepts()


def test_the_table_is_built_the_same_each_time() -> None:
    assert build(GRAMMAR).pattern == table().pattern
    assert build(GRAMMAR).rules == [tuple(rule) for rule in table().rules]


def test_a_table_comes_back_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    made = asdict(build(GRAMMAR))
    assert cache.load(cache.key_of(GRAMMAR)) is None
    cache.save(cache.key_of(GRAMMAR), made)
    loaded = cache.load(cache.key_of(GRAMMAR))
    assert loaded is not None
    assert loaded["states"] == made["states"]
    assert cache.key_of(GRAMMAR) != cache.key_of(GRAMMAR + " ")
