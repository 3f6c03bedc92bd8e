"""What a row of the catalogue of diagnostics holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from facescript.diagnostics.model import Severity


@dataclass(frozen=True, slots=True)
class Entry:
    """One code. `sentence` is a `str.format` template; `bad` and `good` are whole scripts, run by the tests.

    `files` are further files that both scripts may read (`use`, `repeat NAME in "x.csv"`); `stage` is the command
    that reports the code for `bad`; `good` gives no diagnostic of this code. `why` is a line or two for the manual.
    At the stage "command", `bad` is `script.face` and `command` the words after `facescript` that give the code;
    "unforced" codes report faults of the machine that no example can bring about.
    """

    code: str
    name: str
    severity: Severity
    sentence: str
    bad: str
    good: str
    why: str = ""
    stage: str = "check"
    files: Mapping[str, str] = field(default_factory=dict)
    command: tuple[str, ...] = ()
