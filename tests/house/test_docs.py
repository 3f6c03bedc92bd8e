"""The manual's examples are run, and the page of diagnostics is what the catalogue says."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from runpy import run_path

import pytest

from facescript.cli.list import LISTS
from facescript.cli.report import in_order
from facescript.compile import compile_source
from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.model import Diagnostic, Severity
from facescript.resolve.project import MOST_NODES
from facescript.resolve.repeats import MOST_PASSES
from facescript.resolve.tables import MOST_ROWS
from facescript.resolve.targets import MOST_MEMBERS
from facescript.resolve.texts import LONGEST
from facescript.schedule.means import MOST
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.lexer import LONGEST_LINE
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[2]
DIAGNOSTICS = ROOT / "docs" / "diagnostics.md"
PAGES = [*sorted(path for path in (ROOT / "docs").rglob("*.md") if path != DIAGNOSTICS), ROOT / "README.md"]
"""The examples of `diagnostics.md` are those of the catalogue, which `test_catalogue.py` runs."""

BLOCK = re.compile(r"^```(face|face-bad)(?: \{[^}\n]*\})?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(wanted: str) -> Iterator[object]:
    for page in PAGES:
        text = page.read_text("utf-8")
        for found in BLOCK.finditer(text):
            if found[1] == wanted:
                yield pytest.param(found[2], id=f"{page.name}:{text.count(chr(10), 0, found.start()) + 2}")


def told(script: str) -> list[Diagnostic]:
    """What `check` says of a script that stands in `examples/`."""
    world = World(ROOT / "examples")
    return in_order(compile_source(Source("block.face", script), world, EstimatedVoice()).diagnostics)


@pytest.mark.parametrize("script", list(blocks("face")))
def test_example_is_clean(script: str) -> None:
    assert [(item.code, item.message) for item in told(script) if item.severity is not Severity.HINT] == []


@pytest.mark.parametrize("script", list(blocks("face-bad")))
def test_bad_example_gives_the_codes_it_names(script: str) -> None:
    assert [item.code for item in told(script)] == re.findall(r"# (FS\d{3})", script) != []


@pytest.mark.parametrize("what", ["expressions", "lives", "muscles", "faces", "backends"])
def test_manual_names_all_there_is(what: str) -> None:
    manual = (ROOT / "docs" / "language.md").read_text("utf-8")
    assert [name for name, _ in LISTS[what]() if f"`{name}`" not in manual] == []


@pytest.mark.parametrize("limit", [MOST_PASSES, MOST_ROWS, MOST_MEMBERS, MOST_NODES, MOST, LONGEST, LONGEST_LINE])
def test_manual_states_the_limits(limit: int) -> None:
    assert f"{limit:,}" in (ROOT / "docs" / "language.md").read_text("utf-8").partition("## 20.")[2]


def test_page_of_diagnostics_is_in_step() -> None:
    made = run_path(str(ROOT / "docs" / "make_diagnostics.py"))["page"]()
    assert DIAGNOSTICS.read_text("utf-8") == made, "run `python docs/make_diagnostics.py`"


def test_codes_in_the_pages_exist() -> None:
    for page in PAGES:
        assert set(re.findall(r"\bFS\d{3}\b", page.read_text("utf-8"))) <= set(CATALOGUE), page.name
