"""An address of a live run, such as `osc://127.0.0.1:9000?rate=30`, to its parts, or to what is wrong with it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

LONGEST = 500
"""Signs of an address."""

LARGEST_PORT = 65_535

FASTEST = 1000.0
"""Frames a second that anybody may be sent."""

WHOLE = re.compile(
    r"(?P<scheme>[a-z][a-z-]*)://(?P<host>[A-Za-z0-9._-]{1,253}|\[[0-9A-Fa-f:.]{2,45}\])?(?::(?P<port>\d{1,9}))?"
    r"(?P<path>/[^\s?#]*)?(?:\?(?P<query>[^\s#]*))?"
)

NUMBER = re.compile(r"\d{1,4}(\.\d{1,6})?", re.ASCII)


class AddressFault(ValueError):
    """An address that cannot work: the code of a diagnostic and the values of its sentence."""

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(str(values.get("reason", code)))
        self.code, self.values = code, values


@dataclass(frozen=True, slots=True)
class Form:
    """What addresses of a kind look like: one to show as an `example`, the `port` where none is named, whether there is
    a `path`, and the `options` behind the question mark, each with what it may be (none: any word)."""

    example: str
    port: int | None = None
    path: bool = False
    options: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Address:
    """Where something comes from or goes. `path` is without the slash before it."""

    text: str
    host: str
    port: int
    path: str
    options: Mapping[str, str]

    @property
    def rate(self) -> float | None:
        """Frames a second that are asked for; None where all are."""
        return float(self.options["rate"]) if "rate" in self.options else None


def parse(text: str, form: Form) -> Address:
    """The parts of an address. Raises `AddressFault`."""
    found = WHOLE.fullmatch(text) if len(text) <= LONGEST else None
    if found is None:
        raise _unread(text, form, "it is not of this form" if len(text) <= LONGEST else f"it is over {LONGEST} signs")
    host, path = (found["host"] or "").strip("[]"), (found["path"] or "").strip("/")
    if not host:
        raise _unread(text, form, "it names no host")
    if path and not form.path:
        raise _unread(text, form, f"`/{path}` has no meaning here")
    return Address(text, host, _port(text, form, found["port"]), path, _options(text, form, found["query"]))


def _port(text: str, form: Form, port: str | None) -> int:
    if port is None and form.port is not None:
        return form.port
    if port is None or int(port) > LARGEST_PORT:
        reason = "it names no port" if port is None else f"there are ports up to {LARGEST_PORT}"
        raise _unread(text, form, reason)
    return int(port)


def _options(text: str, form: Form, query: str | None) -> dict[str, str]:
    options: dict[str, str] = {}
    for part in query.split("&") if query else ():
        name, _, value = part.partition("=")
        if name not in form.options:
            known = ", ".join(f"`{known}`" for known in form.options)
            raise _unread(text, form, f"`{name}` is no option here" + (f"; there is {known}" if known else ""))
        if name in options:
            raise _unread(text, form, f"`{name}` is there twice")
        _check(text, form, name, value)
        options[name] = value
    return options


def _check(text: str, form: Form, name: str, value: str) -> None:
    wanted = form.options[name]
    if name == "rate" and not (NUMBER.fullmatch(value) and 0 < float(value) <= FASTEST):
        raise _unread(text, form, f"`rate` is a number of frames a second, up to {FASTEST:g}")
    if wanted and value not in wanted:
        raise _unread(text, form, f"`{name}` is {' or '.join(f'`{one}`' for one in wanted)}")
    if not value:
        raise _unread(text, form, f"`{name}` has no value")


def _unread(text: str, form: Form, reason: str) -> AddressFault:
    shown = text if len(text) <= LONGEST else f"{text[:40]}..."
    return AddressFault("FS981", address=shown, reason=reason, example=form.example)
