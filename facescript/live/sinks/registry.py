"""An address to the sink that goes there: those of this version, and those that plug-ins bring."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import entry_points
from importlib.util import find_spec
from typing import cast

from facescript.live.address import LONGEST, Address, AddressFault, Form, parse
from facescript.live.model import Sink
from facescript.live.sinks.setting import Setting

GROUP = "facescript.sinks"
"""Entry points of this group add kinds of addresses: name = what stands before the `:`, value =
`module:function(address: str) -> Sink`."""

HERE = "facescript.live.sinks"


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of address: what it begins with, where its class is, what it looks like, a line of help, and the package
    it needs besides with the extra that brings it. `whole`: what stands behind the colon is a name, with no parts."""

    scheme: str
    target: str
    form: Form
    help: str
    needs: tuple[str, str] | None = None
    whole: bool = False


RATE: dict[str, tuple[str, ...]] = {"rate": ()}
ONE_FACE = {**RATE, "face": ()}

KINDS = (
    Kind("-", f"{HERE}.lines:LinesSink", Form("-"), "standard output: lines of JSON", whole=True),
    Kind("csv", f"{HERE}.table:TableSink", Form("csv:run.csv"), "table: time, every channel, markers", whole=True),
    Kind(
        "ws",
        f"{HERE}.ws:WebSocketSink",
        Form("ws://127.0.0.1:8765", options=RATE),
        "WebSocket; listens there, for as many as come",
        ("websockets", "live"),
    ),
    Kind(
        "udp-json",
        f"{HERE}.udp_json:UdpJsonSink",
        Form("udp-json://127.0.0.1:9001", options=RATE),
        "datagrams of JSON",
    ),
    Kind(
        "osc",
        f"{HERE}.osc:OscSink",
        Form("osc://127.0.0.1:9000", path=True, options=RATE),
        "Open Sound Control: an address a channel",
    ),
    Kind(
        "vmc",
        f"{HERE}.vmc:VmcSink",
        Form("vmc://127.0.0.1:39539", 39539, options={**ONE_FACE, "names": ("vrm0", "vrm1")}),
        "VMC protocol: VSeeFace, Warudo, Unity, Blender",
    ),
    Kind(
        "livelink",
        f"{HERE}.livelink:LiveLinkSink",
        Form("livelink://127.0.0.1:11111", 11111, options=ONE_FACE),
        "Live Link: Unreal",
    ),
    Kind(
        "vts",
        f"{HERE}.vts:VTubeStudioSink",
        Form("vts://127.0.0.1:8001", 8001, options=ONE_FACE),
        "VTube Studio",
        ("websockets", "live"),
    ),
    Kind(
        "lsl",
        f"{HERE}.lsl:LslSink",
        Form("lsl://FaceScript"),
        "Lab Streaming Layer: channels and markers",
        ("pylsl", "lsl"),
        whole=True,
    ),
    Kind(
        "mqtt",
        f"{HERE}.mqtt:MqttSink",
        Form("mqtt://127.0.0.1:1883/face", 1883, path=True, options=RATE),
        "broker of MQTT",
        ("paho", "mqtt"),
    ),
)


def kinds() -> dict[str, Kind]:
    """All kinds by their beginning; a plug-in cannot take the place of one of ours."""
    found = {kind.scheme: kind for kind in KINDS}
    for entry in entry_points(group=GROUP):
        form = Form(f"{entry.name}:")
        found.setdefault(entry.name, Kind(entry.name, entry.value, form, f"from {entry.value}", whole=True))
    return found


def open_sink(text: str, setting: Setting | None = None) -> Sink:
    """The sink of an address; its `open` begins. Raises `AddressFault`."""
    known = kinds()
    kind = known.get(text.partition(":")[0]) if len(text) <= LONGEST else None
    if kind is None:
        shown = text if len(text) <= LONGEST else f"{text[:40]}..."
        raise AddressFault("FS980", address=shown, known=", ".join(f"`{one.form.example}`" for one in known.values()))
    if kind.needs is not None and find_spec(kind.needs[0]) is None:
        raise AddressFault("FS960", command=f"live --to {kind.scheme}", extra=kind.needs[1])
    if kind not in KINDS:
        return _loaded(kind, text)(text)
    address = _address(text, kind)
    return _loaded(kind, text)(address, setting or Setting())


def _address(text: str, kind: Kind) -> Address:
    """The parts of an address; one with a bare name has it as its path. Raises `AddressFault`."""
    if not kind.whole:
        return parse(text, kind.form)
    name = text.partition(":")[2].removeprefix("//")
    if text != "-" and (not name or kind.scheme == "-"):
        reason = "nothing may follow" if kind.scheme == "-" else "it has no name"
        raise AddressFault("FS981", address=text, reason=reason, example=kind.form.example)
    return Address(text, "", 0, name, {})


def _loaded(kind: Kind, text: str) -> Callable[..., Sink]:
    """A kind's class. Raises `AddressFault` where a plug-in names what is not there."""
    module, _, name = kind.target.partition(":")
    try:
        return cast("Callable[..., Sink]", getattr(import_module(module), name))
    except (ImportError, AttributeError) as fault:
        raise AddressFault("FS982", address=text, reason=f"`{kind.target}` cannot be loaded: {fault}") from fault
