"""Names of channels to the panels that show them, for an author who asks for some."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from facescript.performance.channels import CHANNELS, SIDES
from facescript.resolve.kinds.library import kinds_with
from facescript.resolve.suggest import nearest

UNITS = {"deg": "degrees", "cm": "cm", "1": "shares"}
"""What the panel of a unit is called."""


class PlotFault(Exception):
    """A plot that cannot be drawn as it is asked for: a code and the values of its sentence."""

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code, self.values = code, values


@dataclass(frozen=True, slots=True)
class Curve:
    """A line of a panel: the mean of some channels. Without a colour it gets a look of its own in its panel."""

    label: str
    channels: tuple[str, ...]
    colour: str = ""
    dash: tuple[float, ...] = ()
    width: float = 1.4


@dataclass(frozen=True, slots=True)
class Panel:
    """Curves that share an axis of values; a left and a right side that are equal are drawn as one.

    `least` is the range that is always shown, `tall` how high the panel is beside others. A curve moves where it is
    ever as far from nought as `moves`: without one that does, the panel is left out, and where `each`, every curve
    that does not. `target` (0 yaw, 1 pitch) adds where the target of gaze is, `heard` the sound's energy.
    """

    title: str
    curves: tuple[Curve, ...]
    least: tuple[float, float]
    tall: float = 1.0
    moves: float = 0.0
    each: bool = False
    target: int | None = None
    heard: bool = False


def asked(names: Sequence[str], faces: Mapping[str, tuple[str, ...]]) -> dict[str, tuple[Panel, ...]]:
    """The panels of each face for the channels that are named: one a unit, curves in the order of the names.

    `faces` are those that are seen, with the channels they have. A name alone means every face that has it, `lid` or
    `eye.yaw` both sides. Raises `PlotFault` for what is no channel, or one that no face has.
    """
    wanted: dict[str, dict[str, None]] = {face: {} for face in faces}
    for name in names:
        for face, channel in _meant(name, faces):
            wanted[face][channel] = None
    return {face: tuple(_panels(list(channels))) for face, channels in wanted.items() if channels}


def _meant(name: str, faces: Mapping[str, tuple[str, ...]]) -> Iterator[tuple[str, str]]:
    """The faces and channels that a name means."""
    owner = next((face for face in faces if name.startswith(f"{face}.")), None)
    channels, owners = _known().get(name), tuple(faces)
    if channels is None and owner is not None:
        channels, owners = _known().get(name.removeprefix(f"{owner}.")), (owner,)
    if channels is None:
        front = f"{owner}." if owner is not None else ""
        near = nearest(name, [front + known for known in _known()])
        raise PlotFault("FS920", name=name, near=f"; did you mean `{near}`?" if near else ".")
    found = [(face, channel) for face in owners for channel in channels if channel in faces[face]]
    if not found:
        kinds = ", ".join(f"`{kind}`" for kind in kinds_with(channels[0]))
        raise PlotFault("FS920", name=name, near=f" of these faces; only these kinds have it: {kinds}.")
    yield from found


@cache
def _known() -> dict[str, tuple[str, ...]]:
    """What may be asked for: every channel, and names without their side for the channels of both sides."""
    names = [channel.name for channel in CHANNELS]
    found: dict[str, tuple[str, ...]] = {name: (name,) for name in names}
    for name in names:
        for side in SIDES:
            whole = ".".join(part for part in name.split(".") if part != side)
            if whole != name:
                found[whole] = (*found.get(whole, ()), name)
    return found


def _panels(names: Sequence[str]) -> Iterator[Panel]:
    units = {channel.name: channel.unit for channel in CHANNELS}
    for unit in dict.fromkeys(units[name] for name in names):
        curves = tuple(Curve(name, (name,)) for name in names if units[name] == unit)
        least = (0.0, 1.0) if unit == "1" else (-1.0, 1.0)
        yield Panel(UNITS[unit], curves, least, 1.2)
