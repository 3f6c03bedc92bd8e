"""The SVG's groups are rolled as far as the rasteriser rolls the gradients in them, however the film begins."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from facescript.backends.job import Job
from facescript.backends.svg.carry import ANGLE, carriers
from facescript.compile import compile_source
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

SCRIPT = """film 320x320
face ada = {face}

scene one:
    show head.roll 20deg over 0.5s
    wait 2s
    show head.roll -20deg over 0.5s
    wait 2s
"""
MOMENTS = np.array([1.5, 2.0, 2.2, 2.3, 2.6, 3.0])
HEAD, BENT = 0.2, 5.0
"""Degrees, of 40 from side to side: what is on the head, and what is between head and trunk, which bends."""


@pytest.mark.parametrize("face", ["woman, hair long", "dog"])
def test_groups_are_rolled_as_gradients_are(face: str, tmp_path: Path) -> None:
    world = World(tmp_path)
    compiled = compile_source(Source("roll.face", SCRIPT.format(face=face)), world, EstimatedVoice())
    assert compiled.play is not None and compiled.score is not None
    job = Job(compiled.play, compiled.score, world.read, MOMENTS[0], MOMENTS[-1])
    shapes = job.stage.shapes
    columns = [np.concatenate([np.arange(each.first, each.first + each.count) for each in s.contours]) for s in shapes]
    moments = np.linspace(MOMENTS[0], MOMENTS[-1], 451)
    of, found = carriers(job, shapes, columns, moments, 0.25)
    turns = np.degrees(job.stage.frames(MOMENTS).turns)
    assert abs(turns).max() > 19.9
    for place, (shape, number) in enumerate(zip(shapes, of, strict=True)):
        rolled = found[number].angles.at(MOMENTS)[:, 0] * ANGLE
        stiff = turns[0, place] > 19.9 and not shape.group.startswith(("brow", "nose"))
        assert rolled == pytest.approx(turns[:, place], abs=HEAD if stiff else BENT), shape.id
