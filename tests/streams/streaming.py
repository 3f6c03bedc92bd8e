"""Layouts and frames for the tests of streams: faces that smile more and more and turn their heads."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field

import numpy as np

from facescript.live.model import Frame, Layout, Mark, Sink, Utterance
from facescript.live.sinks.registry import open_sink
from facescript.live.sinks.setting import Setting
from facescript.performance.channels import COMMON
from facescript.speech.model import Spoken, WordTime

FPS = 60.0


def layout(*faces: str, fps: float = FPS) -> Layout:
    """A layout of some faces; without any, of one."""
    faces = faces or ("ada",)
    names = [f"{face}.{one.name}" if len(faces) > 1 else one.name for face in faces for one in COMMON]
    return Layout(fps, faces, tuple(names), COMMON * len(faces), "kiosk.face", 7)


def frame(number: int, of: Layout, **values: float) -> Frame:
    """A frame at rest but for some values; `_` in a name stands for its dots."""
    found = np.array([one.rest for one in of.channels])
    for name, value in values.items():
        found[of.names.index(name.replace("_", "."))] = value
    return Frame(number, number / of.fps, found)


def smiling(number: int, of: Layout) -> Frame:
    """A smile that grows by a hundredth a frame, more on the face's left, and a head that turns by a tenth degree."""
    prefix = f"{of.faces[0]}_" if len(of.faces) > 1 else ""
    values = {"cheek_lower_left": number / 100, "cheek_lower_right": number / 200, "head_yaw": number / 10}
    return frame(number, of, **{prefix + name: value for name, value in values.items()})


HELLO = Mark("word", 0.25, "Hello", "ada", None, 0.001)
ONSET = Mark("act", 0.5, "show smile", "ada", "onset")


def line() -> Utterance:
    spoken = Spoken(b"", 22_050, 0.75, (WordTime("Hello", 0, 5, 0.1, 0.5),), ())
    return Utterance(3, "ada", 1.0, spoken, 1.0, "Hello.")


@dataclass
class Told:
    """What a sink told whoever runs it."""

    texts: list[str] = field(default_factory=list)

    def setting(self, token: str = "", patient: bool = False) -> Setting:
        return Setting(token, patient, self.texts.append)


@asynccontextmanager
async def opened(address: str, of: Layout, setting: Setting | None = None) -> AsyncIterator[Sink]:
    """A sink that is open, and closed at the end."""
    setting = setting or Told().setting()
    sink = open_sink(address, setting)
    try:
        await setting.ports.open()
        await sink.open(of)
        yield sink
    finally:
        await sink.close()
        await setting.ports.close()
