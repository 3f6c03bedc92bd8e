"""Channels to the measures of lids, lips and tongue that other faces have shapes for, and measures back to channels.

A lid's channel is how it is drawn, gaze included; a face elsewhere moves it with gaze by itself, so shapes want how far
it is shut beyond that. A mouth's gap is one channel here; elsewhere the jaw opens it, lips hold it or part further.
"""

from __future__ import annotations

import numpy as np

from facescript.performance.channels import INDEX, POSE, SIDES
from facescript.performance.limits import LID_FLOOR, Floats, gaze_on_lid
from facescript.performance.performance import REST

MEASURES = (
    *(f"shut.{side}" for side in SIDES),
    *("lips.raised", "lips.parted", "lips.held", "lips.rise", "lips.sink", "tongue.out"),
)
"""`shut.*` how far a lid is shut beyond what gaze does, as `lid.*`; of the gap between the lips, in MNS0: `lips.raised`
what the upper lip makes of it over an open jaw, `lips.parted` what both lips part further, `lips.held` by how much they
are nearer than the jaw would have them; `lips.rise` and `lips.sink` how far the edge of either moves from rest;
`tongue.out` 0..1 how far the tongue is out between the teeth."""

COLUMNS = (*(channel.name for channel in POSE), *MEASURES)
"""What tables of shapes speak of: the channels, counted from their rest, and the measures."""

AT = {name: number for number, name in enumerate(COLUMNS)}

JAW_DOWN = 1.2
"""MNS0 by which a jaw that is down takes the lower lip along (`speech.mouth.visemes`)."""

OUT = 0.8
"""The value of `mouth.tongue` from which on the tongue comes out (`rig.cartoon.mouth.BEHIND`)."""

LIP = 0.8
"""MNS0 by which a shape of one lip moves it: `lips.raised` 1.25 and twice `lips.parted` 0.625 in `arkit.csv`."""

SHOWN, JAWED, TUCKED = 0.85, 0.4, 3.0
"""How much of the teeth shows, as far as no shape says: between lips that part, between open jaws, and for each MNS0 by
which a lower lip is tucked under them."""

OPENED = 0.05
"""MNS0 from which on open lips count as open for the teeth."""


def measured(poses: Floats) -> Floats:
    """array[n, POSE] to array[n, COLUMNS]."""
    found = np.empty((len(poses), len(COLUMNS)))
    np.subtract(poses, REST, out=found[:, : len(POSE)])
    found[:, _SHUT] = shut(poses[:, _LIDS], poses[:, _PITCHES])
    opened, upper, lower, jaw, tongue = poses[:, _MOUTH].T
    raised = np.minimum(np.maximum(upper, 0.0), JAW_DOWN * jaw)
    beyond = opened - raised - JAW_DOWN * jaw
    slack = opened - np.maximum(upper, 0.0) - np.maximum(lower, 0.0)
    out = np.clip((tongue - OUT) / (1.0 - OUT), 0.0, 1.0)
    told = (raised, np.maximum(beyond, 0.0), np.maximum(-beyond, 0.0), upper + 0.2 * slack, lower + 0.8 * slack, out)
    found[:, _SHUT[-1] + 1 :] = np.stack(told, axis=1)
    return found


_SHUT = [AT[f"shut.{side}"] for side in SIDES]
_LIDS = [INDEX[f"lid.{side}"] for side in SIDES]
_PITCHES = [INDEX[f"eye.{side}.pitch"] for side in SIDES]
_MOUTH = [INDEX[f"mouth.{part}"] for part in ("open", "upper", "lower", "jaw", "tongue")]


def shut(lid: Floats, pitch: Floats) -> Floats:
    """How far a lid is shut that is drawn at `lid`, beyond what an eye turned up by `pitch` deg does."""
    return np.clip(1.0 - (1.0 - lid) / gaze_on_lid(pitch), LID_FLOOR, 1.0)


def lid_of(closed: Floats, pitch: Floats) -> Floats:
    """The lid as it is drawn: the inverse of `shut`."""
    return np.clip(1.0 - (1.0 - closed) * gaze_on_lid(pitch), LID_FLOOR, 1.0)


def posed(columns: Floats) -> Floats:
    """The channels of array[n, COLUMNS]: array[n, POSE]; measures are left to those who know which they have."""
    return columns[:, : len(POSE)] + REST


def lids_from_shut(poses: Floats, columns: Floats) -> None:
    """Set the lids from how far they are shut beyond gaze."""
    poses[:, _LIDS] = lid_of(columns[:, _SHUT], poses[:, _PITCHES])


def mouth_from_jaw(poses: Floats, columns: Floats) -> None:
    """Set the gap between the lips from jaw and lips, where upper and lower lip are told by their muscles alone.

    A raised upper lip over an open jaw is the mouth's, not its muscle's; so is what both lips part alike, both sides.
    """
    jaw = JAW_DOWN * poses[:, INDEX["mouth.jaw"]]
    upper = _both(poses, "lip.upper", np.minimum(_least(poses, "lip.upper"), jaw / LIP))
    parted = np.minimum(_least(poses, "lip.upper"), _least(poses, "lip.lower"))
    for muscle in ("lip.upper", "lip.lower"):
        _both(poses, muscle, parted)
    sunk = np.maximum(jaw - columns[:, AT["lips.held"]], 0.0)
    poses[:, INDEX["mouth.open"]] = np.maximum(
        jaw - columns[:, AT["lips.held"]] + LIP * upper + 2.0 * LIP * parted, 0.0
    )
    poses[:, INDEX["mouth.upper"]] += LIP * upper
    poses[:, INDEX["mouth.lower"]] += sunk


def mouth_from_lips(poses: Floats, columns: Floats) -> None:
    """Set the gap between the lips from where their edges are."""
    rise, sink = columns[:, AT["lips.rise"]], columns[:, AT["lips.sink"]]
    poses[:, INDEX["mouth.open"]] = np.maximum(rise, 0.0) + np.maximum(sink, 0.0)
    poses[:, INDEX["mouth.upper"]] = rise
    poses[:, INDEX["mouth.lower"]] = sink


def teeth_shown(poses: Floats) -> None:
    """Set how much of the teeth shows as open lips usually show it."""
    seen = measured(poses)
    opened, rounded = np.maximum(poses[:, INDEX["mouth.open"]], 0.0), poses[:, INDEX["mouth.round"]]
    share = seen[:, AT["lips.parted"]] / (opened + 0.02)
    apart = share * SHOWN + (1.0 - share) * JAWED * (1.0 - np.clip(rounded, 0.0, 1.0))
    tucked = TUCKED * np.maximum(-poses[:, INDEX["mouth.lower"]], 0.0)
    poses[:, INDEX["mouth.teeth"]] = np.clip(np.maximum(apart * np.clip(opened / OPENED, 0.0, 1.0), tucked), 0.0, 1.0)


def tongue_of(out: Floats) -> Floats:
    """The tongue that is `out` so far; it comes up to the teeth in the first twentieth of that."""
    return np.clip(20.0 * out, 0.0, 1.0) * OUT + out * (1.0 - OUT)


def _least(poses: Floats, muscle: str) -> Floats:
    return np.minimum(*(poses[:, INDEX[f"{muscle}.{side}"]] for side in SIDES))


def _both(poses: Floats, muscle: str, less: Floats) -> Floats:
    """Take `less` from both sides of a muscle, and give it back."""
    for side in SIDES:
        poses[:, INDEX[f"{muscle}.{side}"]] -= less
    return less
