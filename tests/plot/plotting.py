"""Scripts to plots with a voice that says a word every 300 ms, so that places can be read off."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from facescript.backends.job import Job
from facescript.compile import compile_source
from facescript.ir.acts import Say
from facescript.plot.marks import Area, Drawing, Line, Mark, Text
from facescript.plot.picture import Asked, draw
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.text import Source
from facescript.world import World

WORD, RATE = 0.3, 8000


class Metronome:
    """A word every 300 ms, each a tone that dies away."""

    def speak(self, line: Say) -> Spoken:
        words, first = [], 0
        for number, text in enumerate(line.text.split()):
            words.append(WordTime(text, first, first + len(text), WORD * number, WORD * (number + 1)))
            first += len(text) + 1
        length = WORD * len(words)
        times = np.arange(round(length * RATE)) / RATE
        pcm = (9000 * np.sin(times * 2000) * (1 - times % WORD / WORD)).astype("<i2").tobytes()
        return Spoken(pcm, RATE, length, tuple(words), (PhoneTime("a", 0.0, length),))


def job_of(script: str, start: float = 0.0, end: float | None = None) -> Job:
    compiled = compile_source(Source("script.face", script), World(Path(__file__).parent), Metronome())
    assert compiled.play is not None and compiled.score is not None, [item.message for item in compiled.diagnostics]
    duration = compiled.score.duration
    return Job(compiled.play, compiled.score, World(Path()).read, start, duration if end is None else end)


def plot(
    script: str, *channels: str, start: float = 0.0, end: float | None = None, size: tuple[int, int] | None = None
) -> Drawing:
    return draw(job_of(script, start, end), Asked("script.face", channels, size))


def texts(drawing: Drawing) -> list[str]:
    return [mark.text for mark in drawing.marks if isinstance(mark, Text)]


def curves(drawing: Drawing) -> list[str]:
    """The channels that are drawn, a curve each."""
    return [mark.name for mark in drawing.marks if isinstance(mark, Line) and mark.name]


def points(mark: Mark) -> list[tuple[float, float]]:
    if isinstance(mark, Text):
        return [(mark.x, mark.y)]
    return list(mark.points) if isinstance(mark, Area) else [point for part in mark.parts for point in part]


def told(drawing: Drawing) -> str:
    """The marks, one a line; of a curve its channels and look, as what moves how is other tests' business."""
    return f"{drawing.width}x{drawing.height} {drawing.title}\n" + "".join(f"{_line(mark)}\n" for mark in drawing.marks)


def _line(mark: Mark) -> str:
    if isinstance(mark, Text):
        return f"text {mark.x:.0f},{mark.y:.0f} {mark.anchor} {mark.size}px {mark.colour} {mark.text}"
    if isinstance(mark, Line) and mark.name:
        return f"curve {mark.name} {mark.colour} {mark.width:g}px{''.join(f' {each:g}' for each in mark.dash)}"
    places = " ".join(f"{x:.0f},{y:.0f}" for x, y in points(mark))
    if isinstance(mark, Line):
        return f"line {mark.colour} {places}"
    if len(mark.points) > 8:
        return f"area {mark.fill} of many points"
    note = f" “{mark.note}”".replace("\n", " | ") if mark.note else ""
    return f"area {mark.fill or 'open'}{f' {mark.edge}' if mark.edge else ''} {places}{note}"
