"""What is wrong with a play's times to diagnostics: each statement is reported once, however often it is played.

Times are noted from the start of the part of the film that is solved, and told from the film's own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from facescript.diagnostics.catalogue import CATALOGUE, diagnose
from facescript.diagnostics.model import Diagnostic, Diagnostics, Related, Severity
from facescript.diagnostics.wording import tell
from facescript.ir.acts import At, Cue, Do, WaitUntil
from facescript.ir.play import Scene
from facescript.ir.values import Mark
from facescript.schedule.solver import Need
from facescript.schedule.steps import NEVER, Step
from facescript.speech.model import VoiceFailure
from facescript.text import Span

TIMED = ("FS406", "FS407", "FS408", "FS409")
"""What depends on when something is, not only on what refers to what."""

EARLY = ("FS408", "FS409")
"""What reaches before the start of what is solved."""


@dataclass(frozen=True, slots=True)
class When:
    """A time in a message, seconds from the start of what is solved; `text` has it at its `{}`."""

    time: float
    rough: bool = False
    text: str = "{}"

    def told(self, start: float) -> str:
        """The time for an author, from the film's start."""
        return self.text.format(tell(start + self.time, self.rough))


@dataclass(frozen=True, slots=True)
class Fault:
    """A code, its place and what is said of it; `once` is what is told at one place of the film only."""

    code: str
    span: Span
    related: tuple[Related, ...]
    values: dict[str, object]
    once: object

    @property
    def error(self) -> bool:
        return CATALOGUE[self.code].severity is Severity.ERROR

    def told(self, start: float) -> Diagnostic:
        """The diagnostic of what is solved from `start` on, seconds of the film."""
        values = {name: value.told(start) if isinstance(value, When) else value for name, value in self.values.items()}
        return diagnose(self.code, self.span, fixes=(), related=self.related, **values)


@dataclass(slots=True)
class Faults:
    """The faults of one round, each place once for each code."""

    found: dict[tuple[str, str, int, int], Fault] = field(default_factory=dict)

    def add(self, code: str, span: Span, *related: Related, once: object = None, **values: object) -> None:
        """A fault, unless this place has it already. Of those that are the same `once` the film's first is told."""
        if not self.known(code, span):
            self.found[_key(code, span)] = Fault(code, span, related, values, once)

    def known(self, code: str, span: Span) -> bool:
        """Whether this place has it already."""
        return _key(code, span) in self.found

    @property
    def failed(self) -> bool:
        """Whether any of them is an error."""
        return any(fault.error for fault in self.found.values())

    # -------------------------------------------------------------------------------------------- by code

    def circle(self, needs: list[Need]) -> None:
        """Each of these needs the next, the last the first: the references among them are shown."""
        marks = [(step, mark) for step, _ in needs if (mark := mark_of(step)) is not None]
        marks = [entry for index, entry in enumerate(marks) if entry[0] not in [other for other, _ in marks[:index]]]
        names = [spelled(mark) for _, mark in marks]
        if len(names) > 1:
            circle = ", which waits for ".join(f"`{name}`" for name in [*names, names[0]])
        else:
            circle = f"`{names[0]}`, which waits for this"
        related = [Related(step.node.span, f"this waits for `{spelled(mark)}`") for step, mark in marks[1:]]
        borne = {mark.label for _, mark in marks}
        for step, _ in needs:
            if step.node.label in borne and isinstance(step.node, Do):
                related.append(Related(step.node.span, f"this is `{short(step.node.label or '')}`"))
        self.add("FS405", marks[0][0].node.span, *dict.fromkeys(related), circle=circle)

    def past(self, step: Step, time: float, now: float, rough: bool) -> None:
        self.add("FS407" if rough else "FS406", step.node.span, time=When(time), now=When(now))

    def before_start(self, step: Step, time: float, rough: bool) -> None:
        early = tell(step.root.start - time)
        self.add("FS409" if rough else "FS408", step.node.span, early=early)

    def no_time(self, step: Step) -> None:
        self.add("FS410", step.node.span)

    def endless(self, step: Step) -> None:
        self.add("FS411", step.node.span)

    def empty_cue(self, cue: Cue) -> None:
        self.add("FS420", cue.body.span)

    def event_late(self, span: Span, time: float, long: float) -> None:
        self.add("FS417", span, time=When(time), long=When(long))

    def unplayed(self, scene: Scene, start: float, long: float) -> None:
        if start == NEVER:
            self.add("FS413", scene.span)
        else:
            self.add("FS414", scene.span, long=When(long), start=When(start))

    def not_chosen(self, step: Step, mark: Mark) -> None:
        self.add("FS415", step.node.span, label=short(mark.label))

    def voice(self, span: Span, failure: VoiceFailure) -> None:
        """A line that cannot be spoken; what is wrong with a voice is said once."""
        reason = str(failure.args[0])
        self.add(failure.code, span, once=reason, reason=reason)


def hand_over(faults: Sequence[tuple[Fault, float]], diagnostics: Diagnostics) -> None:
    """Append the faults of a film, each with the start of its part, errors first. In a circle no time is sure, so what
    only follows from its times is left out."""
    order = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.HINT: 2}
    circle = any(fault.code == "FS405" for fault, _ in faults)
    known: set[tuple[str, object]] = set()
    told = []
    for fault, start in faults:
        keys = (
            [(fault.code, fault.span)] if fault.once is None else [(fault.code, fault.span), (fault.code, fault.once)]
        )
        if known.isdisjoint(keys) and not (circle and fault.code in TIMED):
            told.append(fault.told(start))
        known.update(keys)
    for item in sorted(told, key=lambda item: order[item.severity]):
        diagnostics.add(item)


def _key(code: str, span: Span) -> tuple[str, str, int, int]:
    return code, span.source.name, span.start, span.end


def mark_of(step: Step) -> Mark | None:
    """The mark that a step's own time refers to."""
    node = step.node
    if isinstance(node, At):
        return node.moment.mark
    return node.verb.moment.mark if isinstance(node, Do) and isinstance(node.verb, WaitUntil) else None


def spelled(mark: Mark) -> str:
    """A mark as an author writes it: `hello."cup".2.end`."""
    word = "" if mark.word is None else f'."{mark.word}"' + (f".{mark.nth}" if mark.nth > 1 else "")
    return f"{short(mark.label)}{word}" + ("" if word and mark.edge == "start" else f".{mark.edge}")


def short(label: str) -> str:
    """The name that an author gave, out of a full label."""
    return label.rpartition(".")[2]
