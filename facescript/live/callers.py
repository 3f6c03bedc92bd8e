"""A request to whether its caller may come in: with a token from anywhere, without one from this machine alone."""

from __future__ import annotations

import re
from hmac import compare_digest
from typing import TYPE_CHECKING
from urllib.parse import parse_qsl

if TYPE_CHECKING:
    from websockets.http11 import Request

LOOPBACK = ("127.0.0.1", "localhost", "::1")

OWN = re.compile(r"(127\.0\.0\.1|localhost|\[::1\])(:\d{1,5})?")
"""How this machine calls itself in a `Host`, and behind `http://` in an `Origin`."""


class Callers:
    """Who may come to a server. With a `token`, who knows it: as `?token=...`, or in `Authorization: Bearer ...`.
    Without one, who calls this machine by its own name, and from no page of elsewhere."""

    def __init__(self, token: str) -> None:
        self._token = token.encode()

    def welcome(self, request: Request) -> bool:
        return self._knows(request) if self._token else _local(request)

    def _knows(self, request: Request) -> bool:
        said = request.headers.get_all("Authorization")
        words = [*_asked(request.path), *(one.removeprefix("Bearer ") for one in said if one.startswith("Bearer "))]
        return any(compare_digest(word.encode("utf-8", "surrogateescape"), self._token) for word in words)


def _asked(path: str) -> list[str]:
    """The tokens in an address; none where it has more fields than anybody asks with."""
    try:
        return [value for name, value in parse_qsl(path.partition("?")[2], max_num_fields=10) if name == "token"]
    except ValueError:
        return []


def _local(request: Request) -> bool:
    hosts, origins = request.headers.get_all("Host"), request.headers.get_all("Origin")
    if len(hosts) != 1 or not OWN.fullmatch(hosts[0].lower()):
        return False
    return all(OWN.fullmatch(origin.lower().removeprefix("http://")) for origin in origins)
