"""The engine of a run: from an event to the frame that shows it, what frames and events cost, and an hour of them."""

from __future__ import annotations

import gc
import resource
import statistics
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random

import numpy as np
from row import Row

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Play
from facescript.live.model import Happening
from facescript.live.run.run import Run
from facescript.resolve.resolver import resolve
from facescript.speech.studio import open_studio
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[2]

FPS = 60.0

HOUR = 3600
"""Seconds on the simulated clock."""

SMILE = 'face mia = woman\n    life still\nwait 1s\nwhen touched "start":\n    show smile\n'

EVENTS = (("touched", "start"), ("heard", "no"), ("key", "q"), ("touched", "Who is there?"))
"""What happens to the kiosk, once a second."""

HEAD, GAZE = ("head.yaw", "head.pitch", "head.roll"), ("gaze.yaw", "gaze.pitch")


def play_of(source: Source) -> Play:
    told = Diagnostics()
    play = resolve(parse(source, told), World(ROOT), told)
    assert play is not None, [item.message for item in told]
    return play


def kiosk() -> Run:
    return Run(play_of(World(ROOT).source("examples/kiosk.face")), open_studio(World(ROOT)), FPS)


def rows() -> Iterator[Row]:
    yield _differs()
    yield from _costs()
    yield from _hour()


def _differs() -> Row:
    """How many frames after its event a smile is seen, by the first value that is not as it is without it."""
    play, voice, chance = play_of(Source("smile.face", SMILE)), open_studio(World(ROOT)), Random(1)
    still = Run(play, voice, FPS).frame(0).values
    found = []
    for _ in range(300):
        run, at = Run(play, voice, FPS), chance.uniform(0.0, 1.5)
        run.hear(Happening("touched", at, "start"))
        number = int(at * FPS)
        while np.array_equal(run.frame(number).values, still):
            number += 1
        found.append(number - at * FPS)
    most = sorted(found)[int(len(found) * 0.99)]
    middle = statistics.median(found)
    return Row("event to the first frame that differs, at 60 fps", "p99 2 frames",
               f"p50 {middle:.1f}, p99 {most:.1f} frames", most <= 2.0)  # fmt: skip


def _costs() -> Iterator[Row]:
    """Processor time of frames, and of the frame after an event, for a minute with an event a second."""
    run, chance = kiosk(), Random(2)
    frames: list[float] = []
    heard: list[float] = []
    gc.collect()
    gc.freeze()
    for number in range(int(70 * FPS)):
        begun = time.process_time()
        at = number / FPS
        event = number % 60 == 23
        if event:
            run.hear(_any(chance, at))
        run.frame(number)
        if number >= 600:
            (heard if event else frames).append((time.process_time() - begun) * 1000.0)
        run.marks(at)
        run.utterances(at)
    mean = statistics.mean([*frames, *heard])
    yield Row("processor time of a frame, kiosk, an event a second", "1.5 ms", f"{mean:.2f} ms", mean <= 1.5)
    most = sorted(heard)[int(len(heard) * 0.99)]
    yield Row("from an event to the next frame, kiosk", "p99 12 ms",
              f"p50 {statistics.median(heard):.1f} ms, p99 {most:.1f} ms", most <= 12.0)  # fmt: skip


def _any(chance: Random, at: float) -> Happening:
    kind, text = chance.choice(EVENTS)
    return Happening(kind, at, text)


def _hour() -> Iterator[Row]:
    """An hour with an event a second: three frames a second, and in one second of thirty all of them."""
    run, chance = kiosk(), Random(3)
    minutes: list[float] = []
    sizes: list[float] = []
    fastest = {HEAD: 0.0, GAZE: 0.0}
    columns = {names: [run.layout.names.index(name) for name in names] for names in fastest}
    drift, before, begun = 0.0, run.frame(0), time.process_time()
    for second in range(HOUR):
        run.hear(_any(chance, second + chance.random()))
        for number in range(second * 60 + 1, second * 60 + 61, 1 if second % 30 == 0 else 20):
            frame = run.frame(number)
            drift = max(drift, abs(frame.time - number / FPS))
            for names, which in columns.items() if frame.number == before.number + 1 else ():
                way = float(np.abs(frame.values[which] - before.values[which]).max()) * FPS
                fastest[names] = max(fastest[names], way)
            before = frame
            run.marks(frame.time)
            run.utterances(frame.time)
        if second % 60 == 59:
            minutes.append(time.process_time() - begun)
            sizes.append(_resident())
            begun = time.process_time()
    first, last = statistics.median(minutes[:10]), statistics.median(minutes[-10:])
    yield Row("an hour, an event a second: processor time of a minute, of the first ten and the last ten",
              "no more than a tenth more", f"{first:.2f} s, {last:.2f} s", last <= 1.1 * first)  # fmt: skip
    grown = sizes[-1] - sizes[4]
    yield Row("an hour: memory from its fifth minute on", "does not grow", f"{grown:+.1f} MB", grown <= 4.0)
    yield Row("an hour: top speed of the head", "320 deg/s", f"{fastest[HEAD]:.0f} deg/s", fastest[HEAD] <= 320.0)
    yield Row("an hour: top speed of gaze", "750 deg/s", f"{fastest[GAZE]:.0f} deg/s", fastest[GAZE] <= 750.0)
    yield Row("an hour: drift against the clock", "1 ms", f"{drift * 1000.0:.3f} ms", drift <= 0.001)


def _resident() -> float:
    """MB of this process now, after what can be let go is."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 2**20
