"""Names of muscles, lids and other channels to what they drive, with both sides where none is named."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.performance.channels import CHANNELS, SIDES
from facescript.resolve.units import ANGLE, LENGTH, SHARE


@dataclass(frozen=True, slots=True)
class Primitive:
    """What a name drives: driver names, what its amount measures, and the largest degree of sense (None: any)."""

    names: tuple[str, ...]
    kind: str
    largest: float | None = None


def _table() -> dict[str, Primitive]:
    kinds = {"deg": ANGLE, "cm": LENGTH, "1": SHARE}
    table = {f"blink.{side}": Primitive((f"blink.{side}",), SHARE, 1.0) for side in SIDES}
    for channel in CHANNELS:
        if not channel.name.startswith("gaze."):
            largest = None if channel.name.startswith(("mouth.", "head.", "eye.", "pupil.")) else 1.0
            table[channel.name] = Primitive((channel.name,), kinds[channel.unit], largest)
    for name in list(table):
        if ".left" in name:
            both = (name, name.replace(".left", ".right"))
            table[name.replace(".left", "")] = Primitive(both, table[name].kind, table[name].largest)
    return table


PRIMITIVES: dict[str, Primitive] = _table()
"""By the name an author writes: `brow.inner`, `brow.inner.left`, `lid`, `head.roll`, `eye.left.pitch`."""


def side_of(driver: str) -> str:
    """ "left", "right", or "" for a driver of the whole face."""
    for side in SIDES:
        if driver.endswith(f".{side}") or driver.startswith(f"eye.{side}."):
            return side
    return ""
