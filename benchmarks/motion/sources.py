"""Where published sources disagree: which was followed, and why. Printed under the tables and kept in the manual."""

from __future__ import annotations

DISAGREEMENTS = (
    (
        "duration of a saccade",
        "2.2 A + 21 ms (Carpenter), 2.7 A + 37 ms (Baloh), 2.4 A + 25 ms (Eyes Alive)",
        "2.7 A + 25 ms, and peak speed derived from it as 1.65 A / D: it lies between them, and within 0.6 standard "
        "deviations of all six measured peak speeds. With 2.2 A + 21 ms and a speed of its own, the peak can come out "
        "below the mean (Q < 1), which cannot be.",
    ),
    (
        "speed of the eyes in a gaze shift",
        "65 deg/s at 10 deg (Andrist 2012, for characters), 292 deg/s (measured)",
        "the measured one; of the model for characters only its structure: the head's share, the eyes' reach.",
    ),
    (
        "head after eyes",
        "139 ms at 10 deg and 50 ms at 40 deg (one study), 20 to 50 ms (textbooks, from memory)",
        "the study, because its numbers were found; onset is 5 % of peak speed for eye and head alike.",
    ),
    (
        "gaze on the partner while speaking",
        "41 % (Eyes Alive), but its own intervals of 3.13 s and 0.93 s give 77 %; looks away every 4 s for 1 s "
        "(Andrist 2013), which give 80 %; 40 % (Argyle, from memory)",
        "the share of 41 %, on which two agree, and looks of about 3 s; looks away are longer than both intervals say.",
    ),
    (
        "the end of a felt smile",
        "offset longer when posed (2006), longer when spontaneous (2018)",
        "2018: there onset, apex, offset and total all agree; both say that the posed onset is faster.",
    ),
    (
        "blinks with gaze shifts",
        "97 % above 33 deg (Evinger 1994), 33 % at a head turn of 30 deg (formula after Peters and Qureshi 2010)",
        "Evinger: it is a measurement; the formula is a character's.",
    ),
    (
        "gaze on a flat picture",
        "seen 1.5 to 1.8 times too far (studies), drawn at a third (the patent)",
        "both, by name: `screen measured` draws 0.6, `screen patent` is the patent's own third; it under-rotates "
        "against the studies.",
    ),
    (
        "mouth before sound",
        "100 to 150 ms (older rule), -20 to 70 ms inside an utterance (Schwartz and Savariaux 2014)",
        "the later one: the long lead is kept for the start of an utterance alone.",
    ),
)
"""What, what the sources say, and what was followed and why."""


def printed() -> str:
    """The disagreements as a table."""
    lines = ["| where sources disagree | they say | followed |", "|---|---|---|"]
    return "\n".join([*lines, *(f"| {what} | {said} | {followed} |" for what, said, followed in DISAGREEMENTS)]) + "\n"
