"""What an account of a channel at a moment is made of."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.performance.channels import Channel
from facescript.schedule.phrases import phrase
from facescript.schedule.score import TimedAct


@dataclass(frozen=True, slots=True)
class Source:
    """What moves a channel: a statement with its place (`file`, `line` from 1) and label, or what has no place of its
    own: a face's life, the scene's start, another channel."""

    what: str
    file: str | None = None
    line: int | None = None
    label: str | None = None


@dataclass(frozen=True, slots=True)
class Part:
    """One contribution: what it asks of the channel at its `full` strength, in the channel's unit (of a blink: 0..1),
    and the `share` of that which counts at the moment. `state` says where it stands."""

    source: Source
    full: float
    share: float
    state: str = ""

    @property
    def value(self) -> float:
        return self.full * self.share


@dataclass(frozen=True, slots=True)
class Step:
    """One rule of the law: the value it leaves, in the channel's unit, and the parts that it takes in."""

    rule: str
    value: float
    parts: tuple[Part, ...] = ()


@dataclass(frozen=True, slots=True)
class Account:
    """Who owned a channel of a face at `time` (seconds from the film's start), and how its value came about.

    `owner` is None where nothing of the script does. The last step's value is the one that is drawn.
    """

    face: str
    channel: Channel
    time: float
    owner: Source | None
    steps: tuple[Step, ...]

    @property
    def value(self) -> float:
        return self.steps[-1].value

    @property
    def at_rest(self) -> bool:
        """Whether nothing moves the channel."""
        return not any(step.parts for step in self.steps) and self.value == self.channel.rest


def statement(act: TimedAct, detail: str = "") -> Source:
    """An act as an author finds it; `detail` says which part of it."""
    line, _ = act.span.source.position(act.span.start)
    return Source(phrase(act.verb) + detail, act.span.source.name, line, act.label)
