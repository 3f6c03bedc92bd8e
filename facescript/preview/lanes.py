"""A score to what the page draws as a timeline: lanes, and the acts in them."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.ir.acts import Gesture, Glance, Look, Say, Scan, SetBackground, SetLife, View
from facescript.ir.play import Play
from facescript.plot.acts import FACE, FILM, GAZE, GESTURE, LIFE, SPEECH
from facescript.preview.messages import Message
from facescript.preview.places import Units
from facescript.schedule.phrases import phrase
from facescript.schedule.score import Score, TimedAct
from facescript.text import Source

KINDS: tuple[tuple[tuple[type, ...], str, str], ...] = (
    ((Look, Glance, Scan), "gaze", GAZE),
    ((Gesture,), "gesture", GESTURE),
    ((Say,), "speech", SPEECH),
    ((SetLife,), "life", LIFE),
    ((SetBackground, View), "film", FILM),
)


def timeline(score: Score, play: Play, source: Source, units: Units) -> Message:
    """The message `score` without its version and playhead; places are of `source`, the script, in `units`."""
    lanes: dict[tuple[str | None, str], Message] = {}
    acts = []
    for act in score.acts:
        name, colour = next((row[1:] for row in KINDS if isinstance(act.verb, row[0])), ("face", FACE))
        lane = lanes.setdefault((act.face, name), {"face": act.face, "name": name, "colour": colour})
        acts.append({"lane": list(lanes.values()).index(lane), **_act(act, score, source, units)})
    film = score.film
    return {
        "duration": score.duration,
        "film": {"width": film.width, "height": film.height, "fps": film.fps, "title": film.title},
        "scenes": [{"name": scene.name, "start": scene.start, "end": scene.end} for scene in score.scenes],
        "lanes": list(lanes.values()),
        "acts": acts,
        "lines": list(_lines(score)),
        "markers": [{"name": marker.name, "time": marker.time} for marker in score.markers],
    }


def _act(act: TimedAct, score: Score, source: Source, units: Units) -> Message:
    released, end = (min(time, score.scenes[act.scene].end) for time in (act.released, act.end))
    line, _ = act.span.source.position(act.span.start)
    found: Message = {
        "row": 0,
        "start": act.start,
        "apex": min(act.settled, end),
        "release": released,
        "end": max(end, act.start),
        "settled": act.settled,
        "label": phrase(act.verb),
        "note": act.label,
        "line": line,
        "estimated": act.estimated,
        "handles": {},
    }
    if act.span.source is source:
        return found | {"from": units.at(act.span.start), "to": units.at(act.span.end)}
    return found | {"file": act.span.source.name}


def _lines(score: Score) -> Iterator[Message]:
    for line in score.lines:
        words = [
            {"text": word.text, "start": line.start + word.start, "end": line.start + word.end}
            for word in line.spoken.words
        ]
        yield {"face": line.face, "start": line.start, "end": line.end, "text": line.text, "words": words}
