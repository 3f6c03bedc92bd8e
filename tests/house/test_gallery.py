"""The gallery shows every example, and what the pages show is there."""

from __future__ import annotations

from pathlib import Path
from runpy import run_path

ROOT = Path(__file__).parents[2]
MADE = run_path(str(ROOT / "docs" / "make_pictures.py"))


def test_page_is_in_step() -> None:
    assert (ROOT / "docs" / "gallery.md").read_text("utf-8") == MADE["page"](), "run `make docs`"


def test_every_example_but_the_shared_one_is_shown() -> None:
    assert set(MADE["GALLERY"]) == {path.stem for path in (ROOT / "examples").glob("*.face")} - {"studio"}


def test_every_picture_is_shown() -> None:
    text = "".join(path.read_text("utf-8") for path in [*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"])
    assert [path.name for path in (ROOT / "docs" / "pictures").iterdir() if path.name not in text] == []
