"""The kinds' sheets look as they did: who changes a face sees on a page what changed; `make sheets` renews them."""

from __future__ import annotations

from pathlib import Path

import goldens
import numpy as np
import pytest
from goldens import FOLDER, Comparison, compare, difference, page_of_kind, show

from facescript.resolve.kinds.library import kind_names


@pytest.mark.parametrize("kind", kind_names())
def test_sheet_looks_as_it_did(kind: str) -> None:
    found = compare(kind)
    if not found.same:
        pytest.fail(f"{found.told()}; {show(found)} shows it; `make sheets` if it is meant", pytrace=False)


def test_what_is_kept_is_of_kinds_there_are_and_small() -> None:
    kept = list(FOLDER.glob("*.png"))
    assert {path.stem for path in kept} == set(kind_names())
    assert max(path.stat().st_size for path in kept) < 400_000


def test_a_small_change_of_one_cell_is_found_and_shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A mark of 5x5 px, as a pupil has, in one cell of a hundred."""
    page = page_of_kind("man")
    spot = next(spot for spot in page.spots if spot.cell.label == "anger")
    before = np.full((page.drawing.height, page.drawing.width, 3), 240, dtype=np.uint8)
    after = before.copy()
    after[spot.top + 40 : spot.top + 45, spot.left + 30 : spot.left + 35] = 40
    found = Comparison("man", page, before, after, difference(before, after))
    assert not found.same
    assert [each.cell.label for each in found.changed()] == ["anger"]
    monkeypatch.setattr(goldens, "PAGES", tmp_path)
    text = show(found).read_text("utf-8")
    assert "anger" in text and text.count("<img") == 6
    assert Comparison("man", page, before, before, difference(before, before)).same
