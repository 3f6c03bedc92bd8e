"""What was measured to rows of a table: each beside the band of its bar and the standing of its source."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

BARS_FILE = Path(__file__).parents[2] / "tests" / "motion" / "motion_bars.json"

PRINTED_ONLY = ("H5", "E2", "L3")
"""The bars that rest on memory or a choice alone; they are printed apart, and a failure is explained."""

STANDINGS = {"F": "found", "FC": "found in code", "D": "derived", "M": "from memory", "X": "our choice"}
"""What the letters of a bar's status mean."""


@dataclass(frozen=True, slots=True)
class Bar:
    """A bar of `motion_bars.json`: `cases` are low and high by name."""

    name: str
    text: str
    cases: Mapping[str, tuple[float, float]]
    unit: str
    source: str
    status: str

    @property
    def standing(self) -> str:
        """The status in words: `M edges, FC inside` is "from memory (edges), found in code (inside)"."""
        parts = (part.partition(" ") for part in self.status.split(", "))
        return ", ".join(STANDINGS[letter] + (f" ({of})" if of else "") for letter, _, of in parts)

    def edges(self, size: float) -> tuple[float, float]:
        """The band at a size between the cases, whose edges are joined by straight lines."""
        sizes = sorted((case for case in self.cases if case.isdigit()), key=float)
        at = [float(each) for each in sizes]
        low, high = (np.interp(size, at, [self.cases[each][side] for each in sizes]) for side in (0, 1))
        return float(low), float(high)


@cache
def bars() -> dict[str, Bar]:
    """All bars by name, in the file's order."""
    found = json.loads(BARS_FILE.read_text("utf-8"))["bars"]
    return {
        each["id"]: Bar(
            each["id"],
            each["text"],
            {case: (low, high) for case, (low, high) in each["cases"].items()},
            each["unit"].replace("-", "").replace("1/min", "a minute"),
            each["source"],
            each["status"],
        )
        for each in found
    }


@dataclass(frozen=True, slots=True)
class Check:
    """Values that must all lie in a band. `name` tells the checks of one row apart."""

    name: str
    values: tuple[float, ...]
    low: float
    high: float

    @property
    def passed(self) -> bool:
        return bool(self.values) and all(self.low <= value <= self.high for value in self.values)

    @property
    def figure(self) -> str:
        return (f"{self.name}: " if self.name else "") + (spread(self.values) if self.values else "nothing")

    @property
    def band(self) -> str:
        return f"{self.low:.4g}..{self.high:.4g}"


@dataclass(frozen=True, slots=True)
class Row:
    """One row: a bar, what was measured, over what, and the checks it stands for; one that could not be measured has
    none, and `over` says why. `unit` is the bar's unless given."""

    bar: str
    what: str
    over: str
    checks: tuple[Check, ...]
    unit: str | None = None

    @property
    def passed(self) -> bool:
        return bool(self.checks) and all(check.passed for check in self.checks)

    def __str__(self) -> str:
        bar = bars()[self.bar]
        figures = "; ".join(check.figure for check in self.checks)
        bands = "; ".join(dict.fromkeys(check.band for check in self.checks))
        unit = bar.unit if self.unit is None else self.unit
        figure = f"{figures} {unit}".rstrip() if figures else "not measured"
        verdict = "pass" if self.passed else "FAIL"
        return f"| {self.bar} | {self.what} | {figure} ({self.over}) | {bands} | {bar.standing} | {verdict} |"


def row(bar: str, case: str, what: str, values: Iterable[float], over: str, unit: str | None = None) -> Row:
    """A row of one case of a bar."""
    low, high = bars()[bar].cases[case]
    return Row(bar, what, over, (Check("", tuple(map(float, values)), low, high),), unit)


def row_between(bar: str, what: str, values: Mapping[float, Sequence[float]], over: str) -> Row:
    """A row of sizes between a bar's cases, by size; the edges of the band are joined by straight lines."""
    checks = (Check(f"{size:g}", tuple(map(float, each)), *bars()[bar].edges(size)) for size, each in values.items())
    return Row(bar, what, over, tuple(checks))


def spread(values: Sequence[float]) -> str:
    """The least and the greatest of some values; one where they are the same."""
    low, high = f"{min(values):.3g}", f"{max(values):.3g}"
    return low if low == high else f"{low}..{high}"


HEAD = "| bar | what | measured | band | standing of the source | |\n|---|---|---|---|---|---|"


def printed(rows: Sequence[Row]) -> str:
    """The tables: bars held to published data, then those that rest on memory or a choice, each with its totals."""
    order = list(bars())
    rows = sorted(rows, key=lambda each: order.index(each.bar))
    human = [str(each) for each in rows if each.bar not in PRINTED_ONLY]
    other = [str(each) for each in rows if each.bar in PRINTED_ONLY]
    apart = "From memory or our choice alone: not human data, and not counted."
    return "\n".join([HEAD, *human, "", apart, "", HEAD, *other])


def failed(rows: Iterable[Row]) -> list[str]:
    """The counted bars of which a row fails, or of which there is none."""
    rows = list(rows)
    counted = [name for name in bars() if name not in PRINTED_ONLY]
    return [name for name in counted if not _passes([each for each in rows if each.bar == name])]


def _passes(rows: Sequence[Row]) -> bool:
    return bool(rows) and all(each.passed for each in rows)


def totals(rows: Sequence[Row]) -> str:
    """How many of the counted bars pass, and which do not."""
    missed, counted = failed(rows), len(bars()) - len(PRINTED_ONLY)
    return f"{counted - len(missed)} of {counted} bars pass" + (f"; not: {', '.join(missed)}" if missed else "")


def manual() -> str:
    """The table of bars for the manual: what, band, source, standing."""
    lines = ["| bar | what | band | source | standing |", "|---|---|---|---|---|"]
    for bar in bars().values():
        band = "; ".join(f"{case}: {low:g} to {high:g}" for case, (low, high) in bar.cases.items())
        unit = f" {bar.unit}" if bar.unit else ""
        lines.append(f"| {bar.name} | {bar.text} | {band}{unit} | {bar.source} | {bar.standing} |")
    return "\n".join(lines).replace("|v|", "speed").replace("|gaze", "gaze") + "\n"


Measure = Callable[..., Iterable[Row]]
"""Measures one or several bars in a studio."""

Measures = Mapping[str, Measure]
"""The measures of a group by the bars they make rows for, names with spaces between."""
