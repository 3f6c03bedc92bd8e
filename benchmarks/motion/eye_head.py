"""Gaze shifts of eyes and head (H1 to H11), screen none. Unless said: life still, from ahead with the head ahead.

Onset and end of eye, head and gaze are where their speed first and last exceeds 5 % of its peak; gaze has landed when
it is within 0.5 deg of its target. Traces are turned so that yaw is along the shift.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from bars import Trace, final_share, head_lag_ms, movement, share_at_landing, spearman, vor_error, vor_gain
from events import blink_at, shut_moments
from playing import Place, Shift, Studio, on_way, script, shifts, speed_of, towards_words
from table import Measures, Row, bars, row, row_between

WAYS = (0, 20, 160, 180, 200, 340)
"""Directions of horizontal shifts, deg: straight, and a little up or down, as targets in a room are."""

SIZES = (10, 15, 20, 25, 30, 35, 40, 45, 50)
AHEAD = (0.0, 0.0)
OVER = f"{len(WAYS)} directions"


def _sideways(studio: Studio) -> dict[int, list[Shift]]:
    """Shifts from ahead, by size."""
    return {size: shifts(studio, [(AHEAD, on_way(size, way)) for way in WAYS]) for size in SIZES}


def _rows(bar: str, what: str, found: Mapping[int, Sequence[float]]) -> Iterator[Row]:
    """A row for each of the bar's sizes, and one for the others between them."""
    cases = [case for case in bars()[bar].cases if case.isdigit()]
    for case in cases:
        yield row(bar, case, f"{what}, {case} deg", found[int(case)], OVER)
    last = max(map(int, cases))
    others = {size: each for size, each in found.items() if str(size) not in cases and size <= last}
    yield row_between(bar, f"{what}, other sizes", others, OVER)


def lags(studio: Studio) -> Iterator[Row]:
    made = studio.once(_sideways)
    found = {size: [head_lag_ms(shift.trace, "yaw") for shift in each] for size, each in made.items()}
    yield from _rows("H1", "head onset after eye onset", found)
    falls = all(one > other for one, other in zip(found[10], found[40], strict=True))
    yield row("H1", "lag(10)>lag(40)", "the lag falls with size (1 is yes)", [falls], OVER, "")


def eye_speeds(studio: Studio) -> Iterator[Row]:
    made = studio.once(_sideways)
    found = {size: [speed_of(shift.trace, "eye").max() for shift in each] for size, each in made.items()}
    yield from _rows("H2", "peak speed of the eye", found)


def shares(studio: Studio) -> Iterator[Row]:
    landed = [share_at_landing(shift.trace, "yaw", shift.target) for shift in studio.once(_sideways)[50]]
    yield row("H3", "50", "head's part of 50 deg when gaze lands", landed, OVER)
    starts = AHEAD, (0.0, 12.0), (15.0, 0.0), (-15.0, -5.0)
    for case, ways, last in HELD:
        ends = [on_way(size, way) for size in range(20, last + 1, 5) for way in ways]
        held = shifts(studio, [(start, end) for end in ends for start in starts], rest=2.1)
        found = [final_share(shift.seen, *_main_axis(shift.end)) for shift in held]
        yield row("H4", case, f"final head share, {case}", found, f"{len(found)} looks, four places before, held 2 s")


HELD = (("horizontal 20..60", (0, 180), 60), ("up 20..40", (90,), 40), ("down 20..40", (270,), 40))
"""Cases of H4 with the directions and the largest size that belong to them."""


def _main_axis(place: Place) -> tuple[str, float]:
    return ("yaw", place[0]) if abs(place[0]) > abs(place[1]) else ("pitch", place[1])


def eye_movers(studio: Studio) -> Iterator[Row]:
    pairs = [(AHEAD, on_way(size, way)) for size in (3, 5, 7, 10) for way in range(0, 360, 45)]
    found = [_furthest_head(shift.seen) for shift in shifts(studio, pairs, face="gaze eye-mover")]
    yield row("H5", "<=10", "head of an eye-mover, shifts to 10 deg", found, f"{len(found)} shifts, eight directions")


def _furthest_head(trace: Trace) -> float:
    return float(np.hypot(trace.head("yaw"), trace.head("pitch")).max())


def head_speeds(studio: Studio) -> Iterator[Row]:
    peaks = {
        size: [movement(shift.trace, shift.trace.head("yaw")).peak for shift in made]
        for size, made in studio.once(_sideways).items()
    }
    rhos = [spearman([float(size) for size in SIZES], [peaks[size][index] for size in SIZES])
            for index in range(len(WAYS))]  # fmt: skip
    yield row("H6", "rho", "rank correlation of head speed and size, 10 to 50 deg", rhos, OVER, "")
    wide = [(on_way(-size, way), on_way(size, way)) for size in (30, 40, 60, 80) for way in (0, 10, 170, 180)]
    across = [float(speed_of(shift.seen, "head").max()) for shift in shifts(studio, wide)]
    every = [*across, *(each for made in peaks.values() for each in made)]
    yield row("H6", "max", "fastest head in shifts up to 160 deg", [max(every)], f"{len(every)} shifts")


