"""The playground's examples: installed, good by themselves, and each with a clause that says what it shows."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from facescript.compile import compile_source
from facescript.preview.examples import NAMES, Example, examples
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[2]


def test_they_are_installed() -> None:
    wheel = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert {path for path in wheel["only-include"] if path.startswith("examples/")} == {
        f"examples/{name}.face" for name in NAMES
    }


@pytest.mark.parametrize("example", examples(), ids=NAMES)
def test_it_plays_where_no_other_file_is(example: Example, tmp_path: Path) -> None:
    compiled = compile_source(Source("scratch.face", example.text), World(tmp_path), EstimatedVoice())
    assert [item.code for item in compiled.diagnostics] == []
    assert compiled.score is not None and compiled.score.duration > 0
    assert example.says and ".face" not in example.says
