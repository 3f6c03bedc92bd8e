"""The TextMate grammar is made of the language's own words, and colours scripts as the lexer reads them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from runpy import run_path
from typing import Any

import pytest
from colours import ABSENT, ROOT, SCRIPTS, Token, coloured, golden, page

from facescript.diagnostics.model import Diagnostics
from facescript.performance.channels import CHANNELS
from facescript.resolve.kinds.words import ROWS
from facescript.resolve.units import UNITS
from facescript.resolve.words import FACE, FILM, MODIFIERS, VALUE, VERBS, WORDS
from facescript.syntax.faults import Faults
from facescript.syntax.lexer import lex
from facescript.syntax.table import table
from facescript.text import Source

MADE = run_path(str(ROOT / "editors" / "make_textmate.py"))
READ = sorted(
    path
    for pattern in ("examples/*.face", "stdlib/*.face", "stdlib/faces/dog.face", "tests/syntax/scripts/*.face")
    for path in ROOT.glob(pattern)
)
needs_node = pytest.mark.skipif(ABSENT, reason="needs node and what `make vscode` installs")

EXPECTED = {
    "STRING": "string.quoted.double",
    "QUANTITY": "constant.numeric",
    "INTEGER": "constant.numeric",
    "NTH": "constant.numeric",
    "SIZE": "constant.numeric.size",
    "COLOUR": "constant.other.color",
    "COLON": "punctuation.section.block",
    "COMMENT": "comment.line",
}
"""What a token of the lexer has among its scopes."""


def expressions(rule: Any) -> Iterator[str]:
    """All regular expressions below a rule."""
    if isinstance(rule, dict):
        yield from (rule[key] for key in ("match", "begin", "end") if key in rule)
        rule = list(rule.values())
    if isinstance(rule, list):
        for part in rule:
            yield from expressions(part)


def test_the_file_is_in_step_with_the_language() -> None:
    assert MADE["GRAMMAR"].read_text("utf-8") == MADE["text"](), "run `python editors/make_textmate.py`"


def test_every_word_of_the_language_has_a_colour() -> None:
    listed = set(re.split(r"[^\w./%-]| \+", " ".join(expressions(MADE["grammar"]()))))
    said = {word for row in (*MODIFIERS.values(), *FACE.values(), *FILM.values()) for word in row.pattern} - {VALUE}
    heads = {channel.name.partition(".")[0] for channel in CHANNELS}
    assert {*WORDS, *VERBS, *table().keywords, *said, *UNITS, *ROWS, *heads} - listed == set()


def test_the_golden_script_has_every_word() -> None:
    script = next(path for path in SCRIPTS if path.stem == "constructs").read_text("utf-8")
    heads = {channel.name.partition(".")[0] for channel in CHANNELS}
    assert (WORDS | set(table().keywords)) - heads - set(re.findall(r"[\w-]+", script)) == set()


def test_its_regular_expressions_are_plain_ones() -> None:
    found = list(expressions(MADE["grammar"]()))
    assert len(found) > 50
    for expression in found:
        re.compile(expression)


def test_what_it_includes_is_there() -> None:
    grammar = MADE["grammar"]()
    assert set(re.findall(r"'#([\w-]+)'", str(grammar))) == set(grammar["repository"])


@needs_node
def test_scripts_are_coloured_as_they_were() -> None:
    for script, lines in zip(SCRIPTS, coloured(SCRIPTS), strict=True):
        assert page(script, lines) == golden(script).read_text("utf-8"), "look at it: tests/editors/colours.py"


@needs_node
def test_colours_agree_with_the_lexer() -> None:
    files = [*READ, *(path for path in SCRIPTS if path.stem == "constructs")]
    wrong = [
        f"{path.name}: {kind} {word!r} is {scopes}"
        for path, lines in zip(files, coloured(files), strict=True)
        for kind, word, scopes in read(path, lines)
        if not fits(kind, scopes)
    ]
    assert wrong == []


def read(path: Path, lines: list[list[Token]]) -> Iterator[tuple[str, str, list[str]]]:
    """What the lexer reads, and the scopes at its first and at its last character."""
    source = Source(path.name, path.read_text("utf-8"))
    lexed = lex(source, Faults(source, Diagnostics()))
    tokens = [token for line in lexed.lines for token in line.tokens]
    scopes = scopes_of(source.text, lines)
    for kind, start, end in [(kind, a, b) for kind, _, a, b in tokens] + [("COMMENT", *at) for at in lexed.comments]:
        for place in (start, end - 1):
            yield kind, source.text[start:end], scopes[place]


def scopes_of(text: str, lines: list[list[Token]]) -> list[list[str]]:
    """The scopes of each character."""
    found: list[list[str]] = []
    for line, tokens in zip(text.split("\n"), lines, strict=True):
        units = [scopes for start, end, scopes in tokens for _ in range(start, end)]
        column = 0
        for sign in line:
            found.append(units[column])
            column += 2 if sign > "\uffff" else 1
        found.append([])
    return found


def fits(kind: str, scopes: list[str]) -> bool:
    if kind in EXPECTED:
        return any(scope.startswith(EXPECTED[kind]) for scope in scopes)
    if kind in table().keywords.values():
        return any(scope.startswith(("storage", "keyword", "support.function")) for scope in scopes)
    return bool(scopes) and not any(scope.startswith(("comment", "invalid")) for scope in scopes)
