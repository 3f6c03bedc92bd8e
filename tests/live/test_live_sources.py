"""Sources: real clients tell events over WebSocket, HTTP and OSC; strangers, liars and nonsense are refused."""

from __future__ import annotations

import asyncio
import json
import shutil
import socket
import subprocess
import time
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager, suppress
from http.client import HTTPConnection
from pathlib import Path

import pytest
from acting import Ears
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from facescript.compile import Settings
from facescript.ir.values import Point
from facescript.live.address import AddressFault
from facescript.live.clock import WallClock
from facescript.live.messages import LARGEST
from facescript.live.model import Happening, Sighting, Source
from facescript.live.opening import open_play
from facescript.live.ports import Ports
from facescript.live.sources.registry import SOURCES, open_source
from facescript.live.sources.setting import Setting
from facescript.text import Source as Script
from facescript.world import World

SCRIPT = 'when heard "no":\n    nod\nwhen heard "Yes, please.":\n    nod\nwhen key "q":\n    nod\n'


@pytest.fixture
def loopback_lsl(monkeypatch: pytest.MonkeyPatch) -> None:
    """LSL that speaks to this machine alone; the library reads its settings once."""
    pytest.importorskip("pylsl")
    monkeypatch.setenv("LSLAPICFG", str(Path(__file__).parents[1] / "streams" / "lsl_api.cfg"))


class Listening:
    """Sources at addresses that tell `ears`; `port` is where the first of them listens, `said` what they say of
    themselves."""

    def __init__(self, token: str = "") -> None:
        play, _ = open_play(Script("x.face", SCRIPT), World(Path.cwd()), Settings())
        assert play is not None
        self.ears, self.said, self.port = Ears(), list[str](), 0
        self.clock, self.ports = WallClock(), Ports()
        self.setting = Setting(
            play, World(Path.cwd()), self.clock, self.ports, token, self.said.append, lambda: {"x": 1}
        )

    @asynccontextmanager
    async def at(self, *addresses: str) -> AsyncIterator[Listening]:
        sources = [open_source(address, self.setting) for address in addresses]
        self.counts = [source.counts for source in sources]
        self.said += await self.ports.open()
        self.clock.begin()
        tasks = [asyncio.create_task(source.run(self.ears)) for source in sources]
        await asyncio.sleep(0.02)
        self.port = int(self.said[0].rstrip(".").rpartition(":")[2].partition("/")[0])
        try:
            yield self
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            await self.ports.close()

    async def told(self, count: int) -> list[Happening | Sighting]:
        """What was told, once it is so much."""
        end = time.monotonic() + 5.0
        while len(self.ears.told) < count and time.monotonic() < end:
            await asyncio.sleep(0.005)
        return self.ears.told


def post(port: int, path: str, body: str = "", **headers: str) -> tuple[int, str]:
    """The status of an answer, and the answer."""
    client = HTTPConnection("127.0.0.1", port, timeout=5)
    client.request("POST", path, body.encode(), headers)
    answer = client.getresponse()
    return answer.status, answer.read().decode()


def get(port: int, path: str) -> tuple[int, str]:
    client = HTTPConnection("127.0.0.1", port, timeout=5)
    client.request("GET", path)
    answer = client.getresponse()
    return answer.status, answer.read().decode()


async def test_a_websocket_tells_and_is_told_what_is_refused() -> None:
    async with Listening().at("ws://127.0.0.1:0") as listening:
        async with connect(f"ws://127.0.0.1:{listening.port}/events") as client:
            for said in ("heard no", '{"sighting": "ann", "at": [1, 2, 3]}', "nonsense", '{"signal": "nobody"}'):
                await client.send(said)
            answers = [json.loads(await client.recv()) for _ in range(2)]
        assert "such as" in answers[0]["refused"] and answers[1] == {"refused": "no reaction waits for it"}
        assert listening.ears.told[:2] == [Happening("heard", 0.0, "no"), Sighting("ann", 0.0, Point(1, 2, 3))]
        assert listening.counts[0]() == {"messages": 4, "malformed": 1, "connections": 1}


async def test_a_websocket_that_sends_too_much_at_once_is_closed() -> None:
    async with Listening().at("ws://127.0.0.1:0") as listening:
        client = await connect(f"ws://127.0.0.1:{listening.port}/events")
        await client.send("x" * 40 * LARGEST)
        with pytest.raises(ConnectionClosed):
            await client.recv()


