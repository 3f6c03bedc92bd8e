"""What a face cannot exceed, as functions: the soft limit of what adds up, and how far gaze moves a lid."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

KNEE = 0.8
"""A muscle's contraction up to which the soft limit changes nothing."""

LID_FLOOR = -0.35
"""The widest a lid opens: 1 is shut, 0 open at rest."""

LID_TRAVEL = 48.0
"""Degrees the upper lid turns from rest to shut (a voluntary blink: 43.1 +- 7.9; `motion.md` 5)."""

LID_GAIN = 0.95
"""Degrees a lid turns for a degree of the eye's pitch (bar B7: 0.85 to 1.1)."""


def soft_limit(value: Floats) -> Floats:
    """Rule 1: contraction within 0..1; the identity from 0 to 0.8, above it 0.8 + 0.2 tanh((x - 0.8) / 0.2)."""
    value = np.asarray(value, dtype=np.float64)
    limited, high = np.maximum(value, 0.0), value > KNEE
    limited[high] = KNEE + (1.0 - KNEE) * np.tanh((value[high] - KNEE) / (1.0 - KNEE))
    return limited


def gaze_on_lid(pitch: Floats) -> Floats:
    """Rule 2: the opening's factor for an eye turned up by `pitch` deg: up widens, down closes, never wholly."""
    shift = np.asarray(pitch, dtype=np.float64) * (LID_GAIN / LID_TRAVEL)
    return 1.0 - LID_FLOOR * soft_limit(shift / -LID_FLOOR) - soft_limit(-shift)
