"""Key frames of one attribute, and the SMIL element that plays them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from lxml import etree

SVG = "http://www.w3.org/2000/svg"

UNCHANGED = ("0 0", "0", "1 1")
"""Values of transforms that do nothing."""

STRAIGHT = (0.0, 0.0, 1.0, 1.0)
"""The ease of a straight way."""


@dataclass(frozen=True, slots=True)
class Track:
    """Key frames of one attribute: times in seconds from the start, the attribute's text at each, and the ease of the
    way to each from the one before (none: all straight). Where there is a `base`, values are added to it."""

    times: Sequence[float]
    values: Sequence[str]
    eases: Sequence[tuple[float, ...]] = ()
    base: str | None = None

    @property
    def still(self) -> bool:
        return len(set(self.values)) == 1


@dataclass(frozen=True, slots=True)
class Carried:
    """One transform over time: `kind` is SMIL's word for it."""

    kind: str
    track: Track

    @property
    def matters(self) -> bool:
        """Whether it ever changes anything."""
        return not self.track.still or self.track.values[0] not in UNCHANGED


def svg(tag: str, **attributes: str) -> etree._Element:
    """An element of SVG; in attributes' names `_` stands for `-`, and one at the end is dropped."""
    named = {name.rstrip("_").replace("_", "-"): value for name, value in attributes.items()}
    return etree.Element(f"{{{SVG}}}{tag}", named, nsmap={None: SVG})


@dataclass(frozen=True, slots=True)
class Clock:
    """The animations' common length: eight times a power of ten seconds, so that whole multiples of eight milliseconds
    are short fractions of it."""

    seconds: float

    @classmethod
    def around(cls, duration: float) -> Clock:
        """The clock of a film of `duration` seconds."""
        seconds = 8.0
        while seconds < duration:
            seconds *= 10
        return cls(seconds)

    def fraction(self, time: float) -> str:
        """A time as a key time, to the microsecond, without what need not be written."""
        text = f"{time / self.seconds:.8f}".rstrip("0").rstrip(".")
        return text.removeprefix("0") or "0"


def animate(element: etree._Element, attribute: str, track: Track, clock: Clock) -> None:
    """Give an element its attribute's first value, and the animation of the rest where there is any."""
    element.set(attribute, track.values[0] if track.base is None else track.base)
    if not track.still:
        added = {} if track.base is None else {"additive": "sum"}
        element.append(svg("animate", attributeName=attribute, **added, **_course(track, clock)))


def carry(element: etree._Element, carried: Sequence[Carried], clock: Clock) -> None:
    """Transform an element over time, the first transform outermost; what never changes is written once."""
    if all(part.track.still for part in carried):
        element.set("transform", " ".join(f"{part.kind}({part.track.values[0]})" for part in carried if part.matters))
        return
    for number, part in enumerate(part for part in carried if part.matters):
        added = {"additive": "sum"} if number else {}
        words = _course(part.track, clock)
        if part.track.still:
            words = {"dur": words["dur"], "fill": "freeze", "values": part.track.values[0]}
        element.append(svg("animateTransform", attributeName="transform", type=part.kind, **added, **words))


def _course(track: Track, clock: Clock) -> dict[str, str]:
    """The attributes of an animation that say when it is what."""
    times, values, eases = [*map(clock.fraction, track.times)], list(track.values), list(track.eases)
    if times[-1] != "1":
        times, values = [*times, "1"], [*values, values[-1]]
        eases += [STRAIGHT] if eases else []
    words = {"dur": f"{clock.seconds:g}s", "fill": "freeze", "keyTimes": ";".join(times), "values": ";".join(values)}
    if any(ease != STRAIGHT for ease in eases):
        words |= {"calcMode": "spline", "keySplines": ";".join(map(_spline, eases))}
    return words


def _spline(ease: Sequence[float]) -> str:
    return " ".join(f"{value:.2f}".rstrip("0").rstrip(".").removeprefix("0") or "0" for value in ease)
