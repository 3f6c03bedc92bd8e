"""The acts of a score to lanes of bars: from when until when each is seen, how it comes in and how it lets go."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf

from facescript.ir.acts import (
    Add,
    Drop,
    Gesture,
    Glance,
    Life,
    Look,
    Perform,
    Say,
    Scan,
    SetBackground,
    SetLife,
    Show,
    Verb,
    View,
)
from facescript.ir.play import Face, Play
from facescript.motion.expression import layer
from facescript.schedule.defaults import Concrete, seconds
from facescript.schedule.events import Happening, happening
from facescript.schedule.phrases import duration, phrase
from facescript.schedule.score import Score, TimedAct, TimedLine
from facescript.text import Span

GAZE, FACE, GESTURE, SPEECH, LIFE, FILM = "#0072b2", "#d55e00", "#009e73", "#56636b", "#aa4c86", "#8a6d00"
"""The colours of the lanes: those of Okabe and Ito, which colour-blind people can tell apart, two of them darker."""


@dataclass(frozen=True, slots=True)
class Bar:
    """An act in time, seconds: it comes in from `start` to `apex`, lets go at `release`, and is gone at `end`.

    `note` says the same in words, with the line of the script. `span` is where that stands, `act` what is done there:
    a scene has neither, the life that a face begins with and an event have no act.
    """

    start: float
    apex: float
    release: float
    end: float
    label: str
    note: str
    span: Span | None = None
    act: TimedAct | None = None


@dataclass(frozen=True, slots=True)
class Lane:
    """Bars of one kind, by their starts."""

    name: str
    colour: str
    bars: tuple[Bar, ...]


def film_lanes(score: Score, play: Play) -> Iterator[Lane]:
    """What is of no one face: scenes where there are several, what changes background and view, events."""
    if len(score.scenes) > 1:
        bars = tuple(_steady(scene.start, scene.end, scene.name, f"scene {scene.name}") for scene in score.scenes)
        yield Lane("scene", FILM, bars)
    for name, kind in (("background", SetBackground), ("view", View)):
        acts = [act for act in score.acts if isinstance(act.verb, kind)]
        if len({act.verb for act in acts}) > 1 or any(_changes(score, act) for act in acts):
            yield Lane(name, FILM, tuple(_replaced(score, acts)))
    if play.events:
        concrete = Concrete(play.film.seed)
        told = [_event(happening(event, number, concrete), event.span) for number, event in enumerate(play.events)]
        yield Lane("event", FILM, tuple(sorted(told, key=lambda bar: bar.start)))


def _changes(score: Score, act: TimedAct) -> bool:
    """Whether an act is more than what its scene begins with."""
    return act.start > score.scenes[act.scene].start or act.settled > act.start


def face_lanes(score: Score, face: Face) -> Iterator[Lane]:
    """What a face does: gaze, what it shows, gestures, speech, life; lanes without a bar are left out."""
    acts = [act for act in score.acts if act.face == face.name]
    lanes: tuple[tuple[str, str, Callable[[], Iterator[Bar]]], ...] = (
        ("gaze", GAZE, lambda: _looks(score, acts)),
        ("face", FACE, lambda: _shown(score, acts)),
        ("gesture", GESTURE, lambda: _gestures(acts)),
        ("speech", SPEECH, lambda: _lines(score, acts, face.name)),
        ("life", LIFE, lambda: _lives(score, acts, face)),
    )
    for name, colour, bars in lanes:
        found = tuple(sorted(bars(), key=lambda bar: bar.start))
        if found:
            yield Lane(name, colour, found)


# ------------------------------------------------------------------------------------------------ kinds of acts


def _looks(score: Score, acts: Sequence[TimedAct]) -> Iterator[Bar]:
    """Looks, glances and scans: in until the eyes are there, out until eyes and head are back."""
    gazes = [act for act in acts if isinstance(act.verb, (Look, Glance, Scan))]
    covered = _covered(gazes)
    for act in gazes:
        release = min(act.released, covered.get(act.order, inf), score.scenes[act.scene].end)
        first = act.plan[0] if act.plan else None
        landed = act.settled if first is None else first.landed if first.uses_eyes else first.head_done
        yield _bar(act, min(landed, release), release, act.end if act.released == release else release)


def _covered(gazes: Sequence[TimedAct]) -> dict[int, float]:
    """When a look without an end has lost all its parts to later ones, by its order."""
    found: dict[int, float] = {}
    kept: dict[int, tuple[int, set[str]]] = {}
    for act in gazes:
        if act.released < inf:
            continue
        used = {part for plan in act.plan[:1] for part in _parts(plan.uses_eyes, plan.uses_head)}
        for order, (scene, parts) in list(kept.items()):
            parts -= used
            if scene != act.scene or not parts:
                found[order] = act.start
                del kept[order]
        kept[act.order] = act.scene, used
    return found


def _parts(eyes: bool, head: bool) -> Iterator[str]:
    if eyes:
        yield "eyes"
    if head:
        yield "head"


def _shown(score: Score, acts: Sequence[TimedAct]) -> Iterator[Bar]:
    """Shows and adds until they let go, are dropped or are covered by the next show; drops while they take away."""
    dropped = _dropped(acts)
    bases = [act for act in acts if isinstance(act.verb, Show) and act.released == inf]
    after = {act.order: later for act, later in pairwise(bases) if act.scene == later.scene}
    for act in acts:
        if isinstance(act.verb, Drop):
            yield _bar(act, act.start, act.start, act.settled)
        elif isinstance(act.verb, Perform):
            yield _bar(act, _risen(act), act.released, act.end)
        elif isinstance(act.verb, (Show, Add)):
            apex = _risen(act)
            release, end = _gone(act, after.get(act.order), dropped, score.scenes[act.scene].end)
            yield _bar(act, apex, max(release, apex), max(end, apex))


def _gone(
    act: TimedAct, later: TimedAct | None, dropped: dict[int, tuple[float, float]], scene_end: float
) -> tuple[float, float]:
    """When a show or an add lets go, and when nothing of it is left."""
    assert isinstance(act.verb, (Show, Add))
    if not act.verb.mix.terms:
        return act.start, act.start
    found = [(act.released, act.end), (scene_end, scene_end)]
    if later is not None:
        found.append((later.start, _risen(later)))
    if act.order in dropped:
        found.append(dropped[act.order])
    return min(found)


def _risen(act: TimedAct) -> float:
    """When a show or an add is at its apex."""
    return layer(act, {}).rise.end


def _dropped(acts: Sequence[TimedAct]) -> dict[int, tuple[float, float]]:
    """When the last term of a show or add is dropped and gone, by its order."""
    left = {act.order: len(act.verb.mix.terms) for act in acts if isinstance(act.verb, (Show, Add))}
    found: dict[int, tuple[float, float]] = {}
    for act in acts:
        for order, _ in act.drops if isinstance(act.verb, Drop) else ():
            left[order] -= 1
            if left[order] == 0:
                found[order] = act.start, act.settled
    return found


def _gestures(acts: Sequence[TimedAct]) -> Iterator[Bar]:
    for act in acts:
        if isinstance(act.verb, Gesture):
            yield _bar(act, act.start, act.end, act.end)


def _lines(score: Score, acts: Sequence[TimedAct], face: str) -> Iterator[Bar]:
    said = {(_place(act.span), act.start): act for act in acts if isinstance(act.verb, Say)}
    for line in score.lines:
        if line.face == face:
            yield _line(line, said.get((_place(line.span), line.start)))


def _line(line: TimedLine, act: TimedAct | None) -> Bar:
    label = f"“{line.text}”"
    note = _note(label if line.cut is None else f"{label} (breaks off)", line.span, line.start, line.end)
    return Bar(line.start, line.start, line.end, line.end, label, note, line.span, act)


def _lives(score: Score, acts: Sequence[TimedAct], face: Face) -> Iterator[Bar]:
    """The life a face has, from each change to the next; nothing where it is still."""
    for number, scene in enumerate(score.scenes):
        if face.name not in scene.faces or not face.seen:
            continue
        changes: list[tuple[float, float, Life, Span, TimedAct | None]] = [
            (scene.start, scene.start, face.life, face.span, None)
        ]
        for act in acts:
            if act.scene == number and isinstance(act.verb, SetLife):
                changes.append((act.start, act.start + seconds(act.verb.over), act.verb.life, act.span, act))
        ends = [change[0] for change in changes[1:]] + [scene.end]
        for (start, apex, life, span, set_by), end in zip(changes, ends, strict=True):
            if end > start and life.name != "still":
                note = _note(f"life {life.name}", span, start, end)
                yield Bar(start, min(apex, end), end, end, life.name, note, span, set_by)


def _replaced(score: Score, acts: Sequence[TimedAct]) -> Iterator[Bar]:
    """Acts of which each holds until the next, or the scene's end."""
    for number, act in enumerate(acts):
        later = acts[number + 1] if number + 1 < len(acts) else None
        end = score.scenes[act.scene].end
        if later is not None and later.scene == act.scene:
            end = later.start
        if end > act.start:
            yield _bar(act, min(act.settled, end), end, end)


def _event(event: Happening, span: Span) -> Bar:
    what = f"{event.person} {event.kind}" if event.person else f"{event.kind} “{event.text}”"
    return Bar(event.time, event.time, event.time, event.time, what, f"event {what}\n{duration(event.time)}", span)


# ------------------------------------------------------------------------------------------------ bars


def _bar(act: TimedAct, apex: float, release: float, end: float) -> Bar:
    label = _label(act.verb)
    note = _note(phrase(act.verb), act.span, act.start, end)
    return Bar(act.start, apex, release, end, label, note, act.span, act)


def _label(verb: Verb) -> str:
    """The phrase without the verb that the lane's name says already."""
    text = phrase(verb)
    return text.removeprefix("background ").removeprefix("view ").removeprefix("look at ").removeprefix("look ")


def _steady(start: float, end: float, label: str, note: str) -> Bar:
    return Bar(start, start, end, end, label, note)


def _note(what: str, span: Span, start: float, end: float) -> str:
    line, _ = span.source.position(span.start)
    return f"{what}\n{span.source.name}:{line}\n{start:.3f} s to {end:.3f} s"


def _place(span: Span) -> tuple[str, int]:
    return span.source.name, span.start
