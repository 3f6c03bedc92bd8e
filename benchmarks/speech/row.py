"""What a bar of speech is measured to be: a row of the table that `make speech` prints."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Row:
    """`what` is measured, the `bar` it is held to, what was `found`, in words, and whether that is `met` (None: told
    for comparison, held to nothing)."""

    what: str
    bar: str
    found: str
    met: bool | None

    def __str__(self) -> str:
        verdict = {True: "met", False: "NOT MET", None: "told"}[self.met]
        return f"| {self.what} | {self.bar} | {self.found} | {verdict} |"
