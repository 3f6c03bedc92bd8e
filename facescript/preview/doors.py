"""A request to what it gets: the page's own files and its sound, and nothing for who comes from elsewhere."""

from __future__ import annotations

import re
from hmac import compare_digest
from http import HTTPStatus
from pathlib import Path

from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from facescript.backends import page as output
from facescript.preview.examples import playground

PAGE = Path(__file__).with_name("page")

DRAWING = Path(output.__path__[0]) / "drawing.js"
"""What `.html` outputs draw with; the page takes it as a module."""

KINDS = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".svg": "image/svg+xml",
}

LIVE, HELP = "/live", "/lsp"
"""Where beneath the page its WebSockets are: of what it shows, and of its language server."""

EDITOR = PAGE / "editor.js"
"""The editor, where `make playground` has built it."""

HOSTS = ("127.0.0.1", "localhost", "[::1]")

UNFRAMED = "frame-ancestors 'none'"
RULE = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; media-src 'self'; "
    f"font-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; {UNFRAMED}"
)

HEADERS = {
    "Content-Security-Policy": RULE,
    "X-Content-Type-Options": "nosniff",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}

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
        self._hosts = {f"{host}:{port}" for host in HOSTS} | (set(HOSTS) if port == 80 else set())
        self._folder = folder
        files = (path for path in PAGE.rglob("*") if path.suffix in KINDS)
        self._files = {f"/{path.relative_to(PAGE).as_posix()}": path for path in files}
        if EDITOR.is_file():
            self._files["/editor.js"] = EDITOR

    def way(self, request: Request) -> str | None:
        """Where beneath the page a request goes; None for a stranger."""
        if not self._key:
            return None if self._stranger(request) else request.path
        _, key, *rest = request.path.split("/", 2)
        known = rest and compare_digest(key.encode(), self._key.encode())
        return f"/{rest[0]}" if known else None

    def _stranger(self, request: Request) -> bool:
        """Whether a request comes from a page of elsewhere, or by a name that is not this machine's own."""
        hosts, origins = request.headers.get_all("Host"), request.headers.get_all("Origin")
        if len(hosts) != 1 or hosts[0].lower() not in self._hosts:
            return True
        return any(origin.lower() not in {f"http://{host}" for host in self._hosts} for origin in origins)

    def answer(self, way: str, request: Request) -> Response:
        """The answer to a request that is for no WebSocket."""
        path = way.partition("?")[0]
        if path == "/drawing.js":
            return _found(DRAWING.read_bytes() + b"\nexport { drawing };\n", KINDS[".js"])
        if path == "/playground.json":
            return _found(playground(EDITOR.is_file()), KINDS[".json"])
        shared = SHARED.fullmatch(path)
        if shared is not None:
            return self._shared(self._folder / shared[1])
        sound = SOUND.fullmatch(path)
        if sound is not None:
            return self._sound(self._folder / sound[1], request)
        if self._key and path == "/":
            return self._framed()
        file = self._files.get("/index.html" if path == "/" else path)
        return refused(HTTPStatus.NOT_FOUND) if file is None else _found(file.read_bytes(), KINDS[file.suffix])

    def _shared(self, path: Path) -> Response:
        """A page to be kept: a browser does not show it, so that this server's rule for pages does not apply to it."""
        try:
            answer = _found(path.read_bytes(), KINDS[".html"])
        except OSError:
            return refused(HTTPStatus.NOT_FOUND)
        answer.headers["Content-Disposition"] = "attachment"
        return answer

    def _framed(self) -> Response:
        """The page, for an editor's window, which frames it."""
        answer = _found(self._files["/index.html"].read_bytes(), KINDS[".html"])
        del answer.headers["Content-Security-Policy"], answer.headers["Cross-Origin-Resource-Policy"]
        answer.headers["Content-Security-Policy"] = RULE.removesuffix(f"; {UNFRAMED}")
        return answer

    def _sound(self, path: Path, request: Request) -> Response:
        """A stretch of a sound, or where none is asked for all of it."""
        try:
            size = path.stat().st_size
            with path.open("rb") as file:
                asked = RANGE.fullmatch(request.headers.get("Range", ""))
                if asked is None:
                    return _found(file.read(), "audio/wav")
                first = int(asked[1])
                last = min(int(asked[2] or size - 1), size - 1, first + STRETCH - 1)
                if first > last:
                    return refused(HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE)
                file.seek(first)
                body = file.read(last - first + 1)
        except OSError:
            return refused(HTTPStatus.NOT_FOUND)
        answer = _found(body, "audio/wav", HTTPStatus.PARTIAL_CONTENT)
        answer.headers["Content-Range"] = f"bytes {first}-{last}/{size}"
        return answer


def refused(status: HTTPStatus) -> Response:
    """An answer that gives nothing."""
    return _found(f"{status.phrase}\n".encode(), "text/plain; charset=utf-8", status)


def _found(body: bytes, kind: str, status: HTTPStatus = HTTPStatus.OK) -> Response:
    headers = Headers(HEADERS)
    headers["Content-Type"], headers["Content-Length"] = kind, str(len(body))
    headers["Accept-Ranges"], headers["Connection"] = "bytes", "close"
    return Response(status.value, status.phrase, headers, body)
