"""The loop: frames at their times, late ones dropped, all counted; a log replays to the same."""

from __future__ import annotations

import asyncio
import io
import time
from pathlib import Path

import pytest
from acting import Actor, Audience

from facescript.ir.values import Point
from facescript.live.clock import SimulatedClock, WallClock
from facescript.live.gate import Gate
from facescript.live.log import Head, Log, LogFault, Replay, open_log
from facescript.live.loop import Loop
from facescript.live.model import Happening, Sighting
from facescript.live.onsets import Onsets

HEAD = Head("kiosk.face", "0" * 64, 5, 60.0, "1.0.0", 0.0, {"beat": "400ms"})


def gate(clock: SimulatedClock | WallClock, fps: float = 60.0) -> Gate:
    return Gate(clock, fps, lambda happening: True, lambda text: None)


async def test_on_a_simulated_clock_every_frame_is_given() -> None:
    clock, actor, audience = SimulatedClock(), Actor(), Audience()
    loop = Loop(actor, clock, gate(clock), [audience])
    await loop.play(10.0)
    assert actor.numbers == list(range(600)) and len(audience.frames) == 600
    assert (loop.tally.frames, loop.tally.late, loop.tally.dropped) == (600, 0, 0)


async def test_deadlines_are_those_of_the_beginning() -> None:
    clock, actor = WallClock(), Actor(100.0)
    loop = Loop(actor, clock, gate(clock, 100.0), [])
    await loop.play(0.5)
    assert loop.tally.frames + loop.tally.dropped == 50
    assert 0.49 <= clock.now() < 1.0


async def test_a_late_frame_is_dropped_and_the_newest_given() -> None:
    class Slow(Actor):
        def frame(self, number: int):
            if number == 3:
                time.sleep(0.1)
            return super().frame(number)

    clock, actor, audience = WallClock(), Slow(100.0), Audience()
    loop = Loop(actor, clock, gate(clock, 100.0), [audience])
    await loop.play(0.3)
    after = actor.numbers[actor.numbers.index(3) + 1]
    assert after >= 12 and loop.tally.dropped >= 8 and loop.tally.late >= 1
    assert loop.tally.frames + loop.tally.dropped == 30


async def test_it_ends_between_two_frames() -> None:
    clock, actor, audience = WallClock(), Actor(), Audience()
    loop = Loop(actor, clock, gate(clock), [audience])
    playing = asyncio.create_task(loop.play())
    await asyncio.sleep(0.1)
    playing.cancel()
    await asyncio.gather(playing, return_exceptions=True)
    assert actor.numbers[-1] == audience.frames[-1].number == loop.next - 1


async def logged(actor: Actor, audience: Audience, out: io.StringIO) -> None:
    """A run with events, sightings and frames that were dropped, and its log."""
    clock = SimulatedClock()
    door = gate(clock)
    log = Log(out, HEAD)
    loop = Loop(actor, clock, door, [audience], [log])
    playing = asyncio.create_task(loop.play(2.0))
    door.event(Happening("heard", 0.0, "no"))
    for number in range(30):
        await asyncio.sleep(0)
        door.sighting(Sighting("ann", 0.0, Point(number / 3, 0.1, 80.0)))
        door.event(Happening("key", clock.now() + number / 70, "q"))
    clock._now += 0.2  # a stall
    door.event(Happening("arrives", 0.0, person="ann"))
    await playing
    loop.close()
    assert loop.tally.dropped > 5


async def test_a_log_replays_to_the_same(tmp_path: Path) -> None:
    actor, audience, out = Actor(), Audience(), io.StringIO()
    await logged(actor, audience, out)
    path = tmp_path / "run.log"
    path.write_text(out.getvalue(), "utf-8")
    recorded = open_log(path)
    assert recorded.head == HEAD and recorded.end == 120
    again, listeners, second = Actor(), Audience(), io.StringIO()
    clock = SimulatedClock()
    loop = Loop(again, clock, Replay(recorded), [listeners], [Log(second, HEAD)])
    await loop.play()
    loop.close()
    assert again.heeded == actor.heeded and len(actor.heeded) > 30
    assert again.numbers == actor.numbers and listeners.marks == audience.marks
    assert second.getvalue() == out.getvalue()


@pytest.mark.parametrize(
    ("cut", "said"),
    [
        ("", "does not begin as one"),
        ('{"log": 2}\n', "does not begin as one"),
        ('{"log": 1}\n', "first line"),
        ("HEAD{}\n", "no frame"),
        ('HEAD{"frame": 2, "heard": ""}\n', "line 2"),
        ('HEAD{"frame": 2, "open": "/etc/passwd"}\n', "line 2"),
        ('HEAD{"frame": 9, "heard": "no"}\n{"frame": 2, "heard": "no"}\n', "behind"),
        ("HEAD[]\n", "line 2 is not JSON"),
        (f'HEAD{{"frame": 1, "heard": "{"x" * 100_000}"}}\n', "too long"),
    ],
)
def test_what_is_no_log_is_told(cut: str, said: str, tmp_path: Path) -> None:
    out = io.StringIO()
    Log(out, HEAD)
    path = tmp_path / "run.log"
    path.write_text(cut.replace("HEAD", out.getvalue()), "utf-8")
    with pytest.raises(LogFault, match=said):
        open_log(path)


def test_a_log_that_was_cut_off_is_one(tmp_path: Path) -> None:
    out = io.StringIO()
    log = Log(out, HEAD)
    log.heeded(7, Happening("heard", 0.1, "no"))
    log.heeded(9, Happening("heard", 0.15, "no"))
    path = tmp_path / "run.log"
    path.write_text(out.getvalue()[:-8], "utf-8")
    assert open_log(path).end == 8


async def test_onsets_have_the_plan_and_what_became_of_it() -> None:
    clock, out = SimulatedClock(), io.StringIO()
    door = gate(clock)
    loop = Loop(Actor(), clock, door, [], [Onsets(out)])
    door.event(Happening("key", 0.11, "q"))
    await loop.play(1.0)
    header, row = out.getvalue().splitlines()
    assert header == "kind,label,face,text,planned,frame,real"
    assert row == "event,,,key,0.110000,0.116667,0.116667"
