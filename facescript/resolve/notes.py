"""What working out a part of a script asks, tells and uses: by it is known whether the part would come to the same."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from facescript.diagnostics.model import Diagnostic
from facescript.text import Span

if TYPE_CHECKING:
    from facescript.resolve.project import Project

Ask = tuple[str, str]
"""A table and the name that is looked up in it."""

ALL = ""
"""The name that stands for all of a table."""

Question = Callable[["Project", Span], bool]
"""What may be asked of the state of the work at a place."""


@dataclass(frozen=True, slots=True)
class Told:
    """What is to be told, unless the line of `span` could not be read or, if it is `shy`, holds a word that is refused;
    and a `word` that is refused from now on."""

    span: Span | None
    diagnostic: Diagnostic | None
    shy: bool = False
    word: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Lean:
    """Something that is worked out once for all who lean on it: its key, the node it is worked out from, its value."""

    key: tuple[object, ...]
    node: object
    value: object


@dataclass(slots=True)
class Notes:
    """`asked` are look-ups, `told` what was told and leant on in its order, `entered` definitions that were gone into,
    `seen` answers of questions; `guessed` is whether it was sought what a name may have meant, `labelled` whether
    labels were given inside, `passing` whether nothing of it may be kept, `filed` whether files were asked for.
    `inside` are the words that names stood for in what is leant on and was worked out inside, `parts` the keys of
    parts inside."""

    asked: set[Ask] = field(default_factory=set)
    told: list[Told | Lean] = field(default_factory=list)
    entered: set[str] = field(default_factory=set)
    seen: list[tuple[Question, Span, bool]] = field(default_factory=list)
    guessed: bool = False
    labelled: bool = False
    passing: bool = False
    filed: bool = False
    inside: int = 0
    parts: list[Any] = field(default_factory=list)

    def absorb(self, other: Notes) -> None:
        """Take what was noted inside as one's own."""
        self.asked |= other.asked
        self.told += other.told
        self.entered |= other.entered
        self.seen += other.seen
        self.guessed |= other.guessed
        self.labelled |= other.labelled
        self.passing |= other.passing
        self.filed |= other.filed
        self.inside += other.inside
