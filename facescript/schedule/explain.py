"""A score to a table: who does what, from when until when, and when the eyes and the head come in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from facescript.ir.acts import Glance, Look, Say
from facescript.ir.values import AtPerson
from facescript.schedule.phrases import phrase
from facescript.schedule.score import FOREVER, Score, TimedAct, TimedLine
from facescript.text import Span

HEAD = ("line", "start", "settled", "end", "face", "what", "eyes", "landed", "head", "there")


@dataclass(frozen=True, slots=True)
class Row:
    """An act, a spoken line or (`kind` is "word") one of its words; seconds from the film's start.

    `settled` is when the next statement may start, `end` when nothing of it is left (None: it lasts until it is
    replaced or its scene ends). `eyes` and `head` are when they set off, `landed` and `there` when they are there.
    `about` says which of the times rest on a line that no voice has spoken yet.
    """

    kind: str
    file: str
    line: int
    scene: str
    face: str | None
    what: str
    label: str | None
    start: float
    settled: float
    end: float | None
    eyes: float | None = None
    landed: float | None = None
    head: float | None = None
    there: float | None = None
    about: tuple[str, ...] = ()


def explain(score: Score) -> list[Row]:
    """The acts of a score in time; each spoken line is followed by its words."""
    lines = _by_place(score.lines)
    groups: list[list[Row]] = []
    for act in score.acts:
        row = _row(score, act)
        if isinstance(act.verb, Say):
            groups += _said(row, act, lines.get(_place(act.face, act.span), []))
        else:
            groups.append([row])
    return [row for group in sorted(groups, key=lambda group: group[0].start) for row in group]


def as_objects(rows: Sequence[Row]) -> list[dict[str, object]]:
    """The rows for JSON, times to a microsecond. Times that do not apply are left out."""
    return [dict(_object(row)) for row in rows]


def as_text(rows: Sequence[Row]) -> str:
    """The rows as a table, times in seconds, `~` before those that are estimated."""
    table = [HEAD, *(_cells(row) for row in rows)]
    widths = [max(len(cells[column]) for cells in table) for column in range(len(HEAD))]
    right = ("start", "settled", "end", "eyes", "landed", "head", "there")
    return "\n".join(
        "  ".join(
            cell.rjust(width) if name in right else cell.ljust(width)
            for cell, width, name in zip(cells, widths, HEAD, strict=True)
        ).rstrip()
        for cells in table
    )


# ------------------------------------------------------------------------------------------------ rows


def _row(score: Score, act: TimedAct) -> Row:
    line, _ = act.span.source.position(act.span.start)
    scene = score.scenes[act.scene].name
    end = None if act.end == FOREVER else act.end
    about = ("start", "settled", "end") if act.estimated else ()
    what = phrase(act.verb) + _who(act)
    row = Row(
        "act", act.span.source.name, line, scene, act.face, what, act.label, act.start, act.settled, end,
        about=about,
    )  # fmt: skip
    if not act.plan:
        return row
    shift = act.plan[0]
    if shift.uses_eyes:
        row = replace(row, eyes=shift.eye_onset, landed=shift.landed)
    if shift.uses_head and shift.head_done > shift.head_onset:
        row = replace(row, head=shift.head_onset, there=shift.head_done)
    return row


def _who(act: TimedAct) -> str:
    """Who the person is that is looked at."""
    if not isinstance(act.verb, (Look, Glance)) or not isinstance(act.verb.aim, AtPerson):
        return ""
    return f" ({dict(act.persons).get(act.verb.aim.name, 'nobody')})"


def _said(row: Row, act: TimedAct, lines: list[TimedLine]) -> Iterator[list[Row]]:
    """The sayings of a line, each with its words; `lines` are those of this place that have not been told yet."""
    while lines and lines[0].start <= act.settled:
        line = lines.pop(0)
        about = (("start",) if act.estimated else ()) + (("settled", "end") if line.spoken.estimated else ())
        what = row.what if line.cut is None else f"{row.what} (breaks off)"
        said = replace(row, kind="line", what=what, start=line.start, settled=line.end, end=line.end, about=about)
        yield [said, *_words(said, line)]


def _words(said: Row, line: TimedLine) -> Iterator[Row]:
    for word in line.spoken.words:
        start, end = line.start + word.start, line.start + word.end
        if start < line.end:
            about = ("start", "settled", "end") if said.about else ()
            yield replace(said, kind="word", what=word.text, label=None, start=start, settled=end, end=end, about=about)


def _by_place(lines: Sequence[TimedLine]) -> dict[tuple[str | None, str, int], list[TimedLine]]:
    found: dict[tuple[str | None, str, int], list[TimedLine]] = {}
    for line in lines:
        found.setdefault(_place(line.face, line.span), []).append(line)
    return found


def _place(face: str | None, span: Span) -> tuple[str | None, str, int]:
    return face, span.source.name, span.start


# ------------------------------------------------------------------------------------------------ forms

TIMES = ("start", "settled", "end", "eyes", "landed", "head", "there")


def _object(row: Row) -> Iterator[tuple[str, object]]:
    for name in ("kind", "file", "line", "scene", "face", "what", "label", *TIMES):
        value = getattr(row, name)
        if name in TIMES and value is not None:
            yield name, round(value, 6)
        elif value is not None:
            yield name, value
    yield "estimated", bool(row.about)


def _cells(row: Row) -> tuple[str, ...]:
    what = f"    {row.what}" if row.kind == "word" else row.what
    if row.label is not None:
        what += f" as {row.label}"
    settled = "" if row.kind == "word" else _time(row, "settled")
    place = "" if row.kind == "word" else f"{row.file}:{row.line}"
    face = "" if row.kind == "word" else row.face or ""
    gaze = (_time(row, "eyes"), _time(row, "landed"), _time(row, "head"), _time(row, "there"))
    return place, _time(row, "start"), settled, _time(row, "end"), face, what, *gaze


def _time(row: Row, name: str) -> str:
    value = getattr(row, name)
    if value is None:
        return ""
    return f"{'~' if row.about and (name in row.about or name in TIMES[3:]) else ''}{value:.3f}"
