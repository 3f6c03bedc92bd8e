"""Diagnostics to the terminal: text on standard error, or JSON on standard output."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic, Severity
from facescript.diagnostics.render import as_json, render

FAULTS = 1
CANNOT_RUN = 2


class OptionFault(Exception):
    """An option that cannot be taken: a code and the values of its sentence."""

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code, self.values = code, values


def show(diagnostics: Iterable[Diagnostic], hints: bool = True) -> int:
    """Print what authors are told, places in order, an empty line between; returns 1 where there is an error."""
    items = [item for item in in_order(diagnostics) if hints or item.severity is not Severity.HINT]
    if items:
        print("\n\n".join(render(item, colour=_colourful()) for item in items), file=sys.stderr)
    return FAULTS if any(item.severity is Severity.ERROR for item in items) else 0


def show_json(diagnostics: Iterable[Diagnostic]) -> int:
    """The same as one JSON list on standard output."""
    items = in_order(diagnostics)
    print(json.dumps([as_json(item) for item in items], ensure_ascii=False, indent=2))
    return FAULTS if any(item.severity is Severity.ERROR for item in items) else 0


def refuse(code: str, **values: object) -> int:
    """Print one fault that no place in a script is to blame for; returns the exit code 1."""
    print(render(diagnose(code, None, **values), colour=_colourful()), file=sys.stderr)  # type: ignore[arg-type]
    return FAULTS


def refuse_option(fault: OptionFault) -> int:
    """Print what is wrong with an option; returns the exit code 2: it cannot run."""
    refuse(fault.code, **fault.values)
    return CANNOT_RUN


def in_order(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """By file and place; what has no place comes first."""
    return sorted(diagnostics, key=lambda item: (item.span.source.name, item.span.start) if item.span else ("", -1))


def _colourful() -> bool:
    return sys.stderr.isatty() and "NO_COLOR" not in os.environ
