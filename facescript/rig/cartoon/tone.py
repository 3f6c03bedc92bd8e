"""Muscles -> how strongly lines, folds and blush show."""

from __future__ import annotations

import numpy as np

from facescript.performance.channels import SIDES
from facescript.rig.cartoon.pen import Floats, step

Columns = dict[str, Floats]


def tones(named: Columns) -> Columns:
    """Opacity 0..1 by part, of those that muscles change: array[frame]."""
    out: Columns = {}
    for side in SIDES:
        cheek, smile, nose = (named[f"{muscle}.{side}"] for muscle in ("cheek.upper", "cheek.lower", "nose.upper"))
        out[f"eye-pouch-{side}"] = np.minimum(0.34 * cheek + 0.18 * nose, 0.5)
        out[f"eye-crows-{side}"] = np.minimum(0.34 * cheek * (0.35 + 0.65 * np.minimum(smile, 1.0)), 0.4)
    brow_in, brow_out, brows, knit, nose, chin = (
        (named[f"{muscle}.left"] + named[f"{muscle}.right"]) / 2
        for muscle in ("brow.inner", "brow.outer", "forehead", "brow.lower", "nose.upper", "chin")
    )
    out["brow-furrow"] = np.minimum(0.50 * knit + 0.10 * nose, 0.6)
    out["forehead-lines"] = np.minimum(0.22 * brow_in + 0.12 * brow_out + 0.34 * brows, 0.36)
    out["nose-wrinkles"] = np.minimum(0.44 * nose, 0.50)
    out["chin-lines"] = np.minimum(0.34 * chin, 0.4)
    turned = np.sin(np.radians(named["head.yaw"]))
    for side, near in (("left", -turned), ("right", turned)):
        out[f"ear-near-{side}"] = step(0.02, 0.36, near)
        out[f"ear-near-inner-{side}"] = 0.6 * step(0.02, 0.36, near)
        out[f"nose-edge-{side}"] = 0.62 * step(0.20, 0.70, -near)
    return out
