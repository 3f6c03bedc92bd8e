"""What an author is told: a code, a sentence, a place, and a fix where one is known."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import StrEnum

from facescript.text import Span


class Severity(StrEnum):
    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"


@dataclass(frozen=True, slots=True)
class Edit:
    """Replace the text of `span` by `text`."""

    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class Fix:
    """A mend the author can take as it is: what it does, and the edits that do it (none: advice only)."""

    title: str
    edits: tuple[Edit, ...] = ()


@dataclass(frozen=True, slots=True)
class Related:
    """A second place that matters to a diagnostic: the earlier definition, the other end of a conflict."""

    span: Span
    message: str


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One fault or remark. `span` is None only where no script is at fault (an output path, a missing file)."""

    code: str
    severity: Severity
    message: str
    span: Span | None
    fixes: tuple[Fix, ...] = ()
    related: tuple[Related, ...] = ()


@dataclass(slots=True)
class Diagnostics:
    """A growing list of diagnostics; every pass appends to the one it is given."""

    items: list[Diagnostic] = field(default_factory=list)
    _known: set[tuple[str, Span | None, str]] = field(default_factory=set, repr=False)

    def add(self, diagnostic: Diagnostic) -> None:
        """Append it, unless the same has been said of the same place."""
        key = (diagnostic.code, diagnostic.span, diagnostic.message)
        if key not in self._known:
            self._known.add(key)
            self.items.append(diagnostic)

    def __iter__(self) -> Iterator[Diagnostic]:
        return iter(self.items)

    @property
    def failed(self) -> bool:
        """Whether anything in the list is an error."""
        return any(item.severity is Severity.ERROR for item in self.items)
