"""Which looks come to nothing: two of a face that take the same part at once, and looks too short for eyes or head."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import pairwise

from facescript.diagnostics.model import Related
from facescript.diagnostics.wording import tell
from facescript.ir.acts import Glance, Look, Scan
from facescript.schedule.conflicts import by_face, covers
from facescript.schedule.deeds import Deed
from facescript.schedule.defaults import seconds
from facescript.schedule.faults import Faults, When
from facescript.schedule.steps import START
from facescript.schedule.voices import CLOSE
from facescript.space.plan import GazePlan

EARLY = 1e-3
"""Seconds that a look may end before it has landed: the lengths of looks are rounded (`looks.GRAIN`)."""

SMALL = 0.5
"""A shift of so few degrees comes to nothing when it is cut, and nobody sees it."""

Plans = Mapping[int, tuple[GazePlan, ...]]


def looks_lost(deeds: Sequence[Deed], plans: Plans, faults: Faults) -> None:
    """Report looks, glances and scans of one scene or reaction that take a part together, and those that are over
    before their eyes (or, with `head only`, the head) are there. What another reaction interrupts is meant."""
    looks = [deed for deed in deeds if isinstance(deed.verb, (Look, Glance, Scan)) and plans.get(deed.order)]
    for row in by_face(((deed.face, id(deed.root)), onset(deed), deed) for deed in looks):
        for before, deed in pairwise(row):
            if onset(deed) - onset(before) < CLOSE:
                _together(before, deed, plans, faults)
        taken = {part: covers(row, partial(_uses, part)) for part in ("eyes", "head")}
        for deed, *takers in zip(row, taken["eyes"], taken["head"], strict=True):
            _too_short(deed, takers[_leads(deed) == "head"], plans[deed.order][0], faults)
            if isinstance(deed.verb, Scan):
                _hurried(deed, plans[deed.order], faults)


def onset(deed: Deed) -> float:
    """When a look begins, its latency included."""
    assert isinstance(deed.verb, (Look, Glance, Scan))
    return deed.start + seconds(deed.verb.manner.latency)


def _together(before: Deed, deed: Deed, plans: Plans, faults: Faults) -> None:
    """The later of two wins. A jump to what the other one leaves and comes back to is in nobody's way."""
    both = _parts(before) & _parts(deed)
    back = deed.release < before.release
    if not both or (back and plans[before.order][0].instant):
        return
    rough = before.step.rough(START) or deed.step.rough(START)
    faults.add(
        "FS605",
        deed.step.node.span,
        Related(before.step.node.span, "the other look"),
        face=deed.face,
        part=" and ".join(sorted(both)),
        start=When(onset(deed), rough),
        until=When(deed.release, rough, " until {}") if back else "",
    )


def _too_short(deed: Deed, taker: Deed | None, plan: GazePlan, faults: Faults) -> None:
    """`taker` takes the part that the look leads with, for good. One that starts with it is told as such."""
    if plan.amplitude < SMALL or plan.instant:
        return
    taken = deed.release if taker is None else onset(taker)
    if taker is not None and taken < min(plan.landed, deed.release) - EARLY:
        if taken - onset(deed) >= CLOSE:
            _short(deed, plan, "This look", taken, (Related(taker.step.node.span, "this takes its place"),), faults)
    elif deed.release < min(plan.landed - EARLY, deed.step.limit - CLOSE):
        _short(deed, plan, "This look", deed.release, (), faults)


def _hurried(deed: Deed, plans: tuple[GazePlan, ...], faults: Faults) -> None:
    """A scan that looks on before the eyes have come to one of the crowd."""
    stops = [plan for plan in plans if plan.starts < deed.release]
    for stop, following in pairwise(stops):
        if following.starts < stop.landed - EARLY and stop.amplitude >= SMALL:
            _short(deed, stop, "A look of this scan", following.starts, (), faults)
            return


def _short(deed: Deed, plan: GazePlan, what: str, end: float, related: tuple[Related, ...], faults: Faults) -> None:
    rough = deed.step.rough(START)
    faults.add(
        "FS606",
        deed.step.node.span,
        *related,
        what=what,
        face=deed.face,
        part=_leads(deed),
        end=When(end, rough),
        landed=When(plan.landed, rough),
        need=tell(plan.landed - plan.starts),
    )


def _parts(deed: Deed) -> set[str]:
    assert isinstance(deed.verb, (Look, Glance, Scan))
    only = {"eyes only": {"eyes"}, "head only": {"head"}}
    return only.get(deed.verb.manner.parts, {"eyes", "head"})


def _uses(part: str, deed: Deed) -> bool:
    return part in _parts(deed)


def _leads(deed: Deed) -> str:
    """The part that has to be there."""
    return "eyes" if "eyes" in _parts(deed) else "head"
