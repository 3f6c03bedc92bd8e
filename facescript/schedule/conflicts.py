"""What cannot be at one time: two lines of a face, two shows of it that start together; and what is left out."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import TypeVar

from facescript.diagnostics.model import Related
from facescript.ir.acts import Drop, Show, in_pass
from facescript.schedule.deeds import Deed, Sounding
from facescript.schedule.drops import Key
from facescript.schedule.faults import Faults, When, short
from facescript.schedule.steps import NEVER, SETTLED, START, Step
from facescript.schedule.voices import CLOSE


def lines_together(sounds: Iterable[Sounding], faults: Faults) -> None:
    """Report lines of a face that overlap in one scene or reaction. Where only an estimate says so it is a warning."""
    for row in by_face(((sound.face, id(sound.step.root)), sound.start, sound) for sound in sounds):
        before = row[0]
        for sound in row[1:]:
            if sound.start < before.end - CLOSE:
                _overlap(before, sound, faults)
            before = max(before, sound, key=lambda one: one.end)


def _overlap(before: Sounding, sound: Sounding, faults: Faults) -> None:
    span = sound.step.node.span
    other = Related(before.step.node.span, "the other line")
    guessed = before.step.rough(START) or sound.step.rough(START)
    start, end = When(sound.start), When(before.end)
    if not guessed and sound.start - before.start < CLOSE:
        faults.add("FS401", span, other, face=sound.face, other=start)
    elif guessed or before.step.rough(SETTLED):
        faults.add("FS402", span, other, face=sound.face, start=start, end=end)
    else:
        faults.add("FS403", span, other, face=sound.face, start=start, end=end)


def shows_together(deeds: Iterable[Deed], faults: Faults) -> None:
    """Report shows of a face that start at one time in one scene or reaction."""
    shows = [deed for deed in deeds if isinstance(deed.verb, Show)]
    for row in by_face(((deed.face, id(deed.root)), deed.start, deed) for deed in shows):
        for before, deed in pairwise(row):
            if deed.start - before.start < CLOSE:
                other = Related(before.step.node.span, "the other `show`")
                guessed = before.step.rough(START) or deed.step.rough(START)
                code = "FS421" if guessed else "FS404"
                faults.add(code, deed.step.node.span, other, face=deed.face, start=When(deed.start))


def left_out(late: Sequence[Step], cut: Sequence[tuple[Step, float]], long: float, faults: Faults) -> None:
    """Report the first statement that is never reached, and the first that the film's end cuts off; `cut` are repeats
    that it ends."""
    loud = [(step, step.time(START)) for step in late if not step.hushed]
    never = [step for step, start in loud if start == NEVER]
    if never:
        faults.add("FS413", never[0].node.span, once=True)
    beyond = [(step, start) for step, start in (*loud, *cut) if long <= start < NEVER and not step.hushed]
    if beyond:
        step, start = min(beyond, key=lambda one: one[1])
        faults.add("FS414", step.node.span, once=True, long=When(long), start=When(start))


def nothing_dropped(
    idle: Sequence[Deed], drops: Mapping[int, tuple[Key, ...]], deeds: Sequence[Deed], faults: Faults
) -> None:
    """Report the drops of a scene that find nothing, however often they are played. What a reaction finds depends on
    when its event comes."""
    useful = {id(deeds[order].step.node) for order, terms in drops.items() if terms}
    labels = {name for deed in deeds for name in deed.names} if idle else set()
    for deed in idle:
        if isinstance(deed.verb, Drop) and not deed.root.reaction and id(deed.step.node) not in useful:
            label = in_pass(deed.verb.name, deed.step.passes)
            name = short(label) if label in labels else label
            faults.add("FS416", deed.step.node.span, face=deed.face, name=name)


def covers(row: Sequence[Deed], within: Callable[[Deed], bool] = lambda deed: True) -> list[Deed | None]:
    """For each deed of a row in time the first after it, of those `within`, that lasts as long or longer: what it
    covers does not come back. One pass from the last to the first, whatever the row is like."""
    found: list[Deed | None] = []
    longest: list[Deed] = []
    for deed in reversed(row):
        while longest and longest[-1].release < deed.release:
            longest.pop()
        found.append(longest[-1] if longest else None)
        if within(deed):
            longest.append(deed)
    return found[::-1]


Item = TypeVar("Item")


def by_face(items: Iterable[tuple[Hashable, float, Item]]) -> Iterable[list[Item]]:
    """The items of each face (or whatever stands first) in the order of their times."""
    rows: dict[Hashable, list[tuple[float, Item]]] = {}
    for face, time, item in items:
        rows.setdefault(face, []).append((time, item))
    return [[item for _, item in sorted(row, key=lambda entry: entry[0])] for row in rows.values()]
