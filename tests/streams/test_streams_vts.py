"""A run to VTube Studio: a server that answers as its documentation says."""

from __future__ import annotations

import asyncio
import json
import os
import stat
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
from streaming import Told, frame, layout, opened, smiling
from websockets.asyncio.server import Server, ServerConnection, serve

from facescript.live.model import Sink
from facescript.live.sinks import counting, vts
from facescript.live.sinks.vts_parameters import NAMES

KNOWN = (
    "FacePositionX FacePositionY FacePositionZ FaceAngleX FaceAngleY FaceAngleZ MouthSmile MouthOpen Brows TongueOut "
    "EyeOpenLeft EyeOpenRight EyeLeftX EyeLeftY EyeRightX EyeRightY CheekPuff FaceAngry BrowLeftY BrowRightY MouthX"
).split()
"""The parameters that its tracking makes, as its manual lists them."""


class Studio:
    """A VTube Studio: whom it has let in, what it was given."""

    def __init__(self, allows: bool = True) -> None:
        self.allows, self.tokens = allows, set[str]()
        self.asked: list[str] = []
        self.given: list[dict[str, Any]] = []

    async def start(self, port: int = 0) -> int:
        self._server: Server = await serve(self._attend, "127.0.0.1", port, compression=None)
        return int(next(iter(self._server.sockets)).getsockname()[1])

    async def stop(self) -> None:
        self._server.close()
        await self._server.wait_closed()

    async def _attend(self, peer: ServerConnection) -> None:
        inside = False
        async for text in peer:
            request = json.loads(text)
            assert (request["apiName"], request["apiVersion"]) == ("VTubeStudioPublicAPI", "1.0")
            kind, data = request["messageType"], request["data"]
            self.asked.append(kind)
            if kind == "AuthenticationRequest":
                inside = data["authenticationToken"] in self.tokens
                answer = {"authenticated": inside, "reason": ""}
            elif kind == "AuthenticationTokenRequest":
                assert all(3 <= len(data[name]) <= 32 for name in ("pluginName", "pluginDeveloper"))
                token = f"token-{len(self.tokens)}"
                self.tokens |= {token} if self.allows else set()
                answer = {"authenticationToken": token} if self.allows else _error(50, "User has denied API access.")
            elif not inside:
                answer = _error(8, "This plugin is not authenticated.")
            else:
                answer = self._inject(data)
            kind = "APIError" if "errorID" in answer else kind.replace("Request", "Response")
            head = {"apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "timestamp": 1_625_405_710_728}
            await peer.send(json.dumps({**head, "messageType": "Event", "requestID": "another", "data": {}}))
            await peer.send(
                json.dumps({**head, "messageType": kind, "requestID": request["requestID"], "data": answer})
            )

    def _inject(self, data: dict[str, Any]) -> dict[str, Any]:
        values = {one["id"]: one["value"] for one in data["parameterValues"]}
        if not set(values) <= set(KNOWN):
            return _error(453, "A parameter was not found.")
        assert data["mode"] == "set" and data["faceFound"] is True
        self.given.append(values)
        return {}


def _error(number: int, text: str) -> dict[str, Any]:
    return {"errorID": number, "message": text}


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(counting, "FIRST_PAUSE", 0.02)
    return tmp_path / "facescript" / "vts"


@pytest.fixture
async def studio() -> AsyncIterator[Studio]:
    found = Studio()
    found.port = await found.start()  # type: ignore[attr-defined]
    yield found
    await found.stop()


def at(studio: Studio) -> str:
    return f"vts://127.0.0.1:{studio.port}"  # type: ignore[attr-defined]


async def run(sink: Sink, studio: Studio, frames: int = 3) -> None:
    """Shows frames until so many more have arrived."""
    wanted = len(studio.given) + frames
    async with asyncio.timeout(5):
        for number in range(10_000):
            sink.frame(smiling(number, layout()))
            await asyncio.sleep(0.003)
            if len(studio.given) >= wanted:
                return


async def test_it_is_let_in_once_for_all_runs(studio: Studio, cache: Path) -> None:
    told = Told()
    for _ in range(2):
        async with opened(at(studio), layout(), told.setting()) as sink:
            await run(sink, studio)
    assert told.texts == ["Allow FaceScript in the window of VTube Studio."]
    kinds = [kind for kind in studio.asked if kind != "InjectParameterDataRequest"]
    assert kinds == ["AuthenticationTokenRequest", "AuthenticationRequest", "AuthenticationRequest"]
    (kept,) = cache.iterdir()
    assert os.name != "posix" or stat.S_IMODE(kept.stat().st_mode) == 0o600


async def test_a_token_that_was_taken_back_is_asked_for_again(studio: Studio) -> None:
    for _ in range(2):
        async with opened(at(studio), layout()) as sink:
            await run(sink, studio, 1)
        studio.tokens.clear()
    assert studio.asked.count("AuthenticationTokenRequest") == 2


async def test_who_is_not_let_in_does_not_ask_again() -> None:
    studio, told = Studio(allows=False), Told()
    port = await studio.start()
    async with opened(f"vts://127.0.0.1:{port}", layout(), told.setting()) as sink:
        async with asyncio.timeout(3):
            while len(told.texts) < 2:
                await asyncio.sleep(0.01)
        await asyncio.sleep(0.1)
        sink.frame(smiling(1, layout()))
    await studio.stop()
    assert studio.asked == ["AuthenticationTokenRequest"]
    assert told.texts[1] == "VTube Studio refuses: User has denied API access."


async def test_parameters_mean_what_the_face_does(studio: Studio) -> None:
    assert set(NAMES) <= set(KNOWN)
    of = layout("ada", "eve")
    values = {"head_yaw": 12.0, "head_pitch": -45.0, "lid_left": 1.0, "eye_left_yaw": 15.0, "mouth_open": 0.4}
    smile = {"cheek_lower_left": 1.0, "cheek_lower_right": 1.0}
    shown = frame(1, of, **{f"eve_{name}": value for name, value in (values | smile).items()})
    async with opened(f"{at(studio)}?face=eve", of) as sink:
        async with asyncio.timeout(3):
            while not studio.given:
                sink.frame(shown)
                await asyncio.sleep(0.005)
    found = studio.given[-1]
    assert (found["FaceAngleX"], found["FaceAngleY"], found["FaceAngleZ"]) == (12.0, -30, 0)
    assert (found["EyeOpenLeft"], found["EyeOpenRight"], found["EyeLeftX"], found["EyeRightX"]) == (0, 1, 0.5, 0)
    assert (found["MouthOpen"], found["MouthSmile"], found["Brows"]) == (0.4, 1.0, 0.5)


async def test_what_does_not_change_is_said_again(studio: Studio, monkeypatch: pytest.MonkeyPatch) -> None:
    assert vts.AGAIN < 1.0, "it lets go after a second"
    monkeypatch.setattr(vts, "AGAIN", 0.05)
    async with opened(at(studio), layout()) as sink:
        await run(sink, studio, 1)
        given = len(studio.given)
        await asyncio.sleep(0.3)
    assert len(studio.given) >= given + 3


async def test_it_waits_for_a_studio_and_comes_back_to_it(studio: Studio) -> None:
    told = Told()
    port = studio.port  # type: ignore[attr-defined]
    await studio.stop()
    async with opened(f"vts://127.0.0.1:{port}", layout(), told.setting()) as sink:
        for number in range(20):
            sink.frame(smiling(number, layout()))
            await asyncio.sleep(0.002)
        assert sink.counts()["sent"] == 0 and sink.counts()["dropped"] >= 19
        for _ in range(2):
            await studio.start(port)
            await run(sink, studio)
            await studio.stop()
        await studio.start(port)
    assert told.texts[0].startswith(f"VTube Studio is not at ws://127.0.0.1:{port} yet")
