"""Diagnostics FS980 to FS989: the addresses that a live run goes to."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

HELLO = 'say "Hello."\n'

ADDRESSES = (
    Entry(
        "FS980",
        "sink-kind",
        Severity.ERROR,
        "`{address}` is no address that a run can go to; write one such as {known}.",
        HELLO,
        HELLO,
        "What stands before the colon says who is there; the manual's table of streams has them all.",
        stage="command",
        command=("live", "script.face", "--to", "smoke://127.0.0.1"),
    ),
    Entry(
        "FS981",
        "address-form",
        Severity.ERROR,
        "`{address}` cannot be read: {reason}; write for example `{example}`.",
        HELLO,
        HELLO,
        "An address names a host and a port, and after a `?` what is asked for besides.",
        stage="command",
        command=("live", "script.face", "--to", "osc://127.0.0.1"),
    ),
    Entry(
        "FS982",
        "address-unusable",
        Severity.ERROR,
        "`{address}` cannot be used: {reason}.",
        HELLO,
        HELLO,
        "Another program has that port, this machine has no such address, or the script has no such face.",
        stage="command",
        command=("live", "script.face", "--to", "vmc://127.0.0.1?face=bob"),
    ),
    Entry(
        "FS983",
        "stream-token",
        Severity.ERROR,
        "`{address}` is open to other machines, which need a token: give one with `--token`, or listen at 127.0.0.1.",
        HELLO,
        HELLO,
        "Who reaches the address could watch the run; with a token only who knows it can.",
        stage="command",
        command=("live", "script.face", "--to", "ws://0.0.0.0:8765"),
    ),
)
