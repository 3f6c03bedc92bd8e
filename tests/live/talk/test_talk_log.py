"""What a run was told is in its log, and a replay gives the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from talking import SCRIPT, Notes

from facescript.compile import Settings
from facescript.live.clock import SimulatedClock
from facescript.live.log import Head, Log, Recorded, Replay, open_log
from facescript.live.loop import Loop
from facescript.live.model import Frame, Happening
from facescript.live.opening import open_play, prompter_of
from facescript.live.run.run import Run
from facescript.live.talk.prompting import Prompting
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

TOLD = (
    Happening("told", 0.2, 'say "This goes on\n    "and on, and on, and on." as it\non_it: nod'),
    Happening("told", 0.5, 'ada: say "This goes on and on, and on, and on, and on."\n    on "goes": nod'),
    Happening("told", 0.6, "look at lamp, eyes only"),
    Happening("hushed", 1.5, "ada"),
)


class Frames(Notes):
    def __init__(self) -> None:
        super().__init__()
        self.rows: list[Frame] = []

    def frame(self, frame: Frame) -> None:
        self.rows.append(frame)


async def replayed(recorded: Recorded) -> Frames:
    source, world = Source("x.face", SCRIPT), World(Path.cwd())
    play, _ = open_play(source, world, Settings())
    assert play is not None
    prompting = Prompting(lambda: prompter_of(source, world, Settings()), ("ada",))
    frames = Frames()
    run = Run(play, open_studio(world), recorded.head.fps, prompting)
    await Loop(run, SimulatedClock(), Replay(recorded), [frames]).play()
    return frames


async def test_a_log_of_what_was_told_gives_the_same_again(tmp_path: Path) -> None:
    pytest.importorskip("espeakng_loader")
    path = tmp_path / "run.log"
    with path.open("w", encoding="utf-8") as out:
        log = Log(out, Head("x.face", "", 0, 10.0, "0"))
        for number, happening in enumerate(TOLD):
            log.heeded(number * 5, happening)
        log.ended(30)
    once, twice = [await replayed(open_log(path)) for _ in range(2)]
    assert len(once.rows) == 30
    assert all(np.array_equal(a.values, b.values) for a, b in zip(once.rows, twice.rows, strict=True))
    assert once.marks == twice.marks and once.utterances[-1].cut is not None
    assert {mark.kind for mark in once.marks} >= {"line", "word", "act", "breaks"}
