"""Options that stand over a script's head to numbers: sizes, rates, seeds, times, `--set`, `--events`."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from facescript.cli.report import OptionFault
from facescript.compile import Settings
from facescript.project import open_script
from facescript.text import Source
from facescript.world import WorldFailure

LARGEST_SIDE = 8192
"""Pixels of the widest picture."""

FASTEST = 10_000.0
"""The most frames or rows a second."""

LOGGED = '{"log"'
"""What the log of a live run begins with."""

TIMES = {"ms": 0.001, "s": 1.0, "min": 60.0}

LARGEST_PORT = 65_535


def settings(options: argparse.Namespace) -> Settings:
    """What `--set --seed --size --fps --events --draft` say. Raises `OptionFault`."""
    film: dict[str, float] = {}
    if getattr(options, "size", None):
        film["width"], film["height"] = size(options.size)
    if getattr(options, "fps", None):
        film["fps"] = rate(options.fps)
    if getattr(options, "seed", None):
        film["seed"] = count("--seed", options.seed, "7")
    events = _events(getattr(options, "events", None))
    if events is not None and events.text.startswith(LOGGED):
        return _logged(options.events, _overrides(options.set), film)
    return Settings(_overrides(options.set), film, events)


def _logged(name: str, overrides: dict[str, str], film: dict[str, float]) -> Settings:
    """What the log of a live run says: its events, and how it was set, where nothing else is said. Raises
    `OptionFault`."""
    from facescript.live.log import LogFault, open_log
    from facescript.live.retold import retold

    try:
        recorded = open_log(Path(name))
        script = Source(f"{name} as events", retold(recorded))
    except LogFault as fault:
        raise OptionFault("FS973", name=name, reason=fault.args[0]) from None
    head = recorded.head
    own = {"seed": head.seed, "long": recorded.end / head.fps}
    return Settings({**head.set, **overrides}, {**own, **film}, script, instead=True)


def size(text: str) -> tuple[int, int]:
    """`1280x720`. Raises `OptionFault`."""
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text)
    sides = tuple(int(side) for side in found.groups()) if found else ()
    if len(sides) != 2 or not all(16 <= side <= LARGEST_SIDE for side in sides):
        raise OptionFault("FS904", option="--size", value=text, example="1280x720")
    return sides


def rate(text: str) -> float:
    """`30`, `59.94` or `30fps`. Raises `OptionFault`."""
    number = _float(text.removesuffix("fps"))
    if number is None or not 0 < number <= FASTEST:
        raise OptionFault("FS904", option="--fps", value=text, example="30")
    return number


def count(option: str, text: str, example: str) -> int:
    """A whole number from 0. Raises `OptionFault`."""
    if not re.fullmatch(r"\d{1,15}", text):
        raise OptionFault("FS904", option=option, value=text, example=example)
    return int(text)


def seconds(option: str, text: str | None) -> float | None:
    """`2s`, `300ms`, `1.5min`; None stays None. Raises `OptionFault`."""
    if text is None:
        return None
    found = re.fullmatch(r"(\d{1,9}(?:\.\d{1,9})?)(ms|s|min)", text)
    if found is None:
        raise OptionFault("FS904", option=option, value=text, example=f"{text}s" if _float(text) is not None else "2s")
    return float(found[1]) * TIMES[found[2]]


def stretch(options: argparse.Namespace, duration: float) -> tuple[float, float]:
    """What `--from` and `--to` ask for, in seconds. Raises `OptionFault` where nothing of the film lies there."""
    if duration <= 0:
        raise OptionFault("FS911", name=options.script)
    start = seconds("--from", options.start) or 0.0
    end = min(seconds("--to", options.end) or duration, duration)
    if start >= end:
        raise OptionFault("FS906", asked="What `--from` and `--to` ask for", duration=duration)
    return start, end


def _overrides(pairs: list[str]) -> dict[str, str]:
    found = {}
    for pair in pairs:
        name, sign, value = pair.partition("=")
        if not sign or not name.strip() or not value.strip():
            raise OptionFault("FS904", option="--set", value=pair, example="beat=400ms")
        found[name.strip()] = value.strip()
    return found


def _events(name: str | None) -> Source | None:
    if name is None:
        return None
    try:
        return open_script(name)[0]
    except WorldFailure as fault:
        raise OptionFault("FS901", name=name, reason=fault.args[0]) from None


def _float(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def port(option: str, text: str | None) -> int | None:
    """The port asked for; 0 is any that is free. Raises `OptionFault`."""
    if text is None:
        return None
    if not text.isascii() or not text.isdigit() or int(text[:6]) > LARGEST_PORT:
        raise OptionFault("FS904", option=option, value=text, example="8080")
    return int(text)
