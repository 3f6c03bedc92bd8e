"""A run to datagrams: JSON, Open Sound Control and the VMC protocol at python-osc's server, Live Link at a decoder."""

from __future__ import annotations

import json
import socket
import struct
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import pytest
from pythonosc.dispatcher import Dispatcher
from pythonosc.osc_bundle_builder import IMMEDIATELY, OscBundleBuilder
from pythonosc.osc_message_builder import OscMessageBuilder
from pythonosc.osc_server import BlockingOSCUDPServer
from streaming import ONSET, frame, layout, line, opened, smiling

from facescript.live.model import Mark
from facescript.live.sinks import datagrams
from facescript.live.sinks.bundles import Bundles, bundle, message

Heard = list[tuple[str, list[object]]]


@contextmanager
def listening() -> Iterator[tuple[int, Heard]]:
    """A server of python-osc: its port, and all that it hears."""
    heard: Heard = []
    hears = Dispatcher()
    hears.set_default_handler(lambda address, *values: heard.append((address, list(values))))
    with BlockingOSCUDPServer(("127.0.0.1", 0), hears) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            yield server.server_address[1], heard
        finally:
            server.shutdown()
            thread.join()


def all_of(heard: Heard, last: str) -> Heard:
    """What was heard, once `last` was."""
    waited = threading.Event()
    for _ in range(300):
        if any(address == last for address, _ in heard):
            return heard
        waited.wait(0.01)
    raise AssertionError(f"{last} never came")


async def test_a_channel_has_an_address() -> None:
    of = layout("ada", "eve")
    shown = smiling(50, of)
    with listening() as (port, heard):
        async with opened(f"osc://127.0.0.1:{port}", of) as sink:
            sink.frame(shown)
            sink.mark(ONSET)
        found = dict(all_of(heard, "/facescript/mark"))
    assert found.pop("/facescript/mark") == ["act", "show smile", 0.5, "ada", "onset"]
    assert found.pop("/facescript/time") == [pytest.approx(50 / 60)]
    assert set(found) == {f"/facescript/{name.replace('.', '/')}" for name in of.names}
    assert found["/facescript/ada/cheek/lower/left"] == [0.5]
    assert found["/facescript/eve/head/scale"] == [1.0]


async def test_the_path_stands_for_the_first_word() -> None:
    with listening() as (port, heard):
        async with opened(f"osc://127.0.0.1:{port}/show/1", layout()) as sink:
            sink.frame(smiling(1, layout()))
        assert dict(all_of(heard, "/show/1/head/yaw"))["/show/1/head/yaw"] == [pytest.approx(0.1)]


def test_the_bytes_are_those_of_another_encoder() -> None:
    forms = [(message("/ä/b", "naïve", 3, 0.0, 0.0), 2), (message("/c", "four"), 0), (message("/d", 0.0), 1)]
    builder = OscBundleBuilder(IMMEDIATELY)
    for address, values in (("/ä/b", ["naïve", 3, 0.25, -1.5]), ("/c", ["four"]), ("/d", [7.0])):
        one = OscMessageBuilder(address)
        for value in values:
            one.add_arg(value)
        builder.add_content(one.build())
    assert Bundles(forms).packets(np.array([0.25, -1.5, 7.0])) == [builder.build().dgram]


async def test_no_datagram_is_cut_on_its_way() -> None:
    of = layout(*(f"face{number}" for number in range(20)))
    for address, size in (("osc", 1400), ("udp-json", 1400)):
        for packet in await packets(f"{address}://127.0.0.1:{{}}", smiling(5, of), of):
            assert len(packet) <= size


