"""A take to the poses that it shows, and to the channels that it tells of."""

from __future__ import annotations

import base64
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from facescript.ir.acts import Take
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST
from facescript.shapes import arkit, fap
from facescript.shapes.solver import Floats

ROTATED = ("HeadYaw", "HeadPitch", "HeadRoll")

LOOKED = tuple(name for name in arkit.NAMES if name.startswith("EyeLook") or "Eye" in name[4:8])
"""What tells of the eyes: look shapes and rotations."""


@dataclass(frozen=True, slots=True)
class Played:
    """Poses at times (s): `times` array[n], `poses` array[n, POSE]. The others of `channels` are at rest in them."""

    times: Floats
    poses: Floats
    channels: tuple[str, ...]


@lru_cache(maxsize=8)
def played(take: Take) -> Played:
    """What a take shows: it is worked out once for all that play it."""
    data = np.frombuffer(base64.b64decode(take.data), dtype="<f4").reshape(take.frames, -1).astype(np.float64)
    times, values = data[:, 0], data[:, 1:]
    if take.kind == "arkit":
        return Played(times, *_of_arkit(take.columns, values))
    if take.kind == "fap":
        whole = np.zeros((take.frames, len(fap.NAMES)))
        whole[:, [fap.INDEX[name] for name in take.columns]] = values
        return Played(times, fap.poses(whole, take.columns), fap.channels(take.columns))
    poses = np.repeat(REST[None], take.frames, axis=0)
    poses[:, [INDEX[name] for name in take.columns]] = values
    return Played(times, poses, take.columns)


def _of_arkit(columns: tuple[str, ...], values: Floats) -> tuple[Floats, tuple[str, ...]]:
    """A head or eyes that are never turned are not told of: programs that do not know of them write zeros."""
    whole = np.zeros((len(values), len(arkit.NAMES)))
    whole[:, [arkit.INDEX[name] for name in columns]] = values
    still = [group for group in (ROTATED, LOOKED) if not np.any(whole[:, [arkit.INDEX[name] for name in group]])]
    told = tuple(name for name in columns if not any(name in group for group in still))
    return arkit.poses(whole), arkit.channels(told)
