"""What peers say, as JSON or in words, to events and sightings; and these to JSON. All is bounded and plain."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from math import isfinite

from facescript.ir.values import Point
from facescript.live.model import Happening, Sighting, Told

TEXTUAL = ("heard", "touched", "key", "signal")
PERSONAL = ("arrives", "leaves", "sighting")

LARGEST = 4096
"""Bytes of a message."""

LONGEST = 200
"""Characters of a text or a name."""

FURTHEST = 1e5
"""Centimetres to a person."""

LATEST = 1e7
"""Seconds of a run."""

CENTIMETRES = {"cm": 1.0, "m": 100.0}

FORM = 'a message is such as {"heard": "no"} or {"arrives": "ann", "at": [10, 0, 80]}'
LINE = "a line is such as `heard no`, `key q` or `arrives ann 10cm 0cm 80cm`"

QUOTED = re.compile(r'(\w+)\s+"([^"]*)"(?:\s+at\s+(\d{1,8}(?:\.\d{1,6})?)s)?')
PLACED = re.compile(r"(arrives|sighting)\s+(\S+)" + r"\s+(-?\d{1,6}(?:\.\d{1,6})?)(cm|m)" * 3)
BARE = re.compile(r"(\w+)\s+(.*\S)")


class Nonsense(ValueError):
    """No message; `args[0]` says why."""


def read(data: str | bytes) -> tuple[Told, ...]:
    """A message in either form. Raises `Nonsense`."""
    if len(data) > LARGEST:
        raise Nonsense(f"a message has at most {LARGEST} bytes")
    try:
        text = (data if isinstance(data, str) else data.decode("utf-8")).strip()
    except UnicodeDecodeError:
        raise Nonsense("it is not UTF-8") from None
    return of_object(loaded(text)) if text.startswith("{") else of_words(text)


def loaded(text: str) -> dict[str, object]:
    """An object of JSON. Raises `Nonsense`."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        raise Nonsense(f"it is no JSON; {FORM}") from None
    if not isinstance(found, dict):
        raise Nonsense(FORM)
    return found


def of_object(message: Mapping[str, object]) -> tuple[Told, ...]:
    """What an object says; its `time` is seconds of the run, now where there is none. Raises `Nonsense`."""
    kinds = [kind for kind in (*TEXTUAL, *PERSONAL) if kind in message]
    if len(kinds) != 1:
        raise Nonsense(FORM)
    kind = kinds[0]
    placed = "at" in message
    strange = sorted(set(message) - {kind, "time"} - ({"at"} if kind in ("arrives", "sighting") else set()))
    if strange:
        raise Nonsense(f"`{strange[0][:LONGEST]}` does not belong to `{kind}`")
    if kind == "sighting" and not placed:
        raise Nonsense('a sighting has a place, "at": [x, y, z] in cm')
    time = number(message.get("time", 0.0), 0.0, LATEST, "a time is seconds of the run")
    return told(kind, message[kind], time, place(message["at"]) if placed else None)


def of_words(text: str) -> tuple[Told, ...]:
    """What a line says: `heard no`, `heard "no" at 3s`, `arrives ann 10cm 0cm 80cm`. Raises `Nonsense`."""
    if found := PLACED.fullmatch(text):
        sizes = [float(found[index]) * CENTIMETRES[found[index + 1]] for index in (3, 5, 7)]
        return told(found[1], found[2], 0.0, place(sizes))
    if found := QUOTED.fullmatch(text):
        return told(found[1], found[2], float(found[3] or 0.0))
    if found := BARE.fullmatch(text):
        return told(found[1], found[2])
    raise Nonsense(LINE)


def told(kind: str, text: object, time: float = 0.0, at: Point | None = None) -> tuple[Told, ...]:
    """An event; who arrives at a place is seen there. Raises `Nonsense`."""
    name = plain(text)
    if kind in TEXTUAL:
        return (Happening(kind, time, name),)
    if kind not in PERSONAL or (kind == "sighting" and at is None):
        raise Nonsense(LINE)
    seen = (Sighting(name, time, at),) if at is not None else ()
    return seen if kind == "sighting" else (*seen, Happening(kind, time, person=name))


def plain(text: object) -> str:
    """A text of a line at most, without signs that are not seen. Raises `Nonsense`."""
    if not isinstance(text, str) or not 0 < len(text) <= LONGEST or not text.isprintable() or not text.strip():
        raise Nonsense(f"a text has 1 to {LONGEST} characters, all of them visible")
    return text


def place(at: object) -> Point:
    """Three numbers, cm. Raises `Nonsense`."""
    wanted = f"a place is three numbers, centimetres up to {FURTHEST:.0f}"
    if not isinstance(at, list | tuple) or len(at) != 3:
        raise Nonsense(wanted)
    return Point(*(number(value, -FURTHEST, FURTHEST, wanted) for value in at))


def number(value: object, least: float, most: float, wanted: str) -> float:
    """A number in a range. Raises `Nonsense`."""
    if type(value) not in (int, float) or not least <= value <= most or not isfinite(value):  # type: ignore[operator, arg-type]
        raise Nonsense(wanted)
    return float(value)  # type: ignore[arg-type]


def as_object(item: Told) -> dict[str, object]:
    """An event or a sighting as the object that says it."""
    if isinstance(item, Sighting):
        at = [item.place.x, item.place.y, item.place.z]
        return {"time": item.time, "sighting": item.person, "at": at}
    return {"time": item.time, item.kind: item.text if item.person is None else item.person}
