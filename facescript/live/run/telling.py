"""A score that grows to what is told of it: marks, each once, and lines before they sound."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from facescript.ir.acts import Say
from facescript.live.model import Happening, Mark, Utterance
from facescript.schedule.phrases import phrase
from facescript.schedule.score import Score, TimedAct, TimedLine

AHEAD = 0.5
"""Seconds before a line sounds that it is told of."""


class Marks:
    """What begins, in the order of time; each once, whatever the score has become since."""

    def __init__(self) -> None:
        self._until = -inf
        self._told: set[Mark] = set()

    def tell(self, score: Score, heeded: list[Mark], time: float) -> list[Mark]:
        """What began since the last call up to a time, and the events that were `heeded`."""
        found = [mark for mark in _marks(score, self._until, time) if mark not in self._told]
        self._told = {mark for mark in (*self._told, *found) if mark.time >= time}
        self._until = time
        return sorted((*heeded, *dict.fromkeys(found)), key=lambda mark: mark.time)


def _marks(score: Score, since: float, until: float) -> Iterator[Mark]:
    """All that begins from `since` up to `until`, both included."""
    for scene in score.scenes:
        if since <= scene.start <= until:
            yield Mark("scene", scene.start, scene.title or scene.name)
    for act in score.acts:
        if since <= act.start <= until and not isinstance(act.verb, Say):
            yield _act(act)
    for line in score.lines:
        if line.start <= until and line.end >= since:
            yield from (mark for mark in _line(line) if since <= mark.time <= until)


def _act(act: TimedAct) -> Mark:
    return Mark("act", act.start, phrase(act.verb), act.face, act.label)


def _line(line: TimedLine) -> Iterator[Mark]:
    yield Mark("line", line.start, line.text, line.face, line.label)
    for word in line.spoken.words:
        if line.start + word.start < line.end:
            yield Mark("word", line.start + word.start, word.text, line.face, line.label)
    if line.cut is not None:
        yield Mark("breaks", line.cut, line.text, line.face, line.label)


def of_event(event: Happening) -> Mark:
    """An event that was heeded."""
    return Mark("event", event.time, " ".join(filter(None, (event.person, event.kind, event.text))))


class Utterances:
    """Lines from half a second before they sound; each again where it is cut, or comes to nothing."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, float, int], Utterance] = {}
        self._count = 0

    def tell(self, score: Score, time: float) -> list[Utterance]:
        """What is new to be told of the lines that sound before `AHEAD` seconds after a time."""
        found = []
        coming = [line for line in score.lines if line.start <= time + AHEAD and line.end > time - AHEAD]
        keys = {_key(line): line for line in coming}
        for key, told in self._told.items():
            if key not in keys and told.start > time and told.cut is None:
                found.append(_cut(told, told.start))
        for key, line in keys.items():
            known = self._told.get(key)
            if known is None and line.end > time:
                found.append(self._new(line))
            elif known is not None and known.cut != line.cut:
                found.append(_cut(known, line.cut))
        for utterance in found:
            self._told[utterance.face, utterance.start, id(utterance.spoken)] = utterance
        self._told = {key: one for key, one in self._told.items() if one.start + one.spoken.duration > time - AHEAD}
        return found

    def _new(self, line: TimedLine) -> Utterance:
        self._count += 1
        return Utterance(self._count, line.face, line.start, line.spoken, line.volume, line.text, line.cut)


def _key(line: TimedLine) -> tuple[str, float, int]:
    return line.face, line.start, id(line.spoken)


def _cut(told: Utterance, cut: float | None) -> Utterance:
    return Utterance(told.number, told.face, told.start, told.spoken, told.volume, told.text, cut)
