"""Recordings, microphones and lines of text to events: what is heard, what is refused, what is tried again."""

from __future__ import annotations

import asyncio
import wave
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import numpy as np
import pytest

from facescript.compile import Settings
from facescript.ir.acts import Say, Voice
from facescript.live.address import AddressFault
from facescript.live.clock import WallClock
from facescript.live.model import Happening, Sighting
from facescript.live.opening import open_play
from facescript.live.ports import Ports
from facescript.live.sources.registry import open_source
from facescript.live.sources.setting import Setting
from facescript.speech.espeak.voicebox import process_voice
from facescript.text import Source
from facescript.world import World

SCRIPT = 'face ada = woman, voice {voice}\nnod\nwhen heard "thank you":\n    nod\nwhen heard "no":\n    nod\n'


class Ears:
    def __init__(self) -> None:
        self.told: list[Happening] = []

    def event(self, happening: Happening) -> None:
        self.told.append(happening)

    def sighting(self, sighting: Sighting) -> None:
        raise AssertionError(sighting)


def setting(root: Path, said: list[str], voice: str = "en-us", script: str = SCRIPT) -> Setting:
    play, _ = open_play(Source("x.face", script.format(voice=voice)), World(root), Settings())
    assert play is not None
    clock = WallClock()
    clock.begin()
    return Setting(play, World(root), clock, Ports(), "", said.append, dict)


@asynccontextmanager
async def told_by(address: str, about: Setting, seconds: float, count: int) -> AsyncIterator[Ears]:
    """What a source tells within some seconds, or until it has told so much."""
    ears, source = Ears(), open_source(address, about)
    task = asyncio.create_task(source.run(ears))
    end = about.clock.now() + seconds
    while len(ears.told) < count and about.clock.now() < end:
        await asyncio.sleep(0.02)
    try:
        yield ears
    finally:
        task.cancel()
        await asyncio.gather(task, return_exceptions=True)


def record(path: Path, *texts: str) -> None:
    """A recording of sentences, half a second apart."""
    pytest.importorskip("espeakng_loader")
    pieces = []
    for text in texts:
        spoken = process_voice().speak(Say(text, Voice("en-us", "m3")))
        pieces += [np.zeros(spoken.rate // 2, "<i2"), np.frombuffer(spoken.pcm, "<i2")]
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(spoken.rate)
        file.writeframes(np.concatenate(pieces).tobytes())


async def test_a_phrase_of_a_recording_is_an_event(tmp_path: Path) -> None:
    pytest.importorskip("pocketsphinx", reason="the extra `english` is not installed")
    record(tmp_path / "visit.wav", "Thank you.", "It is raining again.")
    about = setting(tmp_path, [])
    async with told_by("wav:visit.wav", about, 20.0, 1) as ears:
        assert [(one.kind, one.text) for one in ears.told] == [("heard", "thank you")]


@pytest.mark.parametrize(
    ("address", "script", "voice", "code"),
    [
        ("wav:none.wav", SCRIPT, "en-us", "FS971"),
        ("wav:../x.wav", SCRIPT, "en-us", "FS971"),
        ("wav:x.txt", SCRIPT, "en-us", "FS971"),
        ("wav:x.wav", SCRIPT, "de", "FS994"),
        ("wav:x.wav", "nod\n", "en-us", "FS994"),
        ("wav:x.wav?least=2", SCRIPT, "en-us", "FS981"),
        ("wav:x.wav?loud=1", SCRIPT, "en-us", "FS981"),
        ("text:none.txt", SCRIPT, "en-us", "FS971"),
        ("text:..", SCRIPT, "en-us", "FS971"),
    ],
)
def test_what_cannot_be_heard_is_refused(tmp_path: Path, address: str, script: str, voice: str, code: str) -> None:
    pytest.importorskip("pocketsphinx", reason="the extra `english` is not installed")
    record(tmp_path / "x.wav", "No.")
    (tmp_path / "x.txt").write_text("no\n")
    with pytest.raises(AddressFault) as refused:
        open_source(address, setting(tmp_path, [], voice, script))
    assert refused.value.code == code


async def test_lines_of_a_file_are_heard_as_they_are_written(tmp_path: Path) -> None:
    path, said = tmp_path / "visit.txt", list[str]()
    path.write_bytes(b"Thank you!\n\n" + b"x" * 10_000 + "\n谢谢\nun".encode())
    about = setting(tmp_path, said, "cmn")
    async with told_by("text:visit.txt", about, 5.0, 2) as ears:
        assert [one.text for one in ears.told] == ["Thank you!", "谢谢"]
        with path.open("a") as file:
            file.write("finished\n")
        for _ in range(100):
            await asyncio.sleep(0.02)
            if len(ears.told) == 3:
                break
        assert ears.told[-1] == Happening("heard", 0.0, "unfinished")


async def test_a_microphone_that_is_not_there_is_told_of_once(tmp_path: Path) -> None:
    pytest.importorskip("pocketsphinx", reason="the extra `english` is not installed")
    try:
        import sounddevice
    except (ImportError, OSError):
        pytest.skip("the extra `microphone` is not installed")
    if any(device["max_input_channels"] for device in sounddevice.query_devices()):
        pytest.skip("there is a microphone here")
    said: list[str] = []
    async with told_by("microphone:", setting(tmp_path, said), 2.6, 1):
        assert len(said) == 1 and "looked for again" in said[0]
