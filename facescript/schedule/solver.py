"""Times by demand: a rule asks for the times it needs, each is worked out once, and a circle is found and shown."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field
from typing import Protocol

from facescript.schedule.steps import Step, Time

Need = tuple[Step, int]
"""A time that a rule needs: of which step, and START, SETTLED or DONE."""

Rule = Generator[Need, Time, Time]
"""Works out one time: yields what it needs, is sent each, returns the time."""


class Rules(Protocol):
    """Where the rules are."""

    def rule(self, step: Step, edge: int) -> Rule | Time:
        """A time of a step, where nothing else needs to be known for it first; else the rule for it."""
        ...

    def circle(self, needs: list[Need]) -> None:
        """Report that each of these needs the next, and the last the first."""
        ...


@dataclass(slots=True)
class Solver:
    """Runs rules on a stack of its own, so that references may reach as far as they like."""

    rules: Rules
    _stack: list[tuple[Need, Rule]] = field(default_factory=list)
    _active: set[tuple[int, int]] = field(default_factory=set)

    def solve(self, step: Step, edge: int) -> Time:
        """The time of a step. Where it is in a circle, the circle is reported and the time is the start of its tree."""
        sent = self._given((step, edge))
        while self._stack:
            need, rule = self._stack[-1]
            try:
                wanted = next(rule) if sent is None else rule.send(sent)
            except StopIteration as finished:
                step, edge = need
                sent = step.times[edge] = finished.value
                self._active.discard((id(step), edge))
                self._stack.pop()
                continue
            sent = self._given(wanted)
        assert sent is not None
        return sent

    def _given(self, need: Need) -> Time | None:
        """The time where it is known or follows at once; else None, and its rule is next."""
        step, edge = need
        known = step.times[edge]
        if known is not None:
            return known
        if (id(step), edge) in self._active:
            self._circle(need)
            return (step.root.start, False)
        rule = self.rules.rule(step, edge)
        if isinstance(rule, tuple):
            step.times[edge] = rule
            return rule
        self._active.add((id(step), edge))
        self._stack.append((need, rule))
        return None

    def _circle(self, need: Need) -> None:
        needs = [entry[0] for entry in self._stack]
        first = next(i for i, (step, edge) in enumerate(needs) if step is need[0] and edge == need[1])
        self.rules.circle(needs[first:])
