"""HTTP requests to events: `POST /heard` with the text, `POST /signal/NAME`, `POST /event` with JSON; `GET /status`."""

from __future__ import annotations

import asyncio
import json
from http import HTTPStatus
from urllib.parse import unquote

from websockets.http11 import Request, Response

from facescript.live.address import Form, parse
from facescript.live.messages import PERSONAL, TEXTUAL, Nonsense, told
from facescript.live.model import Source, Teller, Told
from facescript.live.sources.intake import Intake
from facescript.live.sources.setting import Setting
from facescript.web.doors import found, refused

FORM = Form("http://127.0.0.1:8080")

JSON = "application/json"


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    source = Http(setting)
    port = setting.ports.at(parse(address, FORM), setting.token)
    for kind in (*TEXTUAL, *PERSONAL, "event"):
        port.posted(f"/{kind}", source.post)
    port.answered("/status", source.status)
    return source


class Http:
    """A message a request; the answer says whether it was taken."""

    def __init__(self, setting: Setting) -> None:
        self._setting, self._intake = setting, Intake()
        self._teller: Teller | None = None

    async def run(self, teller: Teller) -> None:
        self._teller = teller
        await asyncio.Event().wait()

    def post(self, request: Request, body: bytes) -> Response:
        """202 where it is taken, else 400 and why not."""
        if self._teller is None:
            return refused(HTTPStatus.SERVICE_UNAVAILABLE)
        _, kind, *rest = request.path.partition("?")[0].split("/", 2)
        if kind == "event":
            why = self._intake.take(self._teller, body)
        else:
            why = self._intake.told(self._teller, lambda: _read(kind, rest[0] if rest else None, body))
        if why is None:
            return found(b"{}\n", JSON, HTTPStatus.ACCEPTED)
        return found(json.dumps({"refused": why}).encode() + b"\n", JSON, HTTPStatus.BAD_REQUEST)

    def status(self, request: Request) -> Response:
        """How the run goes."""
        return found(json.dumps(self._setting.status(), indent=2).encode() + b"\n", JSON)

    def counts(self) -> dict[str, int]:
        return self._intake.counts()


def _read(kind: str, name: str | None, body: bytes) -> tuple[Told, ...]:
    """An event of a kind, named in the path or by the body. Raises `Nonsense`."""
    try:
        text = unquote(name, errors="strict") if name is not None else body.decode("utf-8").strip()
    except UnicodeDecodeError:
        raise Nonsense("it is not UTF-8") from None
    return told(kind, text)
