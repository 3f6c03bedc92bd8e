"""The scripts that the language was designed with: each resolves to the play written beside it, or is refused as told.

`FACESCRIPT_UPDATE=1` writes the texts anew.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from plays import resolved, said, shown

SCRIPTS = Path(__file__).parent / "scripts"
NAMES = sorted(path.stem for path in SCRIPTS.glob("*.face"))


@pytest.mark.parametrize("name", NAMES)
def test_script_is_the_play_beside_it(name: str) -> None:
    path = SCRIPTS / f"{name}.face"
    play, diagnostics = resolved(path.read_text("utf-8"), SCRIPTS, path.name)
    found = said(diagnostics) + (shown(play) if play is not None else "refused\n")
    golden = path.with_suffix(".txt")
    if os.environ.get("FACESCRIPT_UPDATE"):
        golden.write_text(found, "utf-8")
    assert found == golden.read_text("utf-8")
