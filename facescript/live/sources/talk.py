"""Programs that tell faces what to say and do, over a WebSocket: this side listens."""

from __future__ import annotations

from facescript.live.address import Form, parse
from facescript.live.model import Source
from facescript.live.sources.setting import Setting
from facescript.live.talk.server import Talk

FORM = Form("talk://127.0.0.1:8770", port=8770)

PATH = "/talk"


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    assert setting.talk is not None
    parts = parse(address, FORM)
    faces = tuple(face.name for face in setting.play.faces)
    setting.ports.at(parts, setting.token).connected(PATH, Talk(setting.talk, faces).receive)
    return setting.talk
