"""Codes FS6xx, targets that cannot be reached."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

GAZE: tuple[Entry, ...] = (
    Entry(
        "FS601",
        "target-out-of-reach",
        Severity.WARNING,
        "At {time} this target is {short} beyond what eyes and head reach: the gaze stops short of it.",
        "target door at 150deg 0deg 2m\nlook at door\n",
        "target door at 70deg 0deg 2m\nlook at door\n",
        "The eyes reach 45 degrees sideways, 28 up and 47 down in the head, the head 45 sideways, 30 up and down. What "
        "lies behind a face is out of reach. The angle is what is drawn: for a target in front of the screen, the "
        "film's `screen` fraction of the true one. A moving target is judged by where it is while it is looked at.",
    ),
    Entry(
        "FS602",
        "target-out-of-reach-of-one",
        Severity.WARNING,
        "At {time} the {part} alone {stay} {short} short of this target; together eyes and head go further.",
        "film screen none\ntarget window at 60deg 0deg 2m\nlook at window, eyes only\n",
        "film screen none\ntarget window at 60deg 0deg 2m\nlook at window\n",
        "With `eyes only` the head stays as it is, with `head only` the eyes keep what they have: what lies beyond the "
        "reach of the one (45 degrees sideways) is not reached, and nothing else helps.",
    ),
    Entry(
        "FS603",
        "target-leaves-reach",
        Severity.WARNING,
        "At {time} this target is {short} beyond what eyes and head reach: for a part of the time gaze lets go of it.",
        "target walker moves\n    0s -80cm 0cm 1m\n    4s 80cm 0cm -1m\n    8s 80cm 0cm 1m\nlook at walker\n",
        "target walker moves\n    0s -80cm 0cm 1m\n    8s 80cm 0cm 1m\nlook at walker\n",
        "A target that moves out of reach is looked after for half a second, then the eyes go back to the camera; when "
        "it is back it is found again. One that is out of reach all the while is FS601.",
    ),
    Entry(
        "FS604",
        "target-lost",
        Severity.WARNING,
        "Where this target is while it is looked at is not in its track: there is nothing to see.",
        'target ann from "track.csv"\nlook at ann for 1s\n',
        'target ann from "track.csv"\nwait 1.5s\nlook at ann for 1s\n',
        "A target that is lost in its track is let go of like one that leaves reach, and found again once it is back.",
        files={"track.csv": "time,x,y,z\n0,,,\n1.5,-30,0,200\n3,30,0,200\n"},
    ),
    Entry(
        "FS605",
        "looks-together",
        Severity.WARNING,
        "Two looks of `{face}` take its {part} at {start}: this one is later in the script and wins{until}.",
        "together:\n    look left 20deg\n    look right 10deg\n",
        "together:\n    look left 20deg, head only\n    look right 10deg, eyes only\n",
        "One of them is for nothing. Put one after the other, or part eyes from head: `head only` and `eyes only`.",
    ),
    Entry(
        "FS606",
        "look-too-short",
        Severity.WARNING,
        "{what} is over at {end}: the {part} of `{face}` would be there at {landed}, {need} after its start.",
        "look left 20deg for 30ms\n",
        "look left 20deg for 300ms\n",
        "The eyes take 25 ms and 2.7 ms a degree, the head some 300 ms and more. Give the look more time, or let it "
        "jump: `over 0ms`. What the event of a reaction interrupts is not told.",
    ),
    Entry(
        "FS607",
        "look-too-fast",
        Severity.WARNING,
        "The {part} cannot turn that fast: for {far} this takes {needs}, and that is how long it will take.",
        "look left 40deg over 20ms\n",
        "look left 40deg over 200ms\n",
        "Eyes turn at most twice as fast as people's do and at 550 degrees a second, the head at 250. `over 0ms` is at "
        "once: a cut, which experiments need.",
    ),
    Entry(
        "FS608",
        "head-too-fast",
        Severity.WARNING,
        "Head and eyes cannot move that fast: this takes {needs}, and that is how long it will take.",
        "nod for 100ms\n",
        "nod for 500ms\n",
        "A head turns at 250 degrees a second at most, an eye at 550, and a blink lasts 150 ms at least. `over 0ms` is "
        "at once.",
    ),
)
