"""Which line speaks at a moment, and which two shapes of the mouth weigh."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from facescript.ir.acts import Say
from facescript.motion.mouth import MouthTrack
from facescript.owners.model import Part, Source, statement
from facescript.performance.channels import MOUTH
from facescript.schedule.phrases import percent
from facescript.schedule.score import Score, TimedAct, TimedLine


class Lines:
    """The spoken lines of one face, and the statements that speak them."""

    def __init__(self, score: Score, face: str) -> None:
        self._lines = [line for line in score.lines if line.face == face]
        self._said = [act for act in score.acts if isinstance(act.verb, Say) and act.face == face]

    def near(self, time: float) -> Source | None:
        """The statement whose line sounds at `time`, or is nearest to it; the later one of two."""
        if not self._lines:
            return None
        line = min(reversed(self._lines), key=lambda line: max(line.start - time, time - line.end, 0.0))
        return _statement(line, self._said)


def shapes(track: MouthTrack, part: str, time: float, lines: Lines) -> tuple[Part, ...]:
    """The shapes that weigh, two at most (rule 4): each one's value of `mouth.part`, and its weight."""
    if not track.shapes:
        return ()
    firsts, seconds, weights = track.weights(np.array([time]), part)
    weight, column = float(weights[0]), MOUTH.index(part)
    found = []
    for index, share in ((int(firsts[0]), 1.0 - weight), (int(seconds[0]), weight)):
        shape = track.shapes[index]
        if share and shape.name != "rest":
            degree = "" if shape.degree == 1.0 else f" {percent(shape.degree)}"
            said = lines.near((shape.on + shape.off) / 2.0)
            assert said is not None, "a shape is a line's"
            source = Source(f"mouth shape {shape.name}{degree}", said.file, said.line, said.label)
            found.append(Part(source, float(shape.values[column]), share))
    return tuple(found)


def _statement(line: TimedLine, said: Sequence[TimedAct]) -> Source | None:
    """The statement that speaks a line: the last at its place that begins no later."""
    acts = [act for act in said if act.span == line.span and act.start <= line.start]
    return statement(acts[-1]) if acts else None