async def packets(address: str, shown: object, of: object, *marks: Mark) -> list[bytes]:
    """What a plain socket gets of a frame and some marks."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(0.2)
        async with opened(address.format(receiver.getsockname()[1]), of) as sink:  # type: ignore[arg-type]
            sink.frame(shown)  # type: ignore[arg-type]
            for mark in marks:
                sink.mark(mark)
            sink.utter(line())
            return [receiver.recv(70_000) for _ in range(sink.counts()["sent"])]


async def test_json_says_values_by_name() -> None:
    of = layout("ada", "eve")
    found = [json.loads(packet) for packet in await packets("udp-json://127.0.0.1:{}", smiling(50, of), of, ONSET)]
    frames = [one for one in found if one["type"] == "frame"]
    assert len(frames) > 1 and {one["number"] for one in frames} == {50}
    values = {name: value for one in frames for name, value in one["values"].items()}
    assert list(values) == list(of.names)
    assert (values["ada.cheek.lower.left"], values["ada.head.yaw"]) == (0.5, 5.0)
    assert [(one["type"], one["text"]) for one in found[-2:]] == [("mark", "show smile"), ("utterance", "Hello.")]


async def test_texts_that_are_too_long_are_cut() -> None:
    long = Mark("line", 0.0, "ß" * 30_000)
    mark = (await packets("osc://127.0.0.1:{}", smiling(1, layout()), layout(), long))[-1]
    assert len(mark) < 1000 and "ß".encode() * 300 in mark


async def test_nobody_need_be_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(datagrams, "PATIENCE", 0.05)
    of = layout()
    async with opened("osc://127.0.0.1:9", of) as sink:
        for number in range(50):
            sink.frame(smiling(number, of))
        assert sum(sink.counts().values()) == 100
    async with opened("osc://nowhere.invalid:9", of) as sink:
        sink.frame(smiling(1, of))
        assert sink.counts() == {"sent": 0, "dropped": 2}


def test_a_bundle_is_laid_out_once() -> None:
    assert bundle(message("/a"))[:16] == b"#bundle\0" + bytes(7) + b"\x01"


# VMC


async def posed(names: str = "", face: str = "ada", **values: float) -> Heard:
    """What a receiver of VMC gets of a pose of ada."""
    of = layout("ada", "eve")
    shown = frame(30, of, **{f"{face}_{name}": value for name, value in values.items()})
    with listening() as (port, heard):
        async with opened(f"vmc://127.0.0.1:{port}?face={face}{names}", of) as sink:
            sink.frame(shown)
        return all_of(heard, "/VMC/Ext/Blend/Apply")


def blends(heard: Heard) -> dict[object, object]:
    return {values[0]: values[1] for address, values in heard if address == "/VMC/Ext/Blend/Val"}


async def test_an_avatar_smiles_as_the_face_does() -> None:
    smiles = [blends(await posed(cheek_lower_left=degree, cheek_lower_right=degree)) for degree in (0.0, 0.4, 0.8)]
    joys = [float(str(one["Joy"])) for one in smiles]
    assert joys[0] == pytest.approx(0.0, abs=1e-6) and joys[0] < joys[1] < joys[2] <= 1.0
    assert {"Joy", "Angry", "Sorrow", "Fun", "A", "I", "U", "E", "O", "Blink_L", "Blink_R"} <= set(smiles[0])


async def test_a_wink_is_on_its_own_side() -> None:
    assert blends(await posed(lid_left=1.0))["Blink_L"] == pytest.approx(1.0, abs=0.02)
    found = blends(await posed("&names=vrm1", face="eve", lid_right=1.0))
    assert found["blinkRight"] == pytest.approx(1.0, abs=0.02)
    assert "Blink_R" not in found


async def test_a_frame_has_all_that_the_protocol_asks_for() -> None:
    addresses = [address.removeprefix("/VMC/Ext/") for address, _ in await posed()]
    assert addresses[:6] == ["OK", "T", "Root/Pos", "Bone/Pos", "Bone/Pos", "Bone/Pos"]
    assert set(addresses[6:-1]) == {"Blend/Val"} and addresses[-1] == "Blend/Apply"
    heard = dict(await posed())
    assert (heard["/VMC/Ext/OK"], heard["/VMC/Ext/T"]) == ([1], [0.5])


FORWARD, UP, LEFT = (0, 0, 1), (0, 1, 0), (-1, 0, 0)
"""In Unity: out of the face, up, and to the avatar's left."""


@pytest.mark.parametrize(
    ("bone", "turned", "of", "to"),
    [
        ("Head", {"head_yaw": 90.0}, FORWARD, LEFT),  # to the viewer's right
        ("Head", {"head_pitch": 90.0}, FORWARD, UP),
        ("Head", {"head_roll": 90.0}, UP, LEFT),  # clockwise for the viewer
        ("LeftEye", {"eye_left_yaw": 90.0}, FORWARD, LEFT),
        ("RightEye", {"eye_right_pitch": 90.0}, FORWARD, UP),
        (
            "Head",
            {"head_pitch": 90.0, "head_yaw": 90.0},
            UP,
            (1, 0, 0),
        ),  # pitch is first
    ],
)
async def test_bones_turn_as_the_face_does(bone: str, turned: dict[str, float], of: object, to: object) -> None:
    bones = {values[0]: values[1:] for address, values in await posed(**turned) if address == "/VMC/Ext/Bone/Pos"}
    assert bones[bone][:3] == [0.0, 0.0, 0.0]
    assert rotated(np.array(bones[bone][3:], dtype=float), np.array(of)) == pytest.approx(to, abs=1e-6)


