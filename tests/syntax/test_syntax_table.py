"""The grammar and its table: no conflicts, the same language as Lark's machine, and a cache that is safe to lose."""

from __future__ import annotations

import os
import stat
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
KEY = "0" * 32


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


# ------------------------------------------------------------------------------------------------ the cache


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "facescript"


def kept(place: Path) -> Path:
    cache.save(KEY, {"a": [1]})
    (path,) = place.iterdir()
    return path


def test_a_table_comes_back_as_it_was(place: Path) -> None:
    made = asdict(build(GRAMMAR))
    assert cache.load(cache.key_of(GRAMMAR)) is None
    cache.save(cache.key_of(GRAMMAR), made)
    loaded = cache.load(cache.key_of(GRAMMAR))
    assert loaded is not None
    assert loaded["states"] == made["states"]
    assert cache.key_of(GRAMMAR) != cache.key_of(GRAMMAR + " ")


@pytest.mark.skipif(os.name != "posix", reason="modes are of posix")
def test_only_the_user_can_write_there(place: Path) -> None:
    path = kept(place)
    assert stat.S_IMODE(place.stat().st_mode) == 0o700
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert cache.load(KEY) == {"a": [1]}


def test_a_damaged_file_is_not_believed_and_is_replaced(place: Path) -> None:
    path = kept(place)
    whole = path.read_bytes()
    for damaged in (b"", whole[:-3], whole.replace(b"1", b"2"), b"\xff" * 100, whole.replace(b"\n", b"")):
        path.write_bytes(damaged)
        assert cache.load(KEY) is None
    cache.save(KEY, {"a": [1]})
    assert cache.load(KEY) == {"a": [1]}


def test_a_file_under_another_key_is_not_believed(place: Path) -> None:
    other = "1" * 32
    path = kept(place)
    path.rename(path.with_name(path.name.replace(KEY, other)))
    assert cache.load(other) is None
    assert cache.load(KEY) is None


@pytest.mark.skipif(os.name != "posix", reason="modes and links are of posix")
def test_what_others_could_have_put_there_is_not_believed(place: Path, tmp_path: Path) -> None:
    path = kept(place)
    path.chmod(0o666)
    assert cache.load(KEY) is None
    path.chmod(0o600)
    place.chmod(0o777)
    assert cache.load(KEY) is None
    place.chmod(0o700)
    assert cache.load(KEY) == {"a": [1]}
    path.rename(tmp_path / "elsewhere")
    path.symlink_to(tmp_path / "elsewhere")
    assert cache.load(KEY) is None


def test_without_a_usable_folder_nothing_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    cache.save(KEY, {})
    assert cache.load(KEY) is None


def test_a_relative_or_missing_home_is_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", "here")
    monkeypatch.setenv("LOCALAPPDATA", "")
    monkeypatch.setattr(Path, "home", lambda: Path("nowhere"))
    cache.save(KEY, {})
    assert cache.load(KEY) is None
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_nothing_behind(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise OSError("no space left on device")

    monkeypatch.setattr(os, "replace", refuse)
    cache.save(KEY, {"a": [1]})
    assert list(place.iterdir()) == []
