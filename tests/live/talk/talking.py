"""A run that programs talk to, in the test's own process and time: a script, a conversation, and what came of it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from facescript.compile import Settings
from facescript.live.clock import WallClock
from facescript.live.gate import Gate
from facescript.live.loop import Loop
from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.opening import open_play, prompter_of, waits
from facescript.live.ports import Ports
from facescript.live.run.run import Run
from facescript.live.show import Show
from facescript.live.sources.registry import open_source
from facescript.live.sources.setting import Setting
from facescript.live.talk.conversation import Conversation
from facescript.live.talk.prompting import Prompting
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

SCRIPT = """\
face ada = woman, voice en-us female
    life still
target lamp at 25deg 10deg 2m
when heard "no":
    show frown
when key "q":
    say "Wait."
"""


class Notes:
    """A sink that keeps what it was given."""

    def __init__(self) -> None:
        self.marks: list[Mark] = []
        self.utterances: list[Utterance] = []

    async def open(self, layout: Layout) -> None: ...

    def frame(self, frame: Frame) -> None: ...

    def mark(self, mark: Mark) -> None:
        self.marks.append(mark)

    def utter(self, utterance: Utterance) -> None:
        self.utterances.append(utterance)

    async def close(self) -> None: ...

    def counts(self) -> dict[str, int]:
        return {}


@asynccontextmanager
async def talked_to(address: str, script: str = SCRIPT) -> AsyncIterator[tuple[str, Notes, Gate]]:
    """A run with a source at an address; where that is, what came of it, and its gate. It has ten frames a second."""
    source, world, settings = Source("x.face", script), World(Path.cwd()), Settings()
    play, _ = open_play(source, world, settings)
    assert play is not None
    voice, clock, ports, notes = open_studio(world), WallClock(), Ports(), Notes()
    prompting = Prompting(lambda: prompter_of(source, world, settings), tuple(face.name for face in play.faces))
    gate = Gate(clock, 10.0, waits(play), lambda _: None)
    talk = Conversation(prompting, voice, 10.0)
    loop = Loop(Run(play, voice, 10.0, prompting), clock, gate, [notes, talk])
    said: list[str] = []
    show = Show(loop, gate, {}, ports)
    setting = Setting(play, world, clock, ports, "", said.append, dict, talk)
    show.sources = {address: open_source(address, setting)}
    running = asyncio.create_task(show.run(60.0, said.append))
    while not said:
        await asyncio.sleep(0.01)
    try:
        yield said[0], notes, gate
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        await talk.close()
