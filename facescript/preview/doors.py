"""A request to what it gets: the page's own files and its sound, and nothing for who comes from elsewhere."""

from __future__ import annotations

import re
from hmac import compare_digest
from http import HTTPStatus
from pathlib import Path

from websockets.http11 import Request, Response

from facescript.preview.examples import playground
from facescript.web.doors import KINDS, RULE, UNFRAMED, file, files_of, found, is_stranger, names_of, refused

PAGE = Path(__file__).with_name("page")

LIVE, HELP = "/live", "/lsp"
"""Where beneath the page its WebSockets are: of what it shows, and of its language server."""

EDITOR = PAGE / "editor.js"
"""The editor, where `make playground` has built it."""

SOUND = re.compile(r"/sound/(\d{1,10}-\d{1,10}\.wav)", re.ASCII)

SHARED = re.compile(r"/shared/(\d{1,10}\.html)", re.ASCII)

RANGE = re.compile(r"bytes=(\d{1,15})-(\d{0,15})", re.ASCII)

STRETCH = 4 * 1024 * 1024
"""Bytes of a sound that one answer has, at most; a browser asks for the rest."""


class Doors:
    """The doors of a server at `port`; its sound and pages to share lie in `folder`.

    With a `key` all lies beneath it, and who knows it comes by any name and may show the page in another: an editor
    that runs elsewhere reaches this machine through a host and a path of its own.
    """

    def __init__(self, port: int, folder: Path, key: str = "") -> None:
        self._key = key
        self._names = names_of(port)
        self._folder = folder
        self._files = files_of(PAGE)
        if EDITOR.is_file():
            self._files["/editor.js"] = EDITOR

    def way(self, request: Request) -> str | None:
        """Where beneath the page a request goes; None for a stranger."""
        if not self._key:
            return None if is_stranger(request, self._names) else request.path
        key, below, rest = request.path.removeprefix("/").partition("/")
        known = below and compare_digest(key.encode("utf-8", "surrogateescape"), self._key.encode())
        return f"/{rest}" if known else None

    def answer(self, way: str, request: Request) -> Response:
        """The answer to a request that is for no WebSocket."""
        path = way.partition("?")[0]
        if path == "/playground.json":
            return found(playground(EDITOR.is_file()), KINDS[".json"])
        shared = SHARED.fullmatch(path)
        if shared is not None:
            return self._shared(self._folder / shared[1])
        sound = SOUND.fullmatch(path)
        if sound is not None:
            return self._sound(self._folder / sound[1], request)
        if self._key and path == "/":
            return self._framed()
        return file(self._files, path)

    def _shared(self, path: Path) -> Response:
        """A page to be kept: a browser does not show it, so that this server's rule for pages does not apply to it."""
        try:
            answer = found(path.read_bytes(), KINDS[".html"])
        except OSError:
            return refused(HTTPStatus.NOT_FOUND)
        answer.headers["Content-Disposition"] = "attachment"
        return answer

    def _framed(self) -> Response:
        """The page, for an editor's window, which frames it."""
        answer = found(self._files["/index.html"].read_bytes(), KINDS[".html"])
        del answer.headers["Content-Security-Policy"], answer.headers["Cross-Origin-Resource-Policy"]
        answer.headers["Content-Security-Policy"] = RULE.removesuffix(f"; {UNFRAMED}")
        return answer

    def _sound(self, path: Path, request: Request) -> Response:
        """A stretch of a sound, or where none is asked for all of it."""
        try:
            size = path.stat().st_size
            with path.open("rb") as sound:
                asked = RANGE.fullmatch(request.headers.get("Range", ""))
                if asked is None:
                    return found(sound.read(), "audio/wav")
                first = int(asked[1])
                last = min(int(asked[2] or size - 1), size - 1, first + STRETCH - 1)
                if first > last:
                    return refused(HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE)
                sound.seek(first)
                body = sound.read(last - first + 1)
        except OSError:
            return refused(HTTPStatus.NOT_FOUND)
        answer = found(body, "audio/wav", HTTPStatus.PARTIAL_CONTENT)
        answer.headers["Content-Range"] = f"bytes {first}-{last}/{size}"
        return answer
