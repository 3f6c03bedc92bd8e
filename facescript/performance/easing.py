"""Turns a share of a change's time (0..1) into the share of the change that is done (0..1)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from facescript.performance.polynomials import beta_3_5, beta_5_5, minimum_jerk

Floats = NDArray[np.float64]
Easing = Callable[[Floats], Floats]
"""Shares of time, array of any shape, to shares done. Outside 0..1 it holds its ends, exactly 0 and 1."""


def linear(share: Floats) -> Floats:
    """The same speed all the way: the only curve that starts and stops with a jerk."""
    return np.clip(share, 0.0, 1.0)


def smooth(share: Floats) -> Floats:
    """Minimum jerk (Flash and Hogan 1985): 10 x^3 - 15 x^4 + 6 x^5; at rest at both ends, peak speed 1.875 between."""
    done: Floats = minimum_jerk(np.clip(share, 0.0, 1.0))
    return done


def fall_out(share: Floats) -> Floats:
    """`out`: quick first, slow last; the beta(3, 5) distribution, peak speed 2.30 at a third of the time."""
    done: Floats = beta_3_5(np.clip(share, 0.0, 1.0))
    return done


def fall_in(share: Floats) -> Floats:
    """`in`: slow first, quick last; `out` run backwards."""
    return 1.0 - fall_out(1.0 - np.asarray(share, dtype=np.float64))


def in_out(share: Floats) -> Floats:
    """`in-out`: slower at both ends than `smooth`; the beta(5, 5) distribution, peak speed 2.46 at the middle."""
    done: Floats = beta_5_5(np.clip(share, 0.0, 1.0))
    return done


def through(*knots: tuple[float, float]) -> Easing:
    """A curve that is at rest at each of its knots (share, value), minimum jerk between."""
    places, values = (np.array(column) for column in zip(*knots, strict=True))

    def curve(share: Floats) -> Floats:
        x = np.clip(share, 0.0, 1.0)
        which = np.minimum(np.searchsorted(places, x, side="right") - 1, len(places) - 2)
        step = (x - places[which]) / (places[which + 1] - places[which])
        value: Floats = values[which] + (values[which + 1] - values[which]) * smooth(step)
        return value

    return curve


EASINGS: dict[str, Easing] = {"linear": linear, "smooth": smooth, "in": fall_in, "out": fall_out, "in-out": in_out}
"""The curves by the names an author writes after `ease`."""


def easing(name: str | None) -> Easing:
    """The curve of a name; `smooth` where an author named none."""
    return EASINGS[name or "smooth"]
