"""A script's faults to a script without those that have a fix: fixes are made until none is left."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from facescript.diagnostics.edits import edited, fitting
from facescript.diagnostics.model import Diagnostic, Fix
from facescript.text import Source

ROUNDS = 20
"""How often a script is looked at again: a fix may bring out a fault that it hid."""

Check = Callable[[Source], list[Diagnostic]]


@dataclass(slots=True)
class Fixed:
    """A script after its fixes: `done` tells of each, `left` is what is still said of it."""

    source: Source
    left: list[Diagnostic]
    done: list[str] = field(default_factory=list)


def fixed(source: Source, check: Check) -> Fixed:
    """The script with all fixes made that have edits, the first where a fault has several. Other files are let be."""
    found = Fixed(source, check(source))
    seen = {source.text}
    for _ in range(ROUNDS):
        told = list(_mends(found))
        chosen = fitting(fix for _, fix in told)
        text = edited(found.source.text, (edit for fix in chosen for edit in fix.edits))
        if text in seen:
            break
        seen.add(text)
        found.done += [_line(item, fix) for item, fix in told if any(fix is each for each in chosen)]
        found.source = Source(source.name, text)
        found.left = check(found.source)
    return found


def _mends(found: Fixed) -> Iterator[tuple[Diagnostic, Fix]]:
    """The first fix of each fault that edits the script and nothing else."""
    for item in found.left:
        fix = next((fix for fix in item.fixes if fix.edits), None)
        if fix is not None and all(edit.span.source is found.source for edit in fix.edits):
            yield item, fix


def _line(item: Diagnostic, fix: Fix) -> str:
    """What was done, and where it was."""
    span = fix.edits[0].span
    line, column = span.source.position(span.start)
    return f"{span.source.name}:{line}:{column}: {item.code} {fix.title}"
