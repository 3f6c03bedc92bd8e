"""The channels of a pose to their page: unit, rest, sign, how far each goes, and a picture at either end."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from facescript.motion.blend import LID_FLOOR
from facescript.motion.compose import HEAD_LIMITS
from facescript.performance.channels import CHANNELS, MUSCLES, Channel
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.kinds.library import kinds_with
from facescript.space.reach import EYE_DOWN, EYE_SIDE, EYE_UP
from website.page import NEAR, WHOLE, Page, heading, portrait, row, table

YAW, PITCH, ROLL = (f"{limit:g}deg" for limit in HEAD_LIMITS)
SIDE, UP, DOWN = f"{EYE_SIDE:g}deg", f"{EYE_UP:g}deg", f"{EYE_DOWN:g}deg"


@dataclass(frozen=True, slots=True)
class Row:
    """What a channel is, by its name without a side, and the two ends that are shown of it, as amounts on top of its
    rest; `ends` says whether it goes no further."""

    says: str
    low: str
    high: str
    ends: bool = True


ROWS = {
    "head.yaw": Row("The head turned about the vertical; + is the viewer's right.", f"-{YAW}", YAW),
    "head.pitch": Row("The head pitched; + is up.", f"-{PITCH}", PITCH),
    "head.roll": Row("The head tilted in the picture; + is the viewer's clockwise.", f"-{ROLL}", ROLL),
    "head.x": Row("The head moved in the picture's plane; + is the viewer's right.", "-3cm", "3cm", False),
    "head.y": Row("The head moved in the picture's plane; + is up.", "-3cm", "3cm", False),
    "head.scale": Row("The head's size; 1 at rest.", "-20%", "20%", False),
    "eye.yaw": Row("The eye turned in the head; + is the viewer's right.", f"-{SIDE}", SIDE),
    "eye.pitch": Row("The eye turned in the head; + is up. The lid goes with it.", f"-{DOWN}", UP),
    "eye.roll": Row("The eye rolled about its line of sight.", "-20deg", "20deg", False),
    "eye.x": Row("The eye moved in the head; + is the viewer's right.", "-0.4cm", "0.4cm", False),
    "eye.y": Row("The eye moved in the head; + is up.", "-0.4cm", "0.4cm", False),
    "eye.scale": Row("The eye's size; 1 at rest.", "-20%", "20%", False),
    "lid": Row("The lids: 0 as open as at rest, 1 shut, below 0 widened.", f"{LID_FLOOR:.0%}", "100%"),
    "blink": Row("In sums alone: the lids shut over whatever they are, and open again to it.", "0%", "100%"),
    "pupil": Row("The pupil's diameter; 1 at rest.", "-40%", "60%", False),
    "mouth.open": Row("The gap between the inner lips; 0 is closed lips.", "0%", "100%", False),
    "mouth.wide": Row("How far each corner of the mouth moves out; negative is in.", "-15%", "15%", False),
    "mouth.round": Row("How round and pushed forward the lips are.", "0%", "100%"),
    "mouth.upper": Row("How far the upper lip's edge rises.", "-25%", "40%", False),
    "mouth.lower": Row("How far the lower lip's edge sinks.", "-25%", "40%", False),
    "mouth.jaw": Row("How far the jaw drops.", "0%", "100%"),
    "mouth.teeth": Row("How much of the teeth shows between open lips.", "0%", "100%"),
    "mouth.tongue": Row("How far the tongue's tip is up.", "0%", "100%"),
    "ear": Row("The ears: 1 up, 0 at rest, -1 pressed down or back.", "-100%", "100%"),
    "muzzle": Row("How far the pad beside the nose swells and rises.", "0%", "100%"),
    "gaze.yaw": Row(
        "Where the eyes' midline points in the room; + is the viewer's right. Derived: sums cannot add to it.", "", ""
    ),
    "gaze.pitch": Row("Where the eyes' midline points in the room; + is up. Derived: sums cannot add to it.", "", ""),
}

OPENED = {"mouth.teeth": " + mouth.open 40%", "mouth.tongue": " + mouth.open 60% + mouth.teeth 40%"}
"""What must be open for a channel to be seen."""


def pages() -> Iterator[Page]:
    yield Page(
        "reference/channels.md", "Channels", HEAD + _overview() + "\n" + "\n".join(_entry(name) for name in names())
    )


HEAD = """\
# Channels

What a pose is made of, and what tables (`.csv`, `.jsonl`) have a column of. In a sum a channel of an angle or a
length wants one behind it (`head.roll 8deg`), all others a percentage, which adds to the rest. `lid`, `eye.yaw` and
so on mean both sides; `.left` and `.right` are the face's own. The [muscles](muscles.md) are channels too. A head
is pitched, then turned about the vertical, then tilted in the picture, so yaw and pitch are where the nose points.

"""


def base(channel: str) -> str:
    """`eye.yaw` of `eye.left.yaw`."""
    return re.sub(r"\.(left|right)\b", "", channel)


def names() -> list[str]:
    """What a sum may name besides muscles, and the derived ones: without their sides, in the order of tables."""
    columns = (base(channel.name) for channel in CHANNELS)
    return [name for name in dict.fromkeys((*columns, *map(base, PRIMITIVES))) if name not in MUSCLES]


def _channels(name: str) -> list[Channel]:
    return [channel for channel in CHANNELS if base(channel.name) == name]


def _overview() -> str:
    rows = ((f"`{channel.name}`", channel.unit, f"{channel.rest:g}") for channel in CHANNELS)
    return '??? note "All columns, in their order"\n\n' + "".join(
        f"    {line}\n" for line in table(("channel", "unit", "at rest"), rows).splitlines()
    )


def _entry(name: str) -> str:
    row_, channels = ROWS[name], _channels(name)
    columns = ", ".join(f"`{channel.name}`" for channel in channels)
    facts, kinds = [row_.says], kinds_with(name)
    if channels:
        unit, rest = _unit(channels[0].unit), channels[0].rest
        facts.append(f"Column{'s' * (len(channels) > 1)} {columns}, in {unit}, {rest:g} at rest.")
    if kinds:
        facts.append(f"Only of {', '.join(f'[{kind}](kinds.md#{kind})' for kind in kinds)}.")
    if row_.low:
        facts.append(f"It goes from `{row_.low}` to `{row_.high}`." if row_.ends else "Here by so much:")
    return "\n".join([heading(name), " ".join(facts) + "\n", _pictures(name, row_, kinds)])


def _unit(unit: str) -> str:
    return {"deg": "degrees", "cm": "centimetres", "1": "shares (1 is 100 %)"}[unit]


def _pictures(name: str, shown: Row, kinds: tuple[str, ...]) -> str:
    if name not in PRIMITIVES:
        return ""
    kind = kinds[0] if kinds else "woman"
    ends = dict.fromkeys((shown.low, shown.high))
    near = WHOLE if name.startswith("head.") else NEAR
    lines = ((f"show {name} {end}{OPENED.get(name, '')}", end) for end in ends)
    return row(f"{portrait(line, f'A {kind}: {name} {end}.', kind, near=near)}\n`{name} {end}`" for line, end in lines)
