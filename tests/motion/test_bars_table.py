"""The table of `make motion`: every bar has a measure, what lies outside its band fails, and the manual has it all."""

from __future__ import annotations

from pathlib import Path

import groups
import pytest
import sources
import table
from table import Row, bars, failed, printed, row, row_between

MANUAL = (Path(__file__).parents[2] / "docs" / "motion.md").read_text("utf-8")


def passing(bar: str) -> Row:
    """A row of a bar in the middle of its first case."""
    case, (low, high) = next(iter(bars()[bar].cases.items()))
    return row(bar, case, "made", [(low + high) / 2], "made")


def test_every_bar_is_measured() -> None:
    measured = {name for measures in groups.GROUPS.values() for names in measures for name in names.split()}
    assert measured >= set(bars())
    assert len(bars()) == 45


def test_every_group_is_run_once() -> None:
    assert sorted(name for half in groups.HALVES for name in half) == sorted(groups.GROUPS)


def test_a_bar_without_a_row_or_with_one_outside_fails() -> None:
    rows = [passing(name) for name in bars()]
    assert failed(rows) == []
    assert failed([each for each in rows if each.bar != "C2"]) == ["C2"]
    assert failed([*rows, row("V1", "0.3..6 m", "made", [0.1, 0.51], "made")]) == ["V1"]
    assert failed([*rows, row("S7", "mean", "made", [float("nan")], "made")]) == ["S7"]
    assert failed([*rows, row("B1", "rest", "made", [], "made")]) == ["B1"]


def test_what_rests_on_memory_alone_is_printed_apart_and_not_counted() -> None:
    bad = row("H5", "<=10", "made", [9.0], "made")
    assert failed([*map(passing, bars()), bad]) == []
    counted, apart = printed([passing("H6"), bad]).split("not human data")
    assert "H6" in counted and "H5" not in counted
    assert "H5" in apart and "FAIL" in apart
    assert {name for name, bar in bars().items() if bar.status.split()[0] == "M" and "," not in bar.status} == set(
        table.PRINTED_ONLY
    )


@pytest.mark.parametrize(("size", "edges"), [(5, (32, 51)), (15, (54, 77.5)), (30, (87, 118))])
def test_between_the_sizes_of_a_bar_its_edges_are_joined(size: float, edges: tuple[float, float]) -> None:
    assert bars()["S1"].edges(size) == pytest.approx(edges)
    low, high = edges
    assert row_between("S1", "made", {size: [low, high]}, "made").passed
    assert not row_between("S1", "made", {size: [low, high + 0.1]}, "made").passed


def test_the_standing_of_a_source_is_said_in_words() -> None:
    assert bars()["S1"].standing == "from memory (edges), found in code (inside)"
    assert bars()["C2"].standing == "found in code, found"


def test_the_manual_has_the_bars_and_the_disagreements() -> None:
    assert table.manual() in MANUAL
    assert sources.printed() in MANUAL