@pytest.mark.parametrize("headers", [{"Origin": "http://elsewhere.example"}, {"Origin": "null"}])
async def test_a_page_of_elsewhere_is_not_let_in(headers: dict[str, str]) -> None:
    async with Listening().at("ws://127.0.0.1:0/events", "http://127.0.0.1:0") as listening:
        with pytest.raises(InvalidStatus):
            await connect(f"ws://127.0.0.1:{listening.port}/events", additional_headers=headers)
        http = int(listening.said[1].rpartition(":")[2])
        assert (await asyncio.to_thread(post, http, "/heard", "no", **headers))[0] == 403
        assert (await asyncio.to_thread(post, http, "/heard", "no", Host="rebound.example"))[0] == 403
        assert listening.ears.told == []


async def test_http_posts_are_events() -> None:
    async with Listening().at("http://127.0.0.1:0") as listening:
        answers = [
            await asyncio.to_thread(post, listening.port, *asked)
            for asked in [
                ("/heard", "no"), ("/signal/closing%20time", ""), ("/event", '{"arrives": "ann", "at": [1, 2, 3]}'),
                ("/key", ""), ("/event", "{"), ("/open", "x"), ("/heard/%ff", ""), ("/heard", "x" * LARGEST + "x"),
                ("/signal", "nobody"),
            ]
        ]  # fmt: skip
        assert [status for status, _ in answers] == [202, 202, 202, 400, 400, 404, 400, 413, 400]
        assert "such as" in json.loads(answers[4][1])["refused"]
        assert [item.text for item in listening.ears.told if isinstance(item, Happening)] == [
            "no", "closing time", "", "nobody",
        ]  # fmt: skip
        assert await asyncio.to_thread(get, listening.port, "/status") == (200, '{\n  "x": 1\n}\n')
        assert (await asyncio.to_thread(get, listening.port, "/etc/passwd"))[0] == 404


@contextmanager
def raw(port: int, *pieces: bytes) -> Iterator[socket.socket]:
    """Bytes as they are."""
    with socket.create_connection(("127.0.0.1", port), timeout=5) as connection:
        for piece in pieces:
            connection.sendall(piece)
            time.sleep(0.02)
        yield connection


LIES = {
    b"POST /heard HTTP/1.1\r\nHost: HOST\r\n\r\nno": b"400",
    b"POST /heard HTTP/1.1\r\nHost: HOST\r\nContent-Length: 2\r\nContent-Length: 2\r\n\r\nno": b"400",
    b"POST /heard HTTP/1.1\r\nHost: HOST\r\nTransfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\nno": b"400",
    b"POST /heard HTTP/1.1\r\nHost: HOST\r\nHost: HOST\r\nContent-Length: 2\r\n\r\nno": b"403",
    b"POST /heard HTTP/1.1\r\nContent-Length: 2\r\n\r\nno": b"403",
    b"POST /heard HTTP/1.1\r\nHost: HOST\r\nContent-Length: 99999999\r\n\r\nno": b"413",
    b"POST /heard HTTP/1.1\r\n" + b"a: b\r\n" * 3000: b"400",
    b"POST heard\r\n\r\n": b"400",
    b"GET //[ HTTP/1.1\r\nHost: HOST\r\n\r\n": b"404",
    b"GET * HTTP/1.1\r\nHost: HOST\r\n\r\n": b"404",
}


@pytest.mark.parametrize("lie", LIES)
async def test_posts_that_lie_are_refused(lie: bytes) -> None:
    async with Listening().at("http://127.0.0.1:0") as listening:

        def ask() -> bytes:
            with raw(listening.port, lie.replace(b"HOST", b"127.0.0.1:%d" % listening.port)) as connection:
                return connection.recv(100)

        assert (await asyncio.to_thread(ask)).startswith(b"HTTP/1.1 " + LIES[lie])
        assert listening.ears.told == []


async def test_a_post_may_come_in_pieces() -> None:
    async with Listening().at("http://127.0.0.1:0") as listening:
        host = b"Host: 127.0.0.1:%d\r\n" % listening.port

        def ask() -> bytes:
            with raw(
                listening.port, b"PO", b"ST /heard HTTP/1.1\r\n" + host, b"Content-Length: 2\r\n\r", b"\nn", b"o"
            ) as peer:
                return peer.recv(100)

        assert (await asyncio.to_thread(ask)).startswith(b"HTTP/1.1 202")


