"""What is wrong with a play's times to diagnostics: each statement is reported once, however often it is played."""

from __future__ import annotations

from dataclasses import dataclass, field

from facescript.diagnostics.catalogue import diagnose
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


@dataclass(slots=True)
class Faults:
    """The faults of one round, each place once for each code."""

    found: dict[tuple[str, str, int, int], Diagnostic] = field(default_factory=dict)
    reasons: set[str] = field(default_factory=set)

    def add(self, code: str, span: Span, *related: Related, **values: object) -> None:
        """A fault, unless this place has it already."""
        if not self.known(code, span):
            self.found[_key(code, span)] = diagnose(code, span, fixes=(), related=related, **values)

    def known(self, code: str, span: Span) -> bool:
        """Whether this place has it already."""
        return _key(code, span) in self.found

    @property
    def failed(self) -> bool:
        """Whether any of them is an error."""
        return any(fault.severity is Severity.ERROR for fault in self.found.values())

    def hand_over(self, diagnostics: Diagnostics) -> None:
        """Append them, errors first. In a circle no time is sure, so what only follows from its times is left out."""
        order = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.HINT: 2}
        circle = any(fault.code == "FS405" for fault in self.found.values())
        for fault in sorted(self.found.values(), key=lambda fault: order[fault.severity]):
            if not (circle and fault.code in TIMED):
                diagnostics.add(fault)

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
        self.add("FS407" if rough else "FS406", step.node.span, time=tell(time), now=tell(now))

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
        self.add("FS417", span, time=tell(time), long=tell(long))

    def unplayed(self, scene: Scene, start: float, long: float) -> None:
        if start == NEVER:
            self.add("FS413", scene.span)
        else:
            self.add("FS414", scene.span, long=tell(long), start=tell(start))

    def not_chosen(self, step: Step, mark: Mark) -> None:
        self.add("FS415", step.node.span, label=short(mark.label))

    def voice(self, span: Span, failure: VoiceFailure) -> None:
        """A line that cannot be spoken; what is wrong with a voice is said once."""
        reason = str(failure.args[0])
        if reason not in self.reasons:
            self.reasons.add(reason)
            self.add(failure.code, span, reason=reason)


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
