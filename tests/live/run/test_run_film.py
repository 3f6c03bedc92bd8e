"""A run shows the film that is built of the same events."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from running import FPS, Floats, happenings, rows, running, scripts
from scripted import Letters

from facescript.compile import compile_source
from facescript.live.model import Happening
from facescript.motion.perform import perform
from facescript.schedule.score import Score
from facescript.space.plan import GazePlan
from facescript.text import Source
from facescript.world import World

EVENTS = """event ann arrives at 1.2s
event touched "start" at 3.1s
event heard "no" at 4.05s
event heard "No!" at 4.9s
event key "q" at 6.3s
"""

HAPPENINGS = (
    Happening("arrives", 1.2, person="ann"),
    Happening("touched", 3.1, "start"),
    Happening("heard", 4.05, "no"),
    Happening("heard", 4.9, "no"),
    Happening("key", 6.3, "q"),
)

SCRIPT = """film 12s long, seed 4
face ada = woman
    life {life}
target ann moves
    0s -80cm 0cm 2m
    4s   0cm 0cm 1m
    9s  90cm 0cm 2m
scene attract:
    repeat forever:
        look left 20deg for 1s
        nod 20% to 60%
        {line}
        look right 20deg for 1s
        wait 500ms to 1s
when person arrives as guest:
    look at guest
    together:
        show smile 80% for 3s
        nod
when touched "start":
    show excitement 90% for 2s
    scan people, 400ms each
when heard "no":
    show frown 80% for 2s
    {line}
when key "q":
    add AU4 40%
    look away
"""


def built(text: str) -> Score:
    compiled = compile_source(Source("made.face", text), World(Path(__file__).parent), Letters())
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    return compiled.score


def film(text: str) -> Floats:
    return perform(built(text + EVENTS)).sample(np.arange(int(8.0 * FPS)) / FPS)


@settings(max_examples=2, deadline=None)
@given(scripts(), happenings(6, 10.0))
def test_all_that_is_written_is_done_when_the_film_does_it(text: str, events: list[Happening]) -> None:
    done_as_in_the_film(text, events)


def test_a_line_that_waited_for_a_reaction_is_not_said_sooner_once_that_is_forgotten() -> None:
    text = """film 640x360
face ada = woman
scene main:
    repeat forever:
        say "a b"
        wait 1s
when heard "0":
    say "one two three four five"
"""
    done_as_in_the_film(text, [Happening("heard", 2.0, "0"), Happening("heard", 2.2, "0")])


def done_as_in_the_film(text: str, events: list[Happening]) -> None:
    lines = [f"{one.person} arrives" if one.person else f'heard "{one.text}"' for one in events]
    scripted = "".join(f"event {line} at {one.time}s\n" for line, one in zip(lines, events, strict=True))
    score = built(text.replace("film ", "film 40s long, ") + scripted)
    present = [Happening("arrives", 1.0, person="ann")] if "ann" in text else []
    run = running(text, [*present, *events], fps=2.0)
    for number in range(2, 24, 2):
        run.frame(number)
        second = number / 2.0
        assert begun(run.score, second - 1.0, second) == begun(score, second - 1.0, second)


def begun(score: Score, start: float, end: float) -> list[tuple[object, ...]]:
    """What begins in a stretch of time: acts with their first shift of gaze, and lines."""
    acts = ((round(act.start, 6), act.face, act.verb, *_landing(act.plan[:1])) for act in score.acts)
    lines = ((round(line.start, 6), line.face, line.text) for line in score.lines)
    return sorted((one for one in (*acts, *lines) if start <= one[0] < end), key=repr)


def _landing(plans: tuple[GazePlan, ...]) -> Iterator[object]:
    for plan in plans:
        yield from (plan.aim, plan.parts, round(plan.eye_onset, 6), round(plan.landed, 6), round(plan.head_done, 6))


def test_a_still_face_is_the_film_to_the_last_digits() -> None:
    text = SCRIPT.format(life="still", line="blink")
    assert np.abs(rows(running(text + EVENTS, HAPPENINGS), 8.0) - film(text)).max() < 1e-9


@pytest.mark.parametrize("life", ["conversation", "announcer"])
def test_what_lives_and_speaks_foresees_no_event(life: str) -> None:
    """It is the film but for a while before each event, which the film's life knows of, and a while after it."""
    text = SCRIPT.format(life=life, line='say "one two three"')
    times = np.arange(int(8.0 * FPS)) / FPS
    far = np.abs(rows(running(text + EVENTS, HAPPENINGS), 8.0) - film(text)).max(axis=1)
    alike = far < 1e-6
    assert alike[times < 0.3].all()
    assert alike.mean() > 0.4
