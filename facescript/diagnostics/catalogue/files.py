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
)
