"""The address of a source to the source: a row a scheme; a module is imported only when it is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec

from facescript.live.address import AddressFault
from facescript.live.model import Source
from facescript.live.sources.setting import Setting


@dataclass(frozen=True, slots=True)
class Row:
    """A kind of source: its module here, which has `opened(address, setting) -> Source`; an address as an example; what
    of Python it needs, and the extra that brings it."""

    module: str
    example: str
    needs: str | None = None
    extra: str = ""


SOURCES: Mapping[str, Row] = {
    "stdin": Row("stdin", "stdin:"),
    "ws": Row("ws", "ws://127.0.0.1:8080", "websockets", "live"),
    "http": Row("http", "http://127.0.0.1:8080", "websockets", "live"),
    "osc": Row("osc", "osc://127.0.0.1:9000"),
    "mqtt": Row("mqtt", "mqtt://127.0.0.1:1883/facescript", "paho", "mqtt"),
    "camera": Row("camera", "camera:0", "cv2", "camera"),
    "video": Row("camera", "video:visit.mp4", "cv2", "camera"),
    "track": Row("track", "track:visit.csv"),
    "microphone": Row("microphone", "microphone:", "sounddevice", "microphone"),
    "wav": Row("wav", "wav:visit.wav"),
    "text": Row("text", "text:visit.txt"),
    "talk": Row("talk", "talk://127.0.0.1:8770", "websockets", "live"),
    "lsl": Row("lsl", "lsl://Markers", "pylsl", "lsl"),
}


def open_source(address: str, setting: Setting) -> Source:
    """The source at an address. Raises `AddressFault`."""
    row = SOURCES.get(address.partition(":")[0])
    if row is None or ":" not in address:
        known = ", ".join(f"`{row.example}`" for row in SOURCES.values())
        raise AddressFault("FS970", address=address[:100], known=known)
    if row.needs is not None and find_spec(row.needs) is None:
        raise AddressFault("FS960", command=f"live --from {row.example}", extra=row.extra)
    source: Source = import_module(f"facescript.live.sources.{row.module}").opened(address, setting)
    return source
