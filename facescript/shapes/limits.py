"""How far each channel and measure goes, for what is read back from shapes."""

from __future__ import annotations

import re

import numpy as np

from facescript.performance.limits import LID_FLOOR, Floats
from facescript.shapes.measures import COLUMNS

LIMITS = (
    (r"head\.(yaw|pitch|roll)", 90.0, 90.0),
    (r"head\.[xy]", 100.0, 100.0),
    (r"eye\..*\.(yaw|pitch|roll)", 60.0, 60.0),
    (r"eye\..*\.[xy]", 2.0, 2.0),
    (r".*scale", 0.9, 9.0),
    (r"pupil\..*", 0.9, 2.0),
    (r"(lid|shut)\..*", -LID_FLOOR, 1.0),
    (r"ear\..*", 1.0, 1.0),
    (r"mouth\.(open|jaw|round|teeth|tongue)", 0.0, 3.0),
    (r"mouth\..*|lips\.(rise|sink)", 1.0, 3.0),
    (r"lips\.held", 0.0, 3.0),
    (r"gaze\..*|hair\..*", 180.0, 180.0),
)
"""By a pattern of its name, how far each goes below and above its rest; all others go from 0 to 1."""


def limits() -> tuple[Floats, Floats]:
    """The lowest and the highest of each column, from its rest."""
    found = [_limit(name) for name in COLUMNS]
    return np.array([-low for low, _ in found]), np.array([high for _, high in found])


def _limit(name: str) -> tuple[float, float]:
    return next(((low, high) for pattern, low, high in LIMITS if re.fullmatch(pattern, name)), (0.0, 1.0))
