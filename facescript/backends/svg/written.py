"""Key frames in whole numbers to tracks of SVG's text."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.carry import ANGLE, PLACE, SIZE, Carrier
from facescript.backends.svg.curves import Curves
from facescript.backends.svg.ease import Keys
from facescript.backends.svg.ground import SHADE
from facescript.backends.svg.path import decimal, numbers, path_text
from facescript.backends.svg.slide import Slide
from facescript.backends.svg.track import Carried, Track

Ints = NDArray[np.int64]


def outline_track(keys: Keys, curved: Curves, start: float) -> Track:
    """An outline in the middle of all, and what is added to it: differences are short."""
    values = [row.reshape(-1, 2) for row in keys.values]
    base = values[0] if len(values) < 3 else np.rint(np.median(values, axis=0)).astype(np.int64)
    added = tuple(path_text(value - base, curved.chains) for value in values)
    times = tuple(time - start for time in keys.times)
    return Track(times, added, keys.eases, base=path_text(base, curved.chains))


def slide_track(slide: Slide, start: float) -> Track:
    texts = [numbers(place) for place in slide.keys.values]
    return Track([time - start for time in slide.keys.times], texts, slide.keys.eases)


def carrier_tracks(carrier: Carrier, start: float) -> tuple[Carried, ...]:
    """A carrier as SMIL's transforms, outermost first."""
    places, sizes = (
        [f"{decimal(x * step)} {decimal(y * step)}" for x, y in keys.values]
        for keys, step in ((carrier.places, PLACE), (carrier.sizes, SIZE))
    )
    turns, skews = ([decimal(values[at] * ANGLE) for values in carrier.angles.values] for at in (0, 1))
    kinds = (
        ("translate", places, carrier.places),
        ("rotate", turns, carrier.angles),
        ("skewX", skews, carrier.angles),
        ("scale", sizes, carrier.sizes),
    )
    return tuple(
        Carried(kind, Track([time - start for time in keys.times], texts, keys.eases)) for kind, texts, keys in kinds
    )


def shade_track(keys: list[tuple[float, Ints]], start: float) -> Track:
    texts = tuple(f"{min(max(values[0] * SHADE, 0.0), 1.0):.2f}".rstrip("0").rstrip(".") for _, values in keys)
    return Track(tuple(time - start for time, _ in keys), texts)
