"""Plays one after another: what stayed is not solved again, and each is told as a fresh schedule tells it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest
from scheduling import Metronome

from facescript.diagnostics.model import Diagnostic, Diagnostics
from facescript.ir.acts import Do, Say
from facescript.ir.play import Play, Scene
from facescript.resolve.resolver import resolve
from facescript.schedule.kept import Kept
from facescript.schedule.part import Part
from facescript.schedule.scheduler import timed_by
from facescript.schedule.score import Score
from facescript.schedule.solving import Solving
from facescript.speech.model import Doubt, Spoken, VoiceFailure
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

HEAD = """\
face ada = woman
face ben = man
target lamp at 25deg 10deg 2m
target door at 80deg 0deg 2m
target crowd of (-60cm 0cm 2m) (50cm 10cm 2m)
target bird moves
    0s -30deg 0deg 2m
    4s 60deg 5deg 2m
action greet(who):
    look at who
    show smile over 200ms
"""

SCENES = (
    'ada: say "Good evening to you all." as hello\nat hello."evening": ben: nod\nada: greet ben',
    "ada: look at door, eyes only\nada: look at bird for 1s\nben: glance lamp",
    'ada: say "one two three four"\nat 200ms: ada: say "five six"',  # lines of a face overlap
    'ada: say "one two three four"\nat 200ms: ben: say "five six"',
    "ada: show smile over 2s\nat 300ms: ada: show surprise\nada: drop smile\nben: drop frown",
    "repeat 3 times:\n    ada: greet lamp\n    choose:\n        ben: blink\n        ben: nod\n    wait 200ms to 900ms",
    "at 100ms: ada: show smile\nat 100ms: ada: show surprise",  # at one time
    'ada: say "A doubtful line."\nben: say "A doubtful line."\nada: nod',
    'ben: say "A voiceless line."\nada: show smile, spontaneous',
    "at a.end: ada: nod as b\nat b.end: ada: shake as a",  # a circle
    "ada: look at lamp over 5ms\nada: look left 20deg for 50ms\nada: add brow.inner 40% for 300ms",
    "together:\n    ada: scan crowd\n    ben: look away\nwait until 5s\nwait 3s\nat 10s: ada: nod",
    "repeat forever:\n    ada: nod\n    wait 300ms",
    "wait 1s",
)
BAD = (2, 6, 8, 9, 12)
"""Those of the scenes that have an error, or never end."""


class Moody(Metronome):
    """A voice that doubts a line and cannot speak another."""

    def speak(self, line: Say) -> Spoken:
        if "voiceless" in line.text:
            raise VoiceFailure("there is no voice for it")
        spoken = super().speak(line)
        return replace(spoken, doubts=(Doubt("FS509", "it is odd"),)) if "doubtful" in line.text else spoken


@pytest.fixture(scope="module")
def play() -> Play:
    """A play with each of the scenes twice."""
    bodies = enumerate((*SCENES, *SCENES))
    scenes = [f"scene s{number}:\n    " + body.replace("\n", "\n    ") for number, body in bodies]
    diagnostics = Diagnostics()
    source = Source("scenes.face", HEAD + "\n".join(scenes) + "\n")
    made = resolve(parse(source, diagnostics), World(Path(__file__).parent), diagnostics)
    assert made is not None, [(item.message, item.span and item.span.text) for item in diagnostics]
    return made


def told(play: Play, kept: Kept) -> tuple[Score | None, list[Diagnostic]]:
    diagnostics = Diagnostics()
    timed = timed_by(play, VOICE, diagnostics, kept)
    return None if timed is None else timed.score(), diagnostics.items


VOICE = Moody()


@pytest.mark.parametrize("seed", range(6))
def test_scenes_that_come_and_go_are_told_as_a_fresh_schedule_tells_them(play: Play, seed: int) -> None:
    chance, kept, scored = Random(seed), Kept(), 0
    solvable = [scene for number, scene in enumerate(play.scenes) if number % len(SCENES) not in BAD]
    scenes = chance.sample(solvable, 6)
    film = play.film
    for _ in range(15):
        now = replace(play, film=film, scenes=tuple(scenes))
        fresh = told(now, Kept())
        assert told(now, kept) == fresh
        scored += fresh[0] is not None
        if len(scenes) > 2:
            scenes.pop(chance.randrange(len(scenes)))
        new = another(scenes, play.scenes if chance.random() < 0.15 else solvable, chance)
        scenes.insert(chance.randrange(len(scenes) + 1), new)
        if chance.random() < 0.2:
            film = replace(film, long=chance.choice((None, 5.0, 12.0, 20.0, 40.0)))
    assert scored > 3


def another(scenes: list[Scene], of: Sequence[Scene], chance: Random) -> Scene:
    """A scene that is not there yet."""
    return chance.choice([scene for scene in of if not any(scene is other for other in scenes)])


def test_only_what_is_new_is_solved(play: Play, monkeypatch: pytest.MonkeyPatch) -> None:
    solved: list[str] = []
    part = Solving.part

    def noted(self: Solving) -> Part:
        solved.append(" ".join(scene.name for scene in self.play.scenes))
        return part(self)

    monkeypatch.setattr(Solving, "part", noted)
    kept, scenes = Kept(), (play.scenes[1], play.scenes[4], play.scenes[5])
    told(replace(play, scenes=scenes), kept)
    assert solved == ["s1", "s4", "s5"]
    told(replace(play, scenes=(scenes[0], play.scenes[13], *scenes[1:])), kept)
    assert solved[3:] == ["s13"]
    told(replace(play, scenes=scenes[1:]), kept)
    assert solved[4:] == []
    told(replace(play, scenes=scenes[1:], targets=play.targets[:-1]), kept)
    assert solved[4:] == ["s4", "s5"]


class Files(Metronome):
    """A voice whose recordings change."""

    length = 1.0

    def speak(self, line: Say) -> Spoken:
        return replace(super().speak(line), duration=type(self).length)


def test_a_recording_that_changes_on_disk_is_heard_again(play: Play, monkeypatch: pytest.MonkeyPatch) -> None:
    body = play.scenes[0].body
    line = next(item for item in body.items if isinstance(item, Do) and isinstance(item.verb, Say))
    assert isinstance(line.verb, Say)
    recorded = replace(line, verb=replace(line.verb, recording="take.wav"), label=None)
    scene = replace(play.scenes[0], body=replace(body, items=(recorded,)))
    one, kept, voice = replace(play, scenes=(scene,)), Kept(), Files()
    for length in (1.0, 1.0, 2.0):
        monkeypatch.setattr(Files, "length", length)
        timed = timed_by(one, voice, Diagnostics(), kept)
        assert timed is not None and timed.duration == length
