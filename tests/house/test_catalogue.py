"""Every code of the catalogue: its bad example gives it, its good example does not."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from facescript.cli.main import main
from facescript.compile import compile_source
from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Diagnostic, Severity
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

VOICES = {"check": EstimatedVoice, "build": open_studio}
SCRIPTED = [entry for entry in CATALOGUE.values() if entry.stage in VOICES]
COMMANDED = [entry for entry in CATALOGUE.values() if entry.stage == "command"]


def name(entry: Entry) -> str:
    return f"{entry.code}-{entry.name}"


def put(entry: Entry, folder: Path) -> None:
    """The files that an example reads."""
    for path, content in entry.files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(content, "utf-8")


def diagnostics(entry: Entry, text: str, folder: Path) -> Iterator[Diagnostic]:
    put(entry, folder)
    world = World(folder)
    yield from compile_source(Source("script.face", text), world, VOICES[entry.stage](world)).diagnostics


@pytest.mark.parametrize("entry", SCRIPTED, ids=name)
def test_bad_example_gives_the_code_and_nothing_else(entry: Entry, tmp_path: Path) -> None:
    found = list(diagnostics(entry, entry.bad, tmp_path))
    assert {item.code for item in found} == {entry.code}
    assert all(item.severity is entry.severity and item.span is not None for item in found)


@pytest.mark.parametrize("entry", SCRIPTED, ids=name)
def test_good_example_is_clean(entry: Entry, tmp_path: Path) -> None:
    assert [item.message for item in diagnostics(entry, entry.good, tmp_path) if item.code == entry.code] == []
    assert [item.message for item in diagnostics(entry, entry.good, tmp_path) if item.severity == "error"] == []


@pytest.mark.parametrize("entry", COMMANDED, ids=name)
def test_command_line_gives_the_code(
    entry: Entry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(entry, tmp_path)
    (tmp_path / "script.face").write_text(entry.bad, "utf-8")
    monkeypatch.chdir(tmp_path)
    assert (main(list(entry.command)) != 0) == (entry.severity is Severity.ERROR)
    assert entry.code in capsys.readouterr().err


def test_sentences_are_sentences() -> None:
    for entry in CATALOGUE.values():
        assert entry.sentence.rstrip('"').endswith((".", "?", "}")), entry.code
        assert entry.why or entry.stage in VOICES, entry.code


def test_codes_stand_in_their_families() -> None:
    assert all(code.startswith("FS") and code[2:].isdigit() and len(code) == 5 for code in CATALOGUE)
