"""Codes FS970 to FS979, live runs; `stage` is "command" and `command` its words."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

HELLO = 'say "Hello."\n'

LOG = '{"log": 1, "script": "other.face", "sha256": "0", "seed": 7, "fps": 60, "facescript": "1.0.0"}\n'

LIVE: tuple[Entry, ...] = (
    Entry(
        "FS970",
        "source-unknown",
        Severity.ERROR,
        "`--from {address}` is no source of events; there is {known}.",
        HELLO,
        HELLO,
        "What stands before the `:` says what kind of source it is.",
        stage="command",
        command=("live", "script.face", "--from", "pigeon://loft"),
    ),
    Entry(
        "FS971",
        "source-unusable",
        Severity.ERROR,
        "No events can come from `{address}`: {reason}.",
        HELLO,
        HELLO,
        "Another program has that port, or this machine has no such address.",
        stage="unforced",
    ),
    Entry(
        "FS973",
        "log-unreadable",
        Severity.ERROR,
        "`{name}` is no log of a run: {reason}.",
        HELLO,
        HELLO,
        "`--log` writes one.",
        files={"run.log": "hello\n"},
        stage="command",
        command=("live", "script.face", "--replay", "run.log"),
    ),
    Entry(
        "FS974",
        "log-of-another",
        Severity.ERROR,
        "`{name}` is the log of another run: of `{other}` as it was then, and `{script}` is not the same now.",
        HELLO,
        HELLO,
        "A log has the hash of the script and of the files that it uses. Another script would not do what was seen.",
        files={"run.log": LOG},
        stage="command",
        command=("live", "script.face", "--replay", "run.log"),
    ),
    Entry(
        "FS976",
        "trial-unreadable",
        Severity.ERROR,
        "`--trials {name}` has no such trial: {reason}.",
        HELLO,
        HELLO,
        "A table has a row a trial under a line that names its columns; rows are counted from 1.",
        files={"trials.csv": "degree\n30%\n"},
        stage="command",
        command=("live", "script.face", "--trials", "trials.csv", "--trial", "2"),
    ),
    Entry(
        "FS977",
        "trial-alone",
        Severity.ERROR,
        "`{option}` needs the other of `--trials FILE --trial N` beside it.",
        HELLO,
        HELLO,
        "A trial is a row of a table.",
        stage="command",
        command=("live", "script.face", "--trial", "2"),
    ),
    Entry(
        "FS978",
        "option-beside",
        Severity.ERROR,
        "`{option}` cannot stand beside {other}.",
        HELLO,
        HELLO,
        "A log has the events, the seed, the rate and the values of its run; a replay is that run.",
        files={"run.log": LOG},
        stage="command",
        command=("live", "script.face", "--replay", "run.log", "--seed", "3"),
    ),
)
