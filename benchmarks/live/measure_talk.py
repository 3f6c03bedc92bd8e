"""A run that is told new sentences by a program, to how soon after the telling each begins to sound."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from row import Row

from facescript.compile import Settings
from facescript.ir.acts import Voice
from facescript.live.clock import WallClock
from facescript.live.gate import Gate
from facescript.live.loop import Loop
from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.opening import open_play, prompter_of, waits
from facescript.live.run.run import Run
from facescript.live.talk.conversation import Conversation
from facescript.live.talk.prompting import Prompting
from facescript.speech.espeak.engine import EspeakEngine
from facescript.speech.voices.kept import KeptVoice
from facescript.text import Source
from facescript.world import World

SCRIPT = Path("examples/idle.face")

FPS = 60.0

MOST = 0.150
"""Seconds from the telling to the first sound."""

SENTENCES = 30

WORDS = "we have seen a long red boat come home over the bright water in that early summer morning".split()


class Fresh(EspeakEngine):
    """A voice of which nothing is kept beyond this program, so that every sentence is new to it."""

    def identity(self, voice: Voice) -> str:
        return ""


class Ears:
    """Notes when it was told of each line: a sink sounds it from then on, or later where it is to begin later."""

    def __init__(self, clock: WallClock) -> None:
        self._clock = clock
        self.begun: dict[str, float] = {}

    async def open(self, layout: Layout) -> None: ...

    def frame(self, frame: Frame) -> None: ...

    def mark(self, mark: Mark) -> None: ...

    def utter(self, utterance: Utterance) -> None:
        self.begun.setdefault(utterance.text, max(self._clock.now(), utterance.start))

    async def close(self) -> None: ...

    def counts(self) -> dict[str, int]:
        return {}


def rows() -> Iterator[Row]:
    for words in (4, 12):
        late = asyncio.run(_told(words))
        p50, p95 = np.percentile(late, (50, 95)) * 1000
        found = f"median {p50:.0f} ms, p95 {p95:.0f} ms, of {len(late)}"
        what = f"a new sentence of {words} words is told, to its first sound"
        yield Row(what, f"{MOST * 1000:.0f} ms", found, bool(p95 <= MOST * 1000))


async def _told(words: int) -> list[float]:
    """Seconds from telling to sounding, of sentences that no voice has spoken before, each told into silence."""
    source, world, settings = Source(SCRIPT.name, SCRIPT.read_text("utf-8")), World(SCRIPT.parent), Settings()
    play, _ = open_play(source, world, settings)
    assert play is not None
    voice, clock = KeptVoice(Fresh()), WallClock()
    prompting = Prompting(lambda: prompter_of(source, world, settings), ("miko",))
    gate = Gate(clock, FPS, waits(play), print)
    talk, ears = Conversation(prompting, voice, FPS), Ears(clock)
    assert prompting.prompter.play is not None
    loop = Loop(Run(play, voice, FPS, prompting), clock, gate, [ears, talk])
    tasks = [asyncio.create_task(loop.play()), asyncio.create_task(talk.run(gate))]
    found = []
    for number in range(SENTENCES):
        await asyncio.sleep(0.35 + 0.01 * number)
        text = " ".join(WORDS[(number * 5 + step) % len(WORDS)] for step in range(words)) + f" {number}."
        told, over = clock.now(), asyncio.Event()
        talk.tell(f'say "{text}"', lambda event, over=over: over.set() if "begun" in event else None)
        await over.wait()
        found.append(ears.begun[text] - told)
        talk.interrupt()
        await asyncio.sleep(0.3)
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)
    await talk.close()
    return found
