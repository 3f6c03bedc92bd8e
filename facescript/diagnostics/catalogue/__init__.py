"""The catalogue of diagnostics: each code with its sentence, a bad and a good example; makes a diagnostic of a code."""

from __future__ import annotations

from facescript.diagnostics.catalogue.addresses import ADDRESSES
from facescript.diagnostics.catalogue.command import COMMAND
from facescript.diagnostics.catalogue.files import FILES
from facescript.diagnostics.catalogue.gaze import GAZE
from facescript.diagnostics.catalogue.kinds import KINDS
from facescript.diagnostics.catalogue.later import LATER
from facescript.diagnostics.catalogue.live import LIVE
from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.catalogue.names import NAMES
from facescript.diagnostics.catalogue.pages import PAGES
from facescript.diagnostics.catalogue.programs import PROGRAMS
from facescript.diagnostics.catalogue.recordings import RECORDINGS
from facescript.diagnostics.catalogue.speech import SPEECH
from facescript.diagnostics.catalogue.syntax import SYNTAX
from facescript.diagnostics.catalogue.talk import TALK
from facescript.diagnostics.catalogue.time import TIME
from facescript.diagnostics.catalogue.values import VALUES
from facescript.diagnostics.model import Diagnostic, Fix, Related
from facescript.text import Span

CATALOGUE: dict[str, Entry] = {
    entry.code: entry
    for family in (
        SYNTAX,
        NAMES,
        KINDS,
        VALUES,
        TIME,
        SPEECH,
        TALK,
        RECORDINGS,
        GAZE,
        FILES,
        LATER,
        COMMAND,
        PAGES,
        PROGRAMS,
        ADDRESSES,
        LIVE,
    )
    for entry in family
}


def diagnose(
    code: str,
    span: Span | None,
    *,
    fixes: tuple[Fix, ...] = (),
    related: tuple[Related, ...] = (),
    **values: object,
) -> Diagnostic:
    """The diagnostic of `code` at `span`, its sentence filled with `values`."""
    entry = CATALOGUE[code]
    return Diagnostic(code, entry.severity, entry.sentence.format(**values), span, fixes, related)
