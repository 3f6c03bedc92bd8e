"""A run to a broker of MQTT: a mosquitto on this machine, and who subscribes there."""

from __future__ import annotations

import asyncio
import json
import shutil
import socket
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from streaming import ONSET, Told, layout, line, opened, smiling

mqtt = pytest.importorskip("paho.mqtt.client")

BROKER = shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin:/usr/bin:/opt/homebrew/sbin")

pytestmark = pytest.mark.skipif(BROKER is None, reason="no mosquitto is here")


@pytest.fixture
def port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


@contextmanager
def broker(port: int, folder: Path) -> Iterator[None]:
    config = folder / "mosquitto.conf"
    config.write_text(f"listener {port} 127.0.0.1\nallow_anonymous true\n")
    process = subprocess.Popen([str(BROKER), "-c", str(config)], stderr=subprocess.DEVNULL)
    try:
        yield
    finally:
        process.terminate()
        process.wait()


class Subscriber:
    """One who hears all beneath a topic."""

    def __init__(self, port: int) -> None:
        self.heard: list[tuple[str, str, bool]] = []
        self._client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
        self._client.on_connect = lambda client, *_: client.subscribe("lab/ada/#", qos=1)
        self._client.on_message = lambda _, __, found: self.heard.append(
            (found.topic.removeprefix("lab/ada/"), found.payload.decode(), found.retain)
        )
        self._client.connect("127.0.0.1", port)
        self._client.loop_start()

    async def hears(self, topic: str, many: int = 1) -> list[str]:
        """What was said so often about a topic."""
        async with asyncio.timeout(5):
            while True:
                found = [text for about, text, _ in self.heard if about == topic]
                if len(found) >= many:
                    return found
                await asyncio.sleep(0.01)

    def leave(self) -> None:
        self._client.disconnect()
        self._client.loop_stop()


async def test_who_comes_late_has_the_layout_and_hears_the_end(port: int, tmp_path: Path) -> None:
    of = layout()
    with broker(port, tmp_path):
        async with opened(f"mqtt://127.0.0.1:{port}/lab/ada", of) as sink:
            await _online(sink)
            late = Subscriber(port)
            (told,) = await late.hears("layout")
            assert (await late.hears("state"))[-1] == "online"
            for number in range(60):
                sink.frame(smiling(number, of))
            sink.mark(ONSET)
            sink.utter(line())
            frames = [json.loads(text) for text in await late.hears("frame", 10)]
            assert json.loads((await late.hears("mark"))[0])["label"] == "onset"
            assert json.loads((await late.hears("utterance"))[0])["text"] == "Hello."
        assert (await late.hears("state", 2))[-1] == "offline"
        late.leave()
    assert [channel["name"] for channel in json.loads(told)["channels"]] == list(of.names)
    assert [one["number"] for one in frames] == list(range(0, 60, 6)), "ten a second, where no more are asked for"
    assert frames[-1]["values"]["cheek.lower.left"] == 0.54
    assert {about: kept for about, _, kept in late.heard}["layout"], "the broker keeps it"


async def _online(sink: object) -> None:
    async with asyncio.timeout(5):
        while not sink._client.is_connected():  # type: ignore[attr-defined]
            await asyncio.sleep(0.01)
    await asyncio.sleep(0.05)


async def test_a_broker_may_come_later(port: int, tmp_path: Path) -> None:
    of, told = layout(), Told()
    with ExitStack() as later:
        async with opened(f"mqtt://127.0.0.1:{port}/lab/ada?rate=60", of, told.setting()) as sink:
            for number in range(5):
                sink.frame(smiling(number, of))
            sink.mark(ONSET)
            await asyncio.sleep(0.1)
            assert sink.counts() == {"sent": 1, "dropped": 5}
            later.enter_context(broker(port, tmp_path))
            await _online(sink)
            listener = Subscriber(port)
            await listener.hears("state")
            sink.frame(smiling(6, of))
            assert json.loads((await listener.hears("frame"))[0])["number"] == 6
            listener.leave()
    assert told.texts == [f"No broker is at 127.0.0.1:{port} yet; it is tried again."]
