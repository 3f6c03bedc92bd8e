"""Key frames of one attribute, and the SMIL element that plays them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from lxml import etree

SVG = "http://www.w3.org/2000/svg"


@dataclass(frozen=True, slots=True)
class Clock:
    """The animations' common length: a power of ten seconds, so that whole milliseconds are short fractions of it."""

    seconds: float
    digits: int

    @classmethod
    def around(cls, duration: float) -> Clock:
        """The clock of a film of `duration` seconds."""
        seconds, digits = 1.0, 3
        while seconds < duration:
            seconds, digits = seconds * 10, digits + 1
        return cls(seconds, digits)

    def fraction(self, time: float) -> str:
        """A time as a key time, without what need not be written."""
        text = f"{time / self.seconds:.{self.digits}f}".rstrip("0").rstrip(".")
        return text.removeprefix("0") or "0"


@dataclass(frozen=True, slots=True)
class Track:
    """Key frames of one attribute: times in seconds from the start, and the attribute's text at each."""

    times: Sequence[float]
    values: Sequence[str]

    @property
    def still(self) -> bool:
        return len(set(self.values)) == 1


def animate(element: etree._Element, attribute: str, track: Track, clock: Clock) -> None:
    """Give an element its attribute's first value, and the animation of the rest where there is any."""
    element.set(attribute, track.values[0])
    if track.still:
        return
    times, values = [*map(clock.fraction, track.times)], list(track.values)
    if times[-1] != "1":
        times, values = [*times, "1"], [*values, values[-1]]
    words = {"attributeName": attribute, "dur": f"{clock.seconds:g}s", "fill": "freeze"}
    words |= {"keyTimes": ";".join(times), "values": ";".join(values)}
    etree.SubElement(element, f"{{{SVG}}}animate", words)
