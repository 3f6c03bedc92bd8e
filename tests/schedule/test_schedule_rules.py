"""One small script for each rule of time, and the table of what it comes to (UPDATE_TABLES=1 writes the tables)."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from scheduling import Scheduled, scheduled

from facescript.schedule.explain import as_text, explain

RULES = sorted((Path(__file__).parent / "rules").glob("*.face"))


@pytest.mark.parametrize("path", RULES, ids=lambda path: path.stem)
def test_rule(path: Path) -> None:
    table = told(scheduled(path.read_text("utf-8")))
    expected = path.with_suffix(".txt")
    if os.environ.get("UPDATE_TABLES"):
        expected.write_text(table, "utf-8")
    assert table == expected.read_text("utf-8")


def told(done: Scheduled) -> str:
    """All that a score says about time, as text."""
    score = done.solved
    scenes = [f"scene {scene.name} {scene.start:.3f} {scene.end:.3f}" for scene in score.scenes]
    markers = [f"marker {marker.name} {marker.time:.3f}" for marker in score.markers]
    drops = [f"drop at {act.start:.3f} of {act.drops}" for act in score.acts if type(act.verb).__name__ == "Drop"]
    warnings = [f"{item.code} {item.message}" for item in done.diagnostics]
    tail = [*scenes, *markers, *drops, f"duration {score.duration:.3f}", *warnings]
    return "\n".join([as_text(explain(score)), "", *tail]) + "\n"
