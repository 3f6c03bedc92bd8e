"""One preview for all tests of a run: its process takes seconds to be ready."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from serving import Serving

SCRIPT = """\
film 480x270, seed 2
use "parts.face"
face ada = woman, hair still
    life still
scene one:
    wait 500ms
    show smile 40% for 1s
    wait 500ms
    show wry
    wait 2s
"""
PARTS = "expression wry = smile.left 60%\n"


@pytest.fixture(scope="session")
def serving(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Serving]:
    folder = tmp_path_factory.mktemp("preview")
    (folder / "parts.face").write_text(PARTS, "utf-8")
    os.environ["PYTHONPATH"] = str(Path(__file__).parents[2])
    with Serving(folder, SCRIPT) as serving:
        yield serving
