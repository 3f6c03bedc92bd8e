"""A request to a server of this machine to who may ask it, and to the answers that all pages get alike."""

from __future__ import annotations

from collections.abc import Mapping
from http import HTTPStatus
from pathlib import Path

from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from facescript.backends import page as output

LOOPBACK = "127.0.0.1"

HOSTS = (LOOPBACK, "localhost", "[::1]")

SHARED = Path(__file__).with_name("page")
"""The files of all pages."""

DRAWING = Path(output.__path__[0]) / "drawing.js"
"""What `.html` outputs draw with; pages take it as a module."""

KINDS = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".svg": "image/svg+xml",
}

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


def names_of(port: int) -> frozenset[str]:
    """The names by which a browser on this machine reaches a port of it."""
    return frozenset({f"{host}:{port}" for host in HOSTS} | (set(HOSTS) if port == 80 else set()))


def is_stranger(request: Request, names: frozenset[str]) -> bool:
    """Whether a request comes from a page of elsewhere, or by a name that is not this machine's own."""
    hosts, origins = request.headers.get_all("Host"), request.headers.get_all("Origin")
    if len(hosts) != 1 or hosts[0].lower() not in names:
        return True
    return any(origin.lower() not in {f"http://{host}" for host in names} for origin in origins)


def files_of(folder: Path) -> dict[str, Path]:
    """The files of a page and those of all pages, by their addresses."""
    files = ((path, place) for place in (SHARED, folder) for path in place.rglob("*") if path.suffix in KINDS)
    return {f"/{path.relative_to(place).as_posix()}": path for path, place in files}


def file(files: Mapping[str, Path], path: str) -> Response:
    """The file at a path; `/` is the page itself."""
    if path == "/drawing.js":
        return found(DRAWING.read_bytes() + b"\nexport { drawing };\n", KINDS[".js"])
    named = files.get("/index.html" if path == "/" else path)
    return refused(HTTPStatus.NOT_FOUND) if named is None else found(named.read_bytes(), KINDS[named.suffix])


def refused(status: HTTPStatus) -> Response:
    """An answer that gives nothing."""
    return found(f"{status.phrase}\n".encode(), "text/plain; charset=utf-8", status)


def found(body: bytes, kind: str, status: HTTPStatus = HTTPStatus.OK) -> Response:
    headers = Headers(HEADERS)
    headers["Content-Type"], headers["Content-Length"] = kind, str(len(body))
    headers["Accept-Ranges"], headers["Connection"] = "bytes", "close"
    return Response(status.value, status.phrase, headers, body)
