"""A score to what the preview's timeline shows: lanes, acts as bars in rows, lines with their words, scenes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from facescript.ir.acts import Drop, SetBackground, SetLife, View
from facescript.ir.play import Play
from facescript.performance.channels import channels_of
from facescript.plot.acts import Bar, Lane, face_lanes, film_lanes
from facescript.preview.places import Units
from facescript.schedule.score import Score, TimedLine
from facescript.text import Source, Span
from facescript.web.messages import Message

MOST_ROWS = 8
"""Rows of one lane; bars for which there is no room lie over others in the last."""

PLACES = 4
"""Decimals of a time, s."""

GOES_ON = (",", "+", "=")
"""What a line ends in that goes on in the next."""

CHANGES = (Drop, SetBackground, SetLife, View)
"""Verbs whose length is that of a change."""


def timeline(score: Score, play: Play, source: Source, units: Units) -> Message:
    """The message `score` without its version and playhead; places are of `source`, the script, in `units`.

    Times are seconds to 0.1 ms. `channels` are the names of those that each seen face has. No act has `handles` yet.
    """
    lanes: list[tuple[str | None, Lane]] = [(None, lane) for lane in film_lanes(score, play)]
    lanes += [(face.name, lane) for face in score.faces for lane in face_lanes(score, face)]
    film = score.film
    return {
        "duration": score.duration,
        "film": {"width": film.width, "height": film.height, "fps": film.fps, "title": film.title},
        "scenes": [{"name": each.name, "start": _s(each.start), "end": _s(each.end)} for each in score.scenes],
        "lanes": [{"face": face, "name": lane.name, "colour": lane.colour} for face, lane in lanes],
        "acts": [act for number, (_, lane) in enumerate(lanes) for act in _acts(lane, number, source, units)],
        "lines": [_line(line) for line in score.lines],
        "markers": [{"name": each.name, "time": _s(each.time)} for each in score.markers],
        "channels": {face.name: channels_of(face.parts) for face in score.faces if face.seen},
    }


def _acts(lane: Lane, number: int, source: Source, units: Units) -> Iterator[Message]:
    for bar, row in zip(lane.bars, rows(lane.bars), strict=True):
        act = bar.act
        yield {
            "lane": number,
            "row": row,
            "start": _s(bar.start),
            "apex": _s(bar.apex),
            "release": _s(bar.release),
            "end": _s(bar.end),
            "settled": _s(act.settled if act is not None else bar.end),
            "until": _s(_until(bar)),
            "label": bar.label,
            "note": bar.note,
            "estimated": act is not None and act.estimated,
            "handles": {},
            **(_place(bar.span, source, units) if bar.span is not None else {}),
        }


def _until(bar: Bar) -> float:
    """What the handle `end` moves: when an act begins to let go, or has changed what it changes."""
    changes = bar.act is not None and isinstance(bar.act.verb, CHANGES)
    return bar.act.settled if bar.act is not None and changes else bar.release


def rows(bars: Sequence[Bar]) -> Iterator[int]:
    """The row of each bar: the first that is free. A bar leaves it as it lets go, so that two that follow one another
    share a row; one that takes no time has left it when the next begins."""
    until: list[float] = []
    for bar in bars:
        leaves = bar.release if bar.end > bar.start else bar.start + 10.0**-PLACES
        row = next((row for row, time in enumerate(until) if time <= bar.start), len(until))
        if row == len(until) < MOST_ROWS:
            until.append(leaves)
        row = min(row, MOST_ROWS - 1)
        until[row] = max(until[row], leaves)
        yield row


def _place(span: Span, source: Source, units: Units) -> Message:
    """Where a statement stands: in the script itself the stretch without what is indented below it, else its file."""
    line, _ = span.source.position(span.start)
    if span.source is not source:
        return {"file": span.source.name, "line": line}
    return {"from": units.at(span.start), "to": units.at(span.start + _head(span.text)), "line": line}


def _head(text: str) -> int:
    """How many characters of a statement are not in its block: its line, and those in which this goes on."""
    lines = text.splitlines(keepends=True)
    count = 1
    while count < len(lines) and (lines[count - 1].rstrip().endswith(GOES_ON) or lines[count].lstrip().startswith('"')):
        count += 1
    return len("".join(lines[:count]).rstrip())


def _line(line: TimedLine) -> Message:
    words = [word for word in line.spoken.words if line.start + word.start < line.end]
    return {
        "face": line.face,
        "start": _s(line.start),
        "end": _s(line.end),
        "text": line.text,
        "words": [
            {"text": word.text, "start": _s(line.start + word.start), "end": _s(min(line.start + word.end, line.end))}
            for word in words
        ],
    }


def _s(time: float) -> float:
    return round(time, PLACES)
