"""Which lines of different faces sound at once without a word that they shall."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.diagnostics.model import Related
from facescript.ir.acts import At, Together, in_pass
from facescript.schedule.conflicts import by_face
from facescript.schedule.deeds import Sounding
from facescript.schedule.faults import Faults, When
from facescript.schedule.steps import SETTLED, START, Step
from facescript.schedule.voices import CLOSE


def voices_together(sounds: Iterable[Sounding], faults: Faults) -> None:
    """Report lines of two faces that overlap in one scene or reaction, where nothing says that it is meant."""
    for row in by_face((id(sound.step.root), sound.start, sound) for sound in sounds):
        last: list[Sounding] = []
        for sound in row:
            before = next((one for one in last if one.face != sound.face), None)
            if before is not None and before.end > sound.start + CLOSE and not _meant(before, sound):
                _overlap(before, sound, faults)
            last = _last(last, sound)


def _last(last: list[Sounding], sound: Sounding) -> list[Sounding]:
    """The line that ends last, and that which does of all the other faces': more are not needed."""
    first, *others = sorted((*last, sound), key=lambda one: -one.end)
    return [first, *[one for one in others if one.face != first.face][:1]]


def _overlap(before: Sounding, sound: Sounding, faults: Faults) -> None:
    faults.add(
        "FS426",
        sound.step.node.span,
        Related(before.step.node.span, "the other line"),
        face=sound.face,
        other=before.face,
        start=When(sound.start, sound.step.rough(START)),
        end=When(before.end, before.step.rough(SETTLED)),
    )


def _meant(before: Sounding, sound: Sounding) -> bool:
    """Whether lines are to sound at once: they start together, stand in branches of one `together:`, the one is spoken
    on a word of the other, or it is set by a word or by the end of the other."""
    if sound.start - before.start < CLOSE:
        return True
    ours, theirs = _line_of(sound.step), _line_of(before.step)
    shared = [one for one, other in zip(ours, theirs, strict=False) if one is other]
    if isinstance(shared[-1].node, Together) or before.step in shared or sound.step in shared:
        return True
    depth = len(shared)
    return any(_set_by(step, before.step) for step in ours[depth:]) or any(
        _set_by(step, sound.step) for step in theirs[depth:]
    )


def _set_by(step: Step, line: Step) -> bool:
    """Whether a step is an `at` that refers to a word or to the end of a line."""
    mark = step.node.moment.mark if isinstance(step.node, At) else None
    if mark is None or line.node.label is None or (mark.word is None and mark.edge == "start"):
        return False
    return in_pass(mark.label, step.passes) == in_pass(line.node.label, line.passes)


def _line_of(step: Step) -> list[Step]:
    """The steps that a step stands in, from the root to itself."""
    line = []
    above: Step | None = step
    while above is not None:
        line.append(above)
        above = above.parent
    return line[::-1]
