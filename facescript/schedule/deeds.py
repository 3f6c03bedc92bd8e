"""Solved steps to deeds: what is really done, in the order written, with what is cut left out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from facescript.ir.acts import (
    Add,
    Do,
    Drop,
    Gesture,
    Glance,
    Look,
    Perform,
    Say,
    Scan,
    Show,
    Verb,
    Wait,
    WaitUntil,
    in_pass,
)
from facescript.schedule.defaults import seconds
from facescript.schedule.steps import NEVER, SETTLED, START, Root, Step
from facescript.schedule.voices import Voices, whole_words, word_end


@dataclass(slots=True)
class Deed:
    """One act, once: a verb with plain numbers, at its time. `order` is its place among all that is written, `release`
    when it begins to let go. `names` are its label and those of the blocks it stands in."""

    order: int
    step: Step
    verb: Verb
    face: str | None
    start: float
    settled: float
    release: float
    names: tuple[str, ...]

    @property
    def root(self) -> Root:
        return self.step.root

    @property
    def label(self) -> str | None:
        return in_pass(self.step.node.label, self.step.passes) if self.step.node.label else None


@dataclass(frozen=True, slots=True)
class Sounding:
    """A line that sounds from `start` to `end`; `cut` where it breaks off there."""

    step: Step
    face: str
    line: Say
    start: float
    end: float
    cut: bool


def walk(roots: Iterable[Root]) -> Iterator[tuple[Step, tuple[str, ...]]]:
    """Every step in the order written, with its label and those of the steps it stands in."""
    waiting: list[tuple[Step, tuple[str, ...]]] = []
    waiting += [(root.top, ()) for root in reversed(tuple(roots))]
    while waiting:
        step, around = waiting.pop()
        if step.over:
            continue
        label = step.node.label
        names = (*around, in_pass(label, step.passes)) if label else around
        yield step, names
        if step.children:
            waiting += [(child, names) for child in reversed(step.children)]


def deeds(roots: Iterable[Root], voices: Voices, before: int = 0) -> tuple[list[Deed], list[Step]]:
    """What is done, and the steps that come too late to be done; so many deeds were done before."""
    done: list[Deed] = []
    late: list[Step] = []
    for step, names in walk(roots):
        node = step.node
        if not isinstance(node, Do) or isinstance(node.verb, (Wait, WaitUntil)):
            continue
        start = step.sayings[0][0] if step.sayings else step.time(START)
        if start >= min(step.limit, step.until):
            late.append(step)
        else:
            assert step.verb is not None
            release = _release(step, step.verb, start)
            settled = _settled(step, step.verb, release, voices)
            done.append(Deed(before + len(done), step, step.verb, node.face, start, settled, release, names))
    return done, late


def soundings(step: Step, voices: Voices) -> Iterator[Sounding]:
    """The sayings of a line as far as they sound: not from its limit on, and to the last whole word before it. A
    reaction that its event starts afresh ends the word it is at."""
    node = step.node
    assert isinstance(node, Do) and isinstance(node.verb, Say) and node.face is not None
    spoken = voices.speak(node.verb, node.span)
    for start, cut in step.sayings:
        if start >= step.limit:
            continue
        end = start + spoken.duration if cut is None else cut
        if end > step.limit:
            rule = word_end if step.root.reaction else whole_words
            stop = start + rule(spoken, step.limit - start)
            if stop < end:
                yield Sounding(step, node.face, node.verb, start, stop, True)
                continue
        yield Sounding(step, node.face, node.verb, start, end, cut is not None)


def _settled(step: Step, verb: Verb, release: float, voices: Voices) -> float:
    """When the next may start; sooner than was meant where the act is cut."""
    settled = step.time(SETTLED)
    if isinstance(verb, Say):
        return max(sound.end for sound in soundings(step, voices))
    if isinstance(verb, (Look, Glance, Show, Add, Perform)) and verb.timing.lasting is not None:
        return min(settled, release)
    return settled


def _release(step: Step, verb: Verb, start: float) -> float:
    """When an act begins to let go: after its `for`, with its cue, or with what it stands in where that is cut."""
    if isinstance(verb, (Look, Glance, Show, Add, Perform)):
        lasting = verb.timing.lasting
        release = min(NEVER if lasting is None else start + seconds(lasting), step.until)
        kept = release == NEVER and not (isinstance(verb, Add) and step.root.afresh)
        return NEVER if kept else min(release, step.limit)
    if isinstance(verb, Scan):
        return min(step.time(SETTLED), step.until, step.limit)
    if isinstance(verb, (Gesture, Say, Drop)):
        return step.time(SETTLED)
    return NEVER
