"""The mends that an editor offers for what is wrong, one by one and all at once."""

from __future__ import annotations

from analysing import ROOT, analysis
from lsprotocol import types

from facescript.diagnostics.model import Diagnostic, Edit, Fix, Severity
from facescript.lsp.desk import Analysis
from facescript.lsp.features.diagnostics import diagnostics
from facescript.lsp.features.fixes import actions
from facescript.lsp.places import offset, position
from facescript.text import Source, Span

QUICK, ALL = types.CodeActionKind.QuickFix, types.CodeActionKind.SourceFixAll


def asked(found: Analysis, *, line: int | None = None, only: str | None = None) -> list[types.CodeAction]:
    """The actions for a line, or for the whole document."""
    end = position(found.source, len(found.source.text))
    where = types.Range(types.Position(line or 0, 0), end if line is None else types.Position(line, 1000))
    return actions(found, where, types.CodeActionContext(diagnostics(found), [only] if only else None))


def mended(found: Analysis, action: types.CodeAction) -> str:
    """The document after the action."""
    assert action.edit is not None and action.edit.changes is not None
    text = found.source.text
    edits = action.edit.changes[found.uri]
    for edit in sorted(edits, key=lambda edit: offset(found.source, edit.range.start), reverse=True):
        text = (
            text[: offset(found.source, edit.range.start)]
            + edit.new_text
            + text[offset(found.source, edit.range.end) :]
        )
    return text


def test_a_slip_is_mended_with_the_nearest_name() -> None:
    found = analysis("# \U0001f600\nshow smlie 60%\nshow smile\n")
    (action,) = asked(found, line=1, only=QUICK)
    assert mended(found, action) == "# \U0001f600\nshow smile 60%\nshow smile\n"
    assert action.title == "write `smile`" and action.kind == QUICK and action.is_preferred
    assert [each.code for each in action.diagnostics or ()] == ["FS201"]
    assert asked(found, line=2, only=QUICK) == []


def test_all_mends_are_taken_at_once() -> None:
    found = analysis("show smlie 60%\nwait 2 s\nshow smile 40% posed\nfrobnicate\n")
    (action,) = asked(found, only=ALL)
    assert mended(found, action) == "show smile 60%\nwait 2s\nshow smile 40%, posed\nfrobnicate\n"


def test_mends_that_overlap_are_not_both_taken() -> None:
    found = analysis("nod\nshake\n")
    told(found, "wink left", found.source, 0, 3)
    told(found, "blink", found.source, 2, 5)
    told(found, "tilt left", found.source, 4, 9)
    (action,) = asked(found, only="source")
    assert mended(found, action) == "wink left\ntilt left\n"


def told(found: Analysis, text: str, source: Source, start: int, end: int) -> None:
    """Puts one more fault into an analysis, at the start of its document, with a mend."""
    fix = Fix(text, (Edit(Span(source, start, end), text),))
    place = Span(found.source, 0, 1)
    found.compiled.diagnostics.add(Diagnostic("FS201", Severity.ERROR, text, place, (fix,)))


def test_what_an_editor_does_not_ask_for_is_left_out() -> None:
    found = analysis("show smlie\n")
    assert [action.kind for action in asked(found)] == [QUICK, ALL]
    assert asked(found, only="refactor") == []


def test_edits_in_another_file_go_there_and_none_into_the_library() -> None:
    found = analysis("nod\n", studio="let beat = 2 s\n")
    told(found, "let beat = 2s", Source("studio.face", "let beat = 2 s\n"), 0, 14)
    told(found, "never", Source("stdlib/facs.face", "nod\n"), 0, 3)
    (action,) = asked(found, line=0, only=QUICK)
    assert action.edit is not None and action.edit.changes is not None
    assert list(action.edit.changes) == [(ROOT / "studio.face").as_uri()]


def test_a_document_without_faults_has_no_actions() -> None:
    assert asked(analysis("show smile\n")) == [] == asked(analysis(""), line=40)
