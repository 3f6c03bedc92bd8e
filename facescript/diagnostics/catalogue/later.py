"""Codes FS8xx, what only a live run has, and what the language has and this version does not run."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

LATER: tuple[Entry, ...] = (
    Entry(
        "FS806",
        "live-people",
        Severity.HINT,
        "Nobody is there in a build: `people` are those who arrive, live or by `event TARGET arrives at 2s`, and no "
        "`event` of the script brings any.",
        "scan people, 600ms each\n",
        "target ann at 40cm 0cm 2m\nscan people, 600ms each\nevent ann arrives at 1s\n",
    ),
    Entry(
        "FS807",
        "later-people-passes",
        Severity.ERROR,
        "`repeat` over `people` is not in this version: who will be there is not known when its passes are made.",
        "target ann at 40cm 0cm 2m\nrepeat one in people:\n    look at one\nevent ann arrives at 1s\n",
        "target crowd of (-60cm 0cm 2m) (50cm 10cm 2m)\nrepeat one in crowd:\n    look at one\n",
    ),
    Entry(
        "FS808",
        "live-reaction",
        Severity.HINT,
        "Only `facescript live` can start this reaction; no `event` in the script is of its kind.",
        'nod\nwhen heard "no":\n    nod\n',
        'nod\nwhen heard "no":\n    nod\nevent heard "no" at 1s\n',
    ),
)
