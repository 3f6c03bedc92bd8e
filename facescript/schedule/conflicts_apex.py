"""Which expressions do not come to be what they were to be: covered or dropped before their apex, or hurried to it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from facescript.diagnostics.model import Related
from facescript.diagnostics.wording import tell
from facescript.ir.acts import Add, Do, Drop, Show
from facescript.performance.polynomials import POLYNOMIALS
from facescript.schedule.conflicts import by_face, covers
from facescript.schedule.deeds import Deed
from facescript.schedule.defaults import seconds
from facescript.schedule.drops import Key
from facescript.schedule.faults import Faults, When
from facescript.schedule.steps import START
from facescript.schedule.voices import CLOSE

REACHED = 0.9
"""The part of an apex from which on it is seen as reached."""

HURRIED = 2 / 3
"""An expression that must rise in less than this part of the time it was given is told. A word that an inline cue lies
on is often a little short."""

STEPS = 32
"""Moments between which the highest point of what is let go is sought."""


@dataclass(frozen=True, slots=True)
class _Change:
    """A rise or a fall: its curve's name, its start, s, and its length, s."""

    ease: str | None
    start: float
    length: float

    @property
    def end(self) -> float:
        return self.start + self.length

    def at(self, time: float) -> float:
        """The share done."""
        if time >= self.end:
            return 1.0
        done: float = POLYNOMIALS[self.ease or "smooth"](max(0.0, time - self.start) / self.length)
        return done


def apexes_missed(deeds: Sequence[Deed], drops: Mapping[int, tuple[Key, ...]], faults: Faults) -> None:
    """Report the shows and adds of one scene or reaction that a show covers or a drop takes away before their apex, by
    what is drawn of them; and those that a `for` hurries. `deeds` are in their order, `drops` the terms of each."""
    for deed in deeds:
        if isinstance(deed.verb, (Show, Add)):
            _hurried(deed, faults)
    shows = [deed for deed in deeds if isinstance(deed.verb, Show)]
    for row in by_face(((deed.face, id(deed.root)), deed.start, deed) for deed in shows):
        for deed, cover in zip(row, covers(row), strict=True):
            if cover is not None and cover.start - deed.start >= CLOSE and not _goes_on(deed, cover):
                _missed(deed, cover, "this covers it", faults)
    for deed, drop in _dropped(deeds, drops):
        if drop.root is deed.root:
            _missed(deed, drop, "this drops it", faults)


def _dropped(deeds: Sequence[Deed], drops: Mapping[int, tuple[Key, ...]]) -> Iterator[tuple[Deed, Deed]]:
    """What is dropped and its drop; a statement once, however many of its terms are."""
    for order, keys in drops.items():
        for worn in dict.fromkeys(worn for worn, _ in keys):
            yield deeds[worn], deeds[order]


def _missed(deed: Deed, other: Deed, how: str, faults: Faults) -> None:
    rise = _rise(deed)
    if other.start >= rise.end - CLOSE or faults.known("FS425", deed.step.node.span):
        return
    reached = _peak(rise, _rise(other))
    if reached >= REACHED:
        return
    rough = deed.step.rough(START) or other.step.rough(START)
    faults.add(
        "FS425",
        deed.step.node.span,
        Related(other.step.node.span, how),
        time=When(other.start, rough),
        apex=When(rise.end, rough),
        reached=f"{100 * reached:.0f} %",
    )


def _hurried(deed: Deed, faults: Faults) -> None:
    """A rise that was given more time than `for`, or the words it lies on, leave. Where a scene or a line is cut, it
    is nobody's wish."""
    node = deed.step.node
    assert isinstance(node, Do) and isinstance(node.verb, (Show, Add)) and isinstance(deed.verb, (Show, Add))
    if node.verb.timing.over is None and not node.verb.timing.manner:
        return
    asked, given = seconds(deed.verb.timing.over), _rise(deed).length
    if given < HURRIED * asked and deed.release < deed.step.limit - CLOSE:
        rough = deed.step.rough(START)
        times = {"apex": When(deed.start + asked, rough), "release": When(deed.release, rough)}
        faults.add("FS424", node.span, asked=tell(asked), given=tell(given), **times)


def _rise(deed: Deed) -> _Change:
    """How a show or an add comes, and how a drop takes away."""
    assert isinstance(deed.verb, (Show, Add, Drop))
    timing = deed.verb.timing
    return _Change(timing.ease, deed.start, min(seconds(timing.over), deed.release - deed.start))


def _peak(rise: _Change, fall: _Change) -> float:
    """The highest share of its apex that something comes to which is taken away while it rises."""
    end = min(rise.end, fall.end)
    moments = (fall.start + (end - fall.start) * step / STEPS for step in range(1, STEPS))
    return max([rise.at(fall.start), *(rise.at(moment) * (1.0 - fall.at(moment)) for moment in moments)])


def _goes_on(deed: Deed, later: Deed) -> bool:
    """Whether a later show shows all that a show does, as strongly or more."""
    assert isinstance(deed.verb, Show) and isinstance(later.verb, Show)
    more = {term.name: seconds(term.degree) for term in later.verb.mix.terms}
    shares = ((seconds(term.degree), more.get(term.name, 0.0)) for term in deed.verb.mix.terms)
    return all(min(0.0, other) <= degree <= max(0.0, other) for degree, other in shares)