async def test_with_a_token_only_who_knows_it_comes_in() -> None:
    async with Listening("open sesame").at("ws://127.0.0.1:0", "http://127.0.0.1:0", "osc://127.0.0.1:0") as listening:
        address = f"ws://127.0.0.1:{listening.port}/events"
        with pytest.raises(InvalidStatus):
            await connect(address)
        async with connect(f"{address}?token=open%20sesame", origin="http://elsewhere.example") as client:  # type: ignore[arg-type]
            await client.send("heard no")
            assert len(await listening.told(1)) == 1
        http = int(listening.said[1].rpartition(":")[2])
        for wrong in ("", "?token=%ff", "?token=open%20sesam", "?" + "token=x&" * 11):
            assert (await asyncio.to_thread(post, http, f"/heard{wrong}", "no"))[0] == 403
        odd = b"GET /status?" + b"token=x&" * 11 + b" HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer \xff\r\n\r\n"
        with raw(http, odd) as peer:
            assert (await asyncio.to_thread(peer.recv, 100)).startswith(b"HTTP/1.1 403")
        assert (await asyncio.to_thread(post, http, "/heard", "no", Authorization="Bearer open sesame"))[0] == 202


@pytest.mark.parametrize("scheme", ["ws", "http", "osc"])
@pytest.mark.parametrize("host", ["0.0.0.0", "192.168.1.7", "kiosk.local", "[::]"])
async def test_beyond_this_machine_there_must_be_a_token(scheme: str, host: str) -> None:
    with pytest.raises(AddressFault) as told:
        open_source(f"{scheme}://{host}:8080", Listening().setting)
    assert told.value.code == "FS983"


@pytest.mark.parametrize(
    "address", ["ws://", "ws://127.0.0.1", "stdin:x", "lsl://it's", "lsl://", "http://127.0.0.1:8080/x"]
)
def test_an_address_that_is_none_is_told(address: str) -> None:
    with pytest.raises(AddressFault) as told:
        open_source(address, Listening().setting)
    assert told.value.code == "FS981"


async def test_a_port_is_shared_and_one_that_is_taken_is_told() -> None:
    with socket.socket() as free:
        port = taken_by(free)
    both = f"ws://127.0.0.1:{port}", f"http://127.0.0.1:{port}"
    async with Listening().at(*both) as listening:
        udp = socket.socket(type=socket.SOCK_DGRAM)
        assert (await asyncio.to_thread(post, port, "/heard", "no"))[0] == 202
        async with connect(f"ws://127.0.0.1:{port}/events") as client:
            await client.send("heard no")
            assert len(await listening.told(2)) == 2
        for at in (f"ws://127.0.0.1:{port}", f"osc://127.0.0.1:{taken_by(udp)}"):
            other = Listening()
            source = open_source(at, other.setting)
            with pytest.raises(AddressFault, match="in use") as told:
                await begun(source, other)
            assert told.value.code == ("FS971" if at.startswith("osc") else "FS982")


def taken_by(other: socket.socket) -> int:
    """The port that another program has."""
    other.bind(("127.0.0.1", 0))
    return int(other.getsockname()[1])


async def begun(source: Source, listening: Listening) -> None:
    await listening.ports.open()
    await source.run(listening.ears)


async def test_osc_messages_are_events() -> None:
    osc = pytest.importorskip("pythonosc")
    from pythonosc.osc_bundle_builder import IMMEDIATELY, OscBundleBuilder
    from pythonosc.osc_message_builder import OscMessageBuilder
    from pythonosc.udp_client import UDPClient

    def message(address: str, *values: str | float):
        built = OscMessageBuilder(address)
        for value in values:
            built.add_arg(value)
        return built.build()

    assert osc
    async with Listening().at("osc://127.0.0.1:0") as listening:
        client = UDPClient("127.0.0.1", listening.port)
        client.send(message("/facescript/heard", "no"))
        client.send(message("/facescript/sighting", "ann", 1.0, 2.0, 3.0))
        for when in (IMMEDIATELY, time.time() + 0.5):
            bundle = OscBundleBuilder(when)
            bundle.add_content(message("/facescript/key", "q"))
            client.send(bundle.build())
        client.send(message("/elsewhere/heard", "no"))
        client.send(message("/facescript/heard", 3))
        found = await listening.told(4)
        assert found[:3] == [
            Happening("heard", 0.0, "no"), Sighting("ann", 0.0, Point(1, 2, 3)), Happening("key", 0.0, "q"),
        ]  # fmt: skip
        assert 0.3 < found[3].time - listening.clock.now() < 0.51
        await asyncio.sleep(0.05)
        assert len(listening.ears.told) == 4 and listening.counts[0]() == {"messages": 6, "malformed": 2}


