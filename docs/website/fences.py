"""Blocks of a page with settings behind their word (`{picture="2s" alt="..."}`) to the pictures that they ask for.

The block itself stays a script that anybody can run. A block `face-picture` is drawn and not shown, `face-part` is
coloured and is no whole script.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

KINDS = ("picture", "film", "plot")
WIDE = {"picture": 480, "film": 480, "plot": 680}
"""How wide each is shown where nothing is said, CSS px."""

FENCE = re.compile(
    r"^(?P<indent> *)```(?P<word>face|face-picture)[ \t]+\{(?P<settings>[^}\n]*)\}[ \t]*\n(?P<script>.*?)^ *```$",
    re.MULTILINE | re.DOTALL,
)
SETTING = re.compile(r'\s*([\w-]+)="([^"]*)"')
SPAN = re.compile(r"(\d+(?:\.\d+)?)(ms|s)")


class FenceFault(ValueError):
    """A block whose settings cannot be followed; `args[0]` says why."""


@dataclass(frozen=True, slots=True)
class Picture:
    """What a block shows: one of `KINDS`, of a script from `start` to `end` (s), `wide` CSS px; a plot's `channels`."""

    kind: str
    script: str
    start: float
    end: float
    alt: str
    wide: int
    channels: str = ""


def pictures(text: str) -> Iterator[Picture]:
    """Every picture that a page asks for, in its order. Raises `FenceFault`."""
    return (picture(found) for found in FENCE.finditer(text))


def plain(text: str, shown: Callable[[Picture], str]) -> str:
    """The page with plain blocks, and below each what `shown` makes of its picture."""

    def turned(found: re.Match[str]) -> str:
        indent, image = found["indent"], shown(picture(found))
        if found["word"] == "face-picture":
            return f"{indent}{image}"
        return f"{indent}```face\n{found['script']}{indent}```\n\n{indent}{image}"

    return FENCE.sub(turned, text)


def picture(found: re.Match[str]) -> Picture:
    """What a block asks for. Raises `FenceFault`."""
    settings = dict(SETTING.findall(found["settings"]))
    if SETTING.sub("", found["settings"]).strip():
        raise FenceFault(f'`{found["settings"]}` is not a row of NAME="VALUE"')
    asked = [kind for kind in KINDS if kind in settings]
    unknown = set(settings) - {*KINDS, "alt", "wide", "channels"}
    if len(asked) != 1 or unknown or not settings.get("alt"):
        raise FenceFault(f"`{found['settings']}` wants one of {', '.join(KINDS)}, and an `alt`")
    (kind,) = asked
    start, end = _stretch(settings[kind])
    script = re.sub(f"^{found['indent']}", "", found["script"], flags=re.MULTILINE)
    wide = int(settings.get("wide", WIDE[kind]))
    return Picture(kind, script, start, end, settings["alt"], wide, settings.get("channels", ""))


def _stretch(text: str) -> tuple[float, float]:
    """`2.4s` or `0s to 3s`."""
    words = [SPAN.fullmatch(word) for word in text.split(" to ")]
    times = [float(word[1]) / (1000 if word[2] == "ms" else 1) for word in words if word]
    if len(times) != len(words) or len(times) > 2:
        raise FenceFault(f"`{text}` is neither a moment (`2.4s`) nor a stretch (`0s to 3s`)")
    return times[0], times[-1]
