"""A run shows the film that is built of the same events."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from running import FPS, Floats, rows, running
from scripted import Letters

from facescript.compile import compile_source
from facescript.live.model import Happening
from facescript.motion.perform import perform
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


def film(text: str) -> Floats:
    compiled = compile_source(Source("made.face", text + EVENTS), World(Path(__file__).parent), Letters())
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    return perform(compiled.score).sample(np.arange(int(8.0 * FPS)) / FPS)


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