def held_gaze(studio: Studio) -> Iterator[Row]:
    made = [shift for each in studio.once(_sideways).values() for shift in each]
    starts = [on_way(-10.0, 0), (8.0, -6.0)]
    made += shifts(
        studio, [(start, on_way(size, way)) for start in starts for size in (20, 35, 50) for way in (0, 180)]
    )
    errors, slips = zip(*(vor_error(shift.trace, "yaw", shift.target) for shift in made), strict=True)
    over = f"{len(made)} shifts of 10 to 60 deg, from ahead and aside"
    yield row("H7", "mean error", "gaze off the target while the head arrives", errors, over, "deg")
    yield row("H7", "retinal slip rms", "retinal slip while the head arrives", slips, over, "deg/s")
    gains = [vor_gain(shift.trace, "yaw", shift.target) for shift in made]
    yield row("H8", "far target", "gain of the VOR, target at 6 m", gains, over)


IMPOSED = 4.0
"""Seconds between two head steps."""

FINE = 4000.0
"""Samples a second where single milliseconds count."""


def vor_latencies(studio: Studio) -> Iterator[Row]:
    """The head is moved during a look at something that stays, by channels and by gestures."""
    turns = [f"add head.{axis} {size}deg over {over}ms for 1500ms" for axis in ("yaw", "pitch")
             for size in (4, -4, 8, -8, 12, -12) for over in (100, 200)]  # fmt: skip
    turns += ["nod", "shake", "nod 40%"]
    lines = [f"at {IMPOSED * number:.0f}s: {turn}" for number, turn in enumerate(turns, start=1)]
    playing = studio.play(script("look left 12deg up 4deg", *lines, f"wait {IMPOSED * (len(turns) + 2):.0f}s"))
    found = []
    for number, turn in enumerate(turns, start=1):
        seen = playing.trace(IMPOSED * number - 0.02, IMPOSED * number + 0.5, FINE)
        axis = "yaw" if "yaw" in turn or "shake" in turn else "pitch"
        onsets = [_onset(seen, part(axis)) for part in (seen.eye, seen.head)]
        found.append(1000.0 * (onsets[0] - onsets[1]))
    yield row(
        "H9", "any", "eye onset after the onset of an imposed head step", found, f"{len(found)} steps and gestures"
    )


def _onset(trace: Trace, values: np.ndarray) -> float:
    return movement(trace, values).onset


REST = 1.6
"""Seconds between two looks there and back."""

NEAR = 0.1
"""A blink that begins so near the first onset of eye or head goes with the shift, s."""


def gaze_blinks(studio: Studio) -> Iterator[Row]:
    """Looks there and back in a `calm` life, whose own blinks are counted too where they fall into the window."""
    onsets: list[float] = []
    for case, sizes in (("35..60", (35, 40, 45, 50, 55, 60)), ("<=8", (2, 4, 6, 8))):
        pairs = [(on_way(-size / 2, way), on_way(size / 2, way)) for size in sizes for way in (0, 10, -10) * 7]
        found = list(_blinked(studio, pairs))
        blinked = [late for late in found if late is not None]
        over = f"{len(found)} looks, six directions, life calm"
        yield row("H10", case, f"share of looks with a blink, {case} deg", [len(blinked) / len(found)], over)
        onsets += blinked if case == "35..60" else []
    yield row(
        "H11", "any", "blink onset after the first of eye and head", onsets, f"{len(onsets)} blinks, 35 to 60 deg"
    )


def _blinked(studio: Studio, pairs: Sequence[tuple[Place, Place]]) -> Iterator[float | None]:
    """For each look, there and back: the blink's onset after the shift's, ms, or None."""
    places = [place for pair in pairs for place in pair]
    looks = [f"at {REST * number:.2f}s: look {towards_words(place)}" for number, place in enumerate(places, start=1)]
    playing = studio.play(script(*looks, f"wait {REST * (len(looks) + 2):.2f}s", life="calm"))
    for number in range(2, len(places) + 1):
        seen = playing.trace(REST * number - 0.25, REST * number + 0.9)
        yield _blink_late(seen, REST * number)


def _blink_late(seen: Trace, time: float) -> float | None:
    shift = seen.part(time - 0.02, time + 0.4)
    begun = _onset(shift, shift.gaze("yaw"))
    for moment in shut_moments(seen.times, seen.channels["lid.left"]):
        late = blink_at(seen, moment).onset - begun
        if abs(late) <= NEAR:
            return 1000.0 * late
    return None


MEASURES: Measures = {
    "H1": lags, "H2": eye_speeds, "H3 H4": shares, "H5": eye_movers, "H6": head_speeds, "H7 H8": held_gaze,
    "H9": vor_latencies, "H10 H11": gaze_blinks,
}  # fmt: skip
