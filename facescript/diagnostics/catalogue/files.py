"""Codes FS7xx, files that scripts name."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

FILES: tuple[Entry, ...] = (
    Entry(
        "FS701",
        "file-unreadable",
        Severity.ERROR,
        "“{path}” cannot be used: {reason}.",
        'use "missing.face"\nnod\n',
        'use "studio.face"\nnod\n',
        "Paths are relative to the script, and stay inside the project's folder.",
        files={"studio.face": "let beat = 1s\n"},
    ),
    Entry(
        "FS702",
        "use-circle",
        Severity.ERROR,
        "The scripts use each other in a circle: {chain}.",
        'use "a.face"\nnod\n',
        'use "c.face"\nnod\n',
        files={"a.face": 'use "b.face"\n', "b.face": 'use "a.face"\n', "c.face": "let beat = 1s\n"},
    ),
    Entry(
        "FS703",
        "table",
        Severity.ERROR,
        "The table “{path}” cannot be used: {reason}.",
        'repeat trial in "ragged.csv":\n    wait trial.soa\n',
        'repeat trial in "trials.csv":\n    wait trial.soa\n',
        "The first line of a table names its columns.",
        files={"ragged.csv": "soa,cue\n105ms\n", "trials.csv": "soa,cue\n105ms,left\n"},
    ),
    Entry(
        "FS704",
        "no-column",
        Severity.ERROR,
        "`{name}` is no column of “{file}”; it has {known}.",
        'repeat trial in "trials.csv":\n    wait trial.delay\n',
        'repeat trial in "trials.csv":\n    wait trial.soa\n',
        files={"trials.csv": "soa,cue\n105ms,left\n"},
    ),
    Entry(
        "FS705",
        "table-empty",
        Severity.WARNING,
        "The table “{path}” has no rows, so nothing is repeated.",
        'repeat trial in "empty.csv":\n    wait trial.soa\n',
        'repeat trial in "trials.csv":\n    wait trial.soa\n',
        files={"empty.csv": "soa,cue\n", "trials.csv": "soa,cue\n105ms,left\n"},
    ),
    Entry(
        "FS706",
        "track",
        Severity.ERROR,
        "The track “{path}” cannot be followed: {reason}.",
        'target fly from "flat.csv"\nlook at fly\n',
        'target fly from "track.csv"\nlook at fly\n',
        "The first line names the columns: `time` and either `x`, `y`, `z` or `azimuth`, `elevation`, `distance`; "
        "others are passed over. Times are in seconds from the scene's start, angles in degrees, all else in "
        "centimetres. The tracks of a script have 250,000 rows at most: over an hour at 60 a second.",
        files={"flat.csv": "time,x,y\n0,-30,0\n", "track.csv": "frame,time,x,y,z\n1,0,-30,0,200\n2,0.5,30,0,200\n"},
    ),
    Entry(
        "FS707",
        "track-cell",
        Severity.ERROR,
        "`{text}` in row {row}, column `{column}` of “{path}” {reason}.",
        'target fly from "words.csv"\nlook at fly\n',
        'target fly from "track.csv"\nlook at fly\n',
        "A place that is empty, `nan` or `inf` is none: the target is not seen then. A time is always a number.",
        files={
            "words.csv": "time,x,y,z\n0,left,0,200\n",
            "track.csv": "time,x,y,z\n0,-30,0,200\n0.1,nan,nan,nan\n0.2,,,\n0.3,30,0,200\n",
        },
    ),
    Entry(
        "FS708",
        "track-order",
        Severity.ERROR,
        "The time `{text}` of row {row} of “{path}” does not come after the one before it.",
        'target fly from "twice.csv"\nlook at fly\n',
        'target fly from "track.csv"\nlook at fly\n',
        files={
            "twice.csv": "time,x,y,z\n0,-30,0,200\n0,30,0,200\n",
            "track.csv": "time,x,y,z\n0,-30,0,200\n0.1,30,0,200\n",
        },
    ),
    Entry(
        "FS720",
        "picture",
        Severity.ERROR,
        "The picture “{path}” cannot be used: {reason}.",
        'background "notes.png"\nnod\n',
        "background #dfe8f2\nnod\n",
        "A picture is a PNG, JPEG, WebP, GIF or BMP file of at most 64 million pixels. Its bytes count, not its name: "
        "save it anew as one of these.",
        files={"notes.png": "Buy a picture of the sea.\n"},
    ),
    Entry(
        "FS730",
        "take",
        Severity.ERROR,
        "“{path}” cannot be played: {reason}.",
        'play "notes.csv"\n',
        'play "take.csv"\n',
        "A recorded face is a CSV of Live Link Face (`Timecode`, and shapes of ARKit by name), a `.fap` file of "
        "MPEG-4, or a CSV with `time` in seconds and channels by name, as `build` writes them. It has 36,000 rows and "
        "lasts an hour at most.",
        files={
            "notes.csv": "frame,smile\n0,0.5\n",
            "take.csv": "time,cheek.lower.left,cheek.lower.right\n0,0,0\n0.5,0.6,0.4\n1,0.2,0.1\n",
        },
    ),
    Entry(
        "FS731",
        "take-lost",
        Severity.WARNING,
        "In {lost} of the {rows} rows of “{path}” no face was seen; what is before and after is joined.",
        'play "gaps.csv"\n',
        'play "whole.csv"\n',
        "Live Link Face writes a row without shapes where the phone has lost the face.",
        files={
            "gaps.csv": "Timecode,BlendshapeCount,JawOpen\n0:00:00:01.0,1,0.1\n0:00:00:02.0,0,\n0:00:00:03.0,1,0.4\n",
            "whole.csv": "Timecode,BlendshapeCount,JawOpen\n0:00:00:01.0,1,0.1\n0:00:00:02.0,1,0.2\n",
        },
    ),
)
