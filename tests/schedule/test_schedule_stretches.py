"""Long scenes in stretches: what is solved is what solving them as one comes to, and an edit solves only what it
touched."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from random import Random

import pytest
from scheduling import Metronome

from facescript.diagnostics.model import Diagnostic, Diagnostics
from facescript.ir.acts import Node
from facescript.ir.play import Play
from facescript.resolve.resolver import resolve
from facescript.schedule import kept as keeping
from facescript.schedule.kept import Kept
from facescript.schedule.part import Part
from facescript.schedule.scheduler import timed_by
from facescript.schedule.score import Score, TimedAct
from facescript.schedule.solving import Solving
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

HEAD = """\
face ada = woman, gaze eye-mover
face ben = man
target lamp at 25deg 10deg 2m
target door at 80deg 0deg 2m
target bird moves
    0s -30deg 0deg 2m
    4s 60deg 5deg 2m
action greet(who):
    look at who
    show smile over 200ms
"""

COMMON = (
    'ada: say "Good evening to you, number {n}." as line{n}',
    'ben: say "one two three" as said{n}\n    on "two": ada: nod',
    "wait 1s",
    "wait 300ms",
    "ada: look at lamp",
    "ada: look at door, eyes only",
    "ben: look at ada for 2s",
    "ada: glance ben",
    "ben: look left 20deg over 5ms",
    "ada: greet ben",
    "ada: show smile over 2s",
    "ben: show anger 40% for 600ms",
    "ben: show neutral",
    "ada: add brow.inner 40% for 900ms",
    "ada: nod",
    "together:\n    ben: shake 20%\n    ada: look at lamp for 1s",
    "repeat 2 times:\n    ben: nod\n    wait 200ms",
    "at line{n}.end + 300ms: ben: blink",
)
"""Statements; `{n}` is the number of the last that bears a name."""

RARE = (
    "ada: add brow.inner 40% as worn{n}",
    "ada: drop brow.inner",
    "ada: drop smile",
    "choose:\n    ben: blink\n    ben: nod",
    "wait 200ms to 900ms",
    "ada: look away",
    "ben: show smile, spontaneous",
    "at line{n}.end: ada: show surprise",
    'at line{n}.end - 1s: ada: say "too soon"',
    "wait until line{n}.end",
)


def play_of(chance: Random, count: int, rare: float) -> Play:
    """A play of one scene with so many statements, some of them rare ones."""
    text, number = HEAD + 'ada: say "one" as line0\n', 0
    for _ in range(count):
        made = chance.choice(RARE if chance.random() < rare else COMMON)
        named = "as line{n}" in made or "as said{n}" in made or "as worn{n}" in made
        line = "as line{n}" in made
        text += made.format(n=number + 1 if line else f"{number}_{text.count(chr(10))}" if named else number) + "\n"
        number += line
    return resolved(text)


def resolved(text: str) -> Play:
    diagnostics = Diagnostics()
    play = resolve(parse(Source("long.face", text), diagnostics), World(Path(__file__).parent), diagnostics)
    assert play is not None, [(item.message, item.span and item.span.text) for item in diagnostics]
    return play


VOICE = Metronome(True)


def told(play: Play, kept: Kept) -> tuple[Score | None, list[Diagnostic]]:
    diagnostics = Diagnostics()
    timed = timed_by(play, VOICE, diagnostics, kept)
    return None if timed is None else timed.score(), diagnostics.items


def with_items(play: Play, items: list[Node]) -> Play:
    scene = play.scenes[0]
    return replace(play, scenes=(replace(scene, body=replace(scene.body, items=tuple(items))),))


@pytest.mark.parametrize("seed", range(5))
def test_stretches_come_to_what_the_whole_scene_does(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    play = play_of(Random(seed), 150, seed * 0.02)
    parts: list[Part] = []
    part = Solving.part
    monkeypatch.setattr(Solving, "part", lambda self: parts.append(part(self)) or parts[-1])
    cut, cut_told = told(play, Kept())
    assert cut is not None and (len(parts) > 2 or seed > 3)
    monkeypatch.setattr(keeping, "LONG", 10_000)
    whole, whole_told = told(play, Kept())
    assert whole is not None
    assert [(act.span, act.face, act.label, act.drops, act.seed) for act in cut.acts] == [
        (act.span, act.face, act.label, act.drops, act.seed) for act in whole.acts
    ]
    for one, other in zip(cut.acts, whole.acts, strict=True):
        assert times(one) == pytest.approx(times(other), abs=1e-6)
    assert sorted(map(said, cut_told)) == sorted(map(said, whole_told))
    assert [marker.name for marker in cut.markers] == [marker.name for marker in whole.markers]
    assert cut.duration == pytest.approx(whole.duration)


def times(act: TimedAct) -> list[float]:
    plans = [time for plan in act.plan for time in (plan.eye_onset, plan.landed, plan.head_onset, plan.head_done)]
    return [act.start, act.settled, act.released, act.end, *plans]


def said(item: Diagnostic) -> tuple[str, int, str]:
    assert item.span is not None
    return item.code, item.span.start, item.message


@pytest.mark.parametrize("seed", range(5))
def test_edits_are_told_as_a_fresh_schedule_tells_them(seed: int) -> None:
    chance = Random(seed)
    play, kept = play_of(chance, 150, seed * 0.02), Kept()
    pool = list(play.scenes[0].body.items)
    items = list(pool)
    for _ in range(6):
        assert told(with_items(play, items), kept) == told(with_items(play, items), Kept())
        at = chance.randrange(len(items))
        if chance.random() < 0.5:
            del items[at : at + chance.choice((1, 1, 1, 10))]
        else:
            items[at:at] = [item for item in chance.sample(pool, 2) if not any(item is other for other in items)]


def test_an_edit_solves_what_it_touched(monkeypatch: pytest.MonkeyPatch) -> None:
    play, kept = play_of(Random(0), 300, 0.0), Kept()
    solved: list[int] = []
    part = Solving.part

    def noted(self: Solving) -> Part:
        solved.append(len(self.play.scenes[0].body.items))
        return part(self)

    monkeypatch.setattr(Solving, "part", noted)
    items = list(play.scenes[0].body.items)
    told(with_items(play, items), kept)
    for at in (10, 150, 290):
        solved.clear()
        told(with_items(play, [*items[:at], *items[at + 1 :]]), kept)
        assert sum(solved) < 60
        told(with_items(play, items), kept)


@pytest.mark.parametrize(
    ("first", "other", "last"),
    [
        ("ada: look at lamp", "ada: look at ben", "ada: look left 30deg"),  # where the eyes come from
        ("ada: look at lamp", "ada: look at ben", "ada: glance ben"),  # what they go back to
        ("wait 1s", "ada: nod", "wait 1s to 3s"),  # how the seed knows a statement
        ("ada: look at lamp", "ada: look at door over 5ms", 'ben: say "So."'),  # nothing
    ],
)
def test_what_a_stretch_is_begun_with_is_seen(first: str, other: str, last: str) -> None:
    lines = "".join(f'ada: say "This is number {number}."\n' for number in range(160))
    text = f'{HEAD}{first}\n{other}\n{lines}{last}\nada: say "The end."\n'
    play = resolved(text)
    one, two, *rest = play.scenes[0].body.items
    kept = Kept()
    for items in ([one, *rest], [two, *rest], [one, two, *rest]):
        assert told(with_items(play, items), kept) == told(with_items(play, items), Kept())
