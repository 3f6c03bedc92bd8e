"""Tables of newsreaders' movements to the intervals that the announcers' lives draw from.

`thesis` is the thesis on talking cartoon faces, chapter 4: ten or so announcers of three stations, at 30 frames a
second. Its method: a statistic is uniform from its mean less a standard deviation to its mean and one, and what belongs
to the pace of the speech (tilts, turns, nods, lifts) is doubled, for announcers speak faster than others do.
"""

from __future__ import annotations

from dataclasses import dataclass
from statistics import mean, stdev

Interval = tuple[float, float]
"""Seconds, the shortest and the longest of a uniform draw."""

THETA = 1.48
"""Seconds: every announcer's wait for a blink is gamma with shape 2 and this scale, from the end of one to the start of
the next (`thesis` 4.3)."""


@dataclass(frozen=True, slots=True)
class Station:
    """The intervals of one announcer.

    `..._gaps` are from the end of a movement to the start of the next, `..._lengths` from its start to its end;
    `nod_ahead` is from a nod's end to the pause, and a lift starts with the pause.
    """

    brow_gaps: Interval
    brow_lengths: Interval
    tilt_gaps: Interval
    tilt_lengths: Interval
    turn_gaps: Interval
    turn_lengths: Interval
    nod_ahead: Interval
    nod_lengths: Interval
    lift_lengths: Interval

    @property
    def brow_rate(self) -> float:
        """Brow raises a minute."""
        return 120.0 / (sum(self.brow_gaps) + sum(self.brow_lengths))


ANNOUNCER = Station(
    brow_gaps=(0.90, 12.54),
    brow_lengths=(0.51, 0.99),
    tilt_gaps=(0.0, 6.64),
    tilt_lengths=(0.4, 1.0),
    turn_gaps=(0.08, 7.92),
    turn_lengths=(0.4, 0.92),
    nod_ahead=(0.07, 0.35),
    nod_lengths=(0.34, 0.94),
    lift_lengths=(0.34, 0.70),
)
"""All announcers together, as the thesis adopts them (4.4, 4.5, tables 4.7 and 4.12). It has more data than it prints:
the columns below do not add up to these."""

DOUBLED = ("tilt_gaps", "tilt_lengths", "turn_gaps", "turn_lengths", "nod_lengths", "lift_lengths")
"""What the thesis doubles for the normal pace of speech; brow raises and the time from nod to pause stay."""


def station(**columns: str) -> Station:
    """The intervals of a station by the columns of its tables (seconds), none below 0."""
    return Station(**{name: _interval(column, 2.0 if name in DOUBLED else 1.0) for name, column in columns.items()})


def _interval(column: str, pace: float) -> Interval:
    values = [float(value) for value in column.split()]
    middle, spread = mean(values), stdev(values)
    return max(0.0, pace * (middle - spread)), pace * (middle + spread)


CTN = station(
    brow_gaps="0.433 0.7 1.367 1.933 1.333 0.6 0.6 1.1 3.767",
    brow_lengths="1.067 0.633 0.5 0.8 0.767 1.333 0.633 0.7 0.767",
    tilt_gaps="2.4 1.467 0.567 0.333 0.4 0.3 0.333 2.767 0.733 2.2 0.266 1.366 0.9 0.767 0.633 1.767 0.733 0.4",
    tilt_lengths="0.367 0.6 0.233 0.233 0.233 0.233 0.6 0.2 0.4 0.3 0.267 0.267 0.333 0.233 0.2 0.333 0.333 0.267",
    turn_gaps="2.9 6.934 1.567 3.0 1.8 0.667 7.1 2.5 3.367",
    turn_lengths="0.233 0.333 0.2 0.1 0.267 0.4 0.5 0.3 0.433",
    nod_ahead="0.433 0.2 0.267 0.133 0.333 0.033 0.333 0.1 0.167",
    nod_lengths="0.233 0.1 0.467 0.333 0.167 0.533 0.5 0.233 0.3",
    lift_lengths="0.1 0.267 0.233 0.267 0.167 0.2 0.333 0.233 0.267",
)
"""CTN News: the first columns of tables 4.1 to 4.6 and 4.9 to 4.11."""

# Rows 11 to 16 of ETtoday's tilts (4.2 to 1.6) are rows 10 to 15 of the other stations' in the only copy of the table
# there is. One of the two columns may have lost its own; they are taken as they stand.
ETTODAY = station(
    brow_gaps="5.267 7.233 8.167 13.333 12.333 3.333 6.167 7.2 6.833",
    brow_lengths="0.667 0.6 0.567 0.967 0.533 0.7 0.733 0.7 0.567",
    tilt_gaps="0.3 1.233 1.233 0.3 2.933 0.667 0.5 2.967 4.5 0.367 4.2 2.233 0.667 2.033 0.7 1.6 1.1 0.433",
    tilt_lengths="0.2 0.233 0.5 0.4 0.267 0.267 0.5 0.3 0.867 0.567 0.133 0.5 0.667 0.433 0.767 0.633 0.3 0.333",
    turn_gaps="0.7 0.233 1.433 2.433 0.833 0.867 1.6 0.7 2.5",
    turn_lengths="0.167 0.633 0.433 0.2 0.267 0.367 0.267 0.2 0.5",
    nod_ahead="0.2 0.233 0.067 -0.033 -0.1 0.333 0.1 0.033 0.367",
    nod_lengths="0.167 0.367 0.5 0.467 0.467 0.5 0.3 0.333 0.167",
    lift_lengths="0.2 0.433 0.167 0.233 0.4 0.3 0.2 0.267 0.2",
)
"""ETtoday News: the second columns."""

OTHER = station(
    brow_gaps="2.367 4.333 1.9 3.267 2.2 3.067 2.833 1.133 7.233",
    brow_lengths="0.433 0.3 0.6 1.2 0.8 1.167 1.067 0.633 0.5",
    tilt_gaps="0.2 5.433 0.1 0.2 4.233 1.033 0.133 1.667 7.633 4.2 2.233 0.667 2.033 0.7 1.6 0.667 4.233 2.467",
    tilt_lengths="0.2 0.5 0.5 0.5 0.2 0.267 0.267 0.3 0.4 0.4 0.333 0.233 0.3 0.433 0.3 0.267 0.333 0.467",
    turn_gaps="0.633 0.167 1.267 1.9 1.333 0.067 2.1 1.2 1.6",
    turn_lengths="0.367 0.267 0.3 0.333 0.1 0.267 0.4 0.433 0.3",
    nod_ahead="0.2 0.3 0.233 0.333 0.267 0.367 0.0 0.167 0.3",
    nod_lengths="0.333 0.567 0.2 0.367 0.467 0.267 0.233 0.3 0.267",
    lift_lengths="0.167 0.2 0.267 0.333 0.267 0.233 0.333 0.167 0.367",
)
"""Other News: the third columns."""

STATIONS: dict[str, Station] = {
    "announcer": ANNOUNCER,
    "announcer-ctn": CTN,
    "announcer-ettoday": ETTODAY,
    "announcer-other": OTHER,
}
"""The presets that move by an announcer's statistics."""