@pytest.fixture
def broker(tmp_path: Path) -> Iterator[int]:
    """The port of an MQTT broker of its own."""
    pytest.importorskip("paho")
    program = shutil.which("mosquitto") or shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin")
    if program is None:
        pytest.skip("no broker is installed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (tmp_path / "broker.conf").write_text(f"listener {port} 127.0.0.1\nallow_anonymous true\n")
    process = subprocess.Popen([program, "-c", str(tmp_path / "broker.conf")], stderr=subprocess.DEVNULL)
    try:
        _listens(port)
        yield port
    finally:
        process.terminate()
        process.wait(timeout=10)


def _listens(port: int) -> None:
    """Waits until somebody listens at a port."""
    end = time.monotonic() + 20
    while time.monotonic() < end:
        with suppress(OSError), socket.create_connection(("127.0.0.1", port), 1):
            return
        time.sleep(0.02)


async def test_messages_of_a_broker_are_events(broker: int) -> None:
    from paho.mqtt.client import Client
    from paho.mqtt.enums import CallbackAPIVersion

    listening = Listening()
    source = open_source(f"mqtt://127.0.0.1:{broker}/hall/face", listening.setting)
    client = Client(CallbackAPIVersion.VERSION2)
    client.connect("127.0.0.1", broker)
    client.loop_start()
    client.publish("hall/face/heard", "kept from before", retain=True).wait_for_publish(5)
    running = asyncio.create_task(source.run(listening.ears))
    try:
        end = time.monotonic() + 5
        while "kept" not in source.counts() and time.monotonic() < end:
            await asyncio.sleep(0.01)
        for topic, payload in (("heard", b"no"), ("heard", b"\xff"), ("signal", b"closing"), ("open", b"x")):
            client.publish(f"hall/face/{topic}", payload)
        client.publish("hall/face", '{"sighting": "ann", "at": [1, 2, 3]}')
        assert await listening.told(3) == [
            Happening("heard", 0.0, "no"), Happening("signal", 0.0, "closing"), Sighting("ann", 0.0, Point(1, 2, 3)),
        ]  # fmt: skip
        assert source.counts() == {"messages": 5, "malformed": 2, "connections": 1, "kept": 1}
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        client.disconnect()
        client.loop_stop()


async def test_a_broker_that_is_not_there_is_told_once() -> None:
    pytest.importorskip("paho")
    listening = Listening()
    with socket.socket() as nobody:
        nobody.bind(("127.0.0.1", 0))
        source = open_source(f"mqtt://127.0.0.1:{nobody.getsockname()[1]}/face", listening.setting)
        running = asyncio.create_task(source.run(listening.ears))
        end = time.monotonic() + 5
        while not listening.said and time.monotonic() < end:
            await asyncio.sleep(0.01)
        assert len(listening.said) == 1 and "tried again" in listening.said[0]
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)


async def test_markers_of_lsl_are_signals(loopback_lsl: None) -> None:
    import pylsl

    listening = Listening()
    listening.clock.begin()
    source = open_source("lsl://Cues of a test", listening.setting)
    outlet = pylsl.StreamOutlet(pylsl.StreamInfo("Cues of a test", "Markers", 1, 0, pylsl.cf_string, "facescript-test"))
    running = asyncio.create_task(source.run(listening.ears))
    try:
        assert await asyncio.to_thread(outlet.wait_for_consumers, 8.0)
        outlet.push_sample(["cue"], pylsl.local_clock() + 1.0)
        outlet.push_sample(['{"heard": "no"}'])
        cue, heard = await listening.told(2)
        assert isinstance(cue, Happening) and (cue.kind, cue.text) == ("signal", "cue")
        assert heard == Happening("heard", 0.0, "no")
        assert 0.5 < cue.time - listening.clock.now() < 1.01
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)


def test_every_scheme_is_in_the_table() -> None:
    assert {row.example.partition(":")[0] for row in SOURCES.values()} == set(SOURCES)