def rotated(quaternion: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """A vector turned by a quaternion (x, y, z, w), as Unity turns it."""
    axis, w = quaternion[:3], quaternion[3]
    return vector + 2 * np.cross(axis, np.cross(axis, vector) + w * vector)


# Live Link


ORDER = (
    "EyeBlinkLeft EyeLookDownLeft EyeLookInLeft EyeLookOutLeft EyeLookUpLeft EyeSquintLeft EyeWideLeft EyeBlinkRight "
    "EyeLookDownRight EyeLookInRight EyeLookOutRight EyeLookUpRight EyeSquintRight EyeWideRight JawForward JawLeft "
    "JawRight JawOpen MouthClose MouthFunnel MouthPucker MouthLeft MouthRight MouthSmileLeft MouthSmileRight "
    "MouthFrownLeft MouthFrownRight MouthDimpleLeft MouthDimpleRight MouthStretchLeft MouthStretchRight MouthRollLower "
    "MouthRollUpper MouthShrugLower MouthShrugUpper MouthPressLeft MouthPressRight MouthLowerDownLeft "
    "MouthLowerDownRight MouthUpperUpLeft MouthUpperUpRight BrowDownLeft BrowDownRight BrowInnerUp BrowOuterUpLeft "
    "BrowOuterUpRight CheekPuff CheekSquintLeft CheekSquintRight NoseSneerLeft NoseSneerRight TongueOut HeadYaw "
    "HeadPitch HeadRoll LeftEyeYaw LeftEyePitch LeftEyeRoll RightEyeYaw RightEyePitch RightEyeRoll"
).split()
"""Of the numbers in a packet, as Unreal's plug-in reads them."""


@dataclass
class Packet:
    """A packet of Live Link Face, taken apart by its published layout."""

    version: int
    device: str
    subject: str
    number: int
    part: float
    rate: tuple[int, int]
    shapes: dict[str, float]


def taken_apart(data: bytes) -> Packet:
    (version,), device = struct.unpack("<I", data[:4]), data[4:41].decode("ascii")
    (length,) = struct.unpack(">i", data[41:45])
    subject, rest = data[45 : 45 + length].decode(), data[45 + length :]
    number, part, fps, parts, count = struct.unpack(">IfIIB", rest[:17])
    values = struct.unpack(f">{count}f", rest[17:])
    return Packet(version, device, subject, number, part, (fps, parts), dict(zip(ORDER, values, strict=True)))


async def linked(number: int, faces: tuple[str, ...] = ("ada",), options: str = "", fps: float = 60.0) -> list[Packet]:
    of = layout(*faces, fps=fps)
    return [taken_apart(one) for one in await packets("livelink://127.0.0.1:{}" + options, smiling(number, of), of)]


async def test_a_smile_is_a_ramp_in_live_link() -> None:
    found = [(await linked(number))[0] for number in (0, 25, 50, 75)]
    assert [one.shapes["MouthSmileLeft"] for one in found] == pytest.approx([0, 0.25, 0.5, 0.75])
    assert [one.shapes["MouthSmileRight"] for one in found] == pytest.approx([0, 0.125, 0.25, 0.375])
    assert [abs(one.shapes["HeadYaw"]) for one in found] == pytest.approx(np.radians([0, 2.5, 5, 7.5]))
    assert [one.number for one in found] == [0, 25, 50, 75]
    assert found[3].shapes["JawOpen"] == found[3].shapes["EyeBlinkLeft"] == 0.0


async def test_the_head_of_a_packet() -> None:
    first, second = await linked(3, ("ada", "eve"), fps=30_000 / 1001)
    assert (first.version, first.subject, second.subject, first.rate) == (6, "ada", "eve", (30_000, 1001))
    assert first.device[0] == "$" and len(first.device) == 37 and first.device != second.device
    (again,) = await linked(9, ("ada", "eve"), "?face=ada")
    assert (again.device, again.rate) == (first.device, (60, 1))
