"""The extension for VS Code: what its files promise, held to the language and to each other."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest
from colours import CLIENT, ROOT

from facescript import __version__
from facescript.compile import compile_source
from facescript.diagnostics.model import Severity
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

PACKAGE = json.loads((CLIENT / "package.json").read_text("utf-8"))
LOCK = json.loads((CLIENT / "package-lock.json").read_text("utf-8"))
SNIPPETS = json.loads((CLIENT / "snippets" / "face.json").read_text("utf-8"))
LANGUAGE = json.loads((CLIENT / "language-configuration.json").read_text("utf-8"))
WITHIN = {"cue": 'say "{}"'}
"""Around snippets that are no line of their own."""


def filled(snippet: Any) -> str:
    """A snippet as it stands in the script when an author takes all that it proposes."""
    text = "\n".join(snippet["body"]).replace("$TM_SELECTED_TEXT", "")
    text = re.sub(r"\$\{\d+\|([^,|]*)[^|]*\|\}", r"\1", text)
    return re.sub(r"\$\{\d+:([^}]*)\}", r"\1", text)


@pytest.mark.parametrize("name", SNIPPETS)
def test_snippet_is_good_script(name: str) -> None:
    snippet = SNIPPETS[name]
    script = WITHIN.get(snippet["prefix"], "{}").format(filled(snippet))
    found = compile_source(Source("snippet.face", script), World(ROOT / "examples"), EstimatedVoice()).diagnostics
    assert [item.message for item in found if item.severity is not Severity.HINT] == []


def test_versions_agree() -> None:
    assert PACKAGE["version"] == LOCK["version"] == LOCK["packages"][""]["version"] == __version__
    assert PACKAGE["devDependencies"] == LOCK["packages"][""]["devDependencies"]
    engine = PACKAGE["engines"]["vscode"].lstrip("^")
    assert engine == PACKAGE["devDependencies"]["@types/vscode"] and LOCK["packages"]["node_modules/@types/vscode"]


def test_lock_file_names_no_registry() -> None:
    assert "resolved" not in (CLIENT / "package-lock.json").read_text("utf-8")
    unsure = [name for name, found in LOCK["packages"].items() if name and "integrity" not in found]
    assert unsure == []


def test_what_it_contributes_is_there() -> None:
    contributes = PACKAGE["contributes"]
    parts = [*contributes["languages"], *contributes["grammars"], *contributes["snippets"], PACKAGE]
    named = {part.get("path") or part.get("configuration") or part["icon"] for part in parts}
    packed = (CLIENT / ".vscodeignore").read_text("utf-8")
    for name in named:
        assert (CLIENT / name).is_file() and f"!{name.removeprefix('./').partition('/')[0]}" in packed, name
    sources = "".join(path.read_text("utf-8") for path in (CLIENT / "src").glob("*.ts"))
    for command in contributes["commands"]:
        assert f'registerCommand("{command["command"]}"' in sources


@pytest.mark.parametrize(
    ("line", "deeper"),
    [
        ("ada:", True),
        ('    on "a: b":  # note', True),
        ("scene opening with ada:", True),
        ("ada: nod", False),
        ('say "so:"', False),
        ("# note:", False),
        ("nod  # note:", False),
    ],
)
def test_a_line_that_opens_a_block_indents_the_next(line: str, deeper: bool) -> None:
    assert bool(re.search(LANGUAGE["indentationRules"]["increaseIndentPattern"], line)) is deeper
