"""Scripts play on every kind of face: the same acts, each drawn by what that face has."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from facescript.backends.job import Job
from facescript.compile import compile_source
from facescript.diagnostics.model import Severity
from facescript.resolve.kinds.library import kind_names
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = ("expressions", "dialogue", "gestures")
LOOKS = re.compile(r"^    (hair|skin|eyes|lips|clothes) .*\n", re.MULTILINE)


@pytest.mark.parametrize("name", SCRIPTS)
@pytest.mark.parametrize("kind", kind_names())
def test_a_script_plays_on_every_kind(kind: str, name: str) -> None:
    """Without an error, drawn finite at all times, and every face of it moves eyes, mouth or head."""
    text = (EXAMPLES / f"{name}.face").read_text("utf-8")
    if "face " not in text:
        text = f"face one = woman\n{text}"
    script = re.sub(r"= (woman|man)\b", f"= {kind}", LOOKS.sub("", text))
    world = World(EXAMPLES)
    compiled = compile_source(Source(f"{name}.face", script), world, EstimatedVoice())
    faults = [item for item in compiled.diagnostics if item.severity is Severity.ERROR]
    assert not faults, [item.message for item in faults]
    assert compiled.play is not None and compiled.score is not None
    assert {face.kind for face in compiled.score.faces} == {kind}
    job = Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration, None)
    drawn = job.stage.frames(np.linspace(0.0, compiled.score.duration, 40))
    assert np.isfinite(drawn.points).all()
    for owner in {owner for owner in job.stage.owners if owner}:
        rows = [
            row
            for shape, whose in zip(job.stage.shapes, job.stage.owners, strict=True)
            if whose == owner and shape.moving
            for contour in shape.contours
            for row in range(contour.first, contour.first + contour.count)
        ]
        assert np.ptp(drawn.points[:, rows], axis=0).max() > 4.0
