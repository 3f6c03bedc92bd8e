"""What is wrong in a stretch of a document to the mends an editor offers, and all mends of a document at once."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable, Sequence

from lsprotocol import types

from facescript.diagnostics.model import Diagnostic, Edit, Fix
from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, range_of
from facescript.lsp.server import FaceServer

QUICK, ALL = types.CodeActionKind.QuickFix, types.CodeActionKind.SourceFixAll

Spans = dict[str, list[tuple[int, int]]]
"""Stretches that are edited by the address of their file, in order."""


def actions(analysis: Analysis, where: types.Range, context: types.CodeActionContext) -> list[types.CodeAction]:
    """The mends of what is wrong in a stretch, and the one that mends all, as far as they are asked for."""
    found: list[types.CodeAction] = []
    if _asked(context, QUICK):
        for item in _touching(analysis, where):
            found += _quick(analysis, item, context.diagnostics)
    if _asked(context, ALL) and (edit := all_fixes(analysis)):
        found.append(types.CodeAction("mend all that can be mended", ALL, edit=edit))
    return found


def all_fixes(analysis: Analysis) -> types.WorkspaceEdit | None:
    """The first fix of everything that is wrong in the document, but those that overlap an earlier one."""
    taken: Spans = {}
    chosen: list[Edit] = []
    for item in _own(analysis):
        for fix in _mends(analysis, item)[:1]:
            if not any(_overlaps(analysis, edit, taken) for edit in fix.edits):
                chosen += fix.edits
                for edit in fix.edits:
                    insort(taken.setdefault(_uri(analysis, edit), []), (edit.span.start, edit.span.end))
    return _workspace_edit(analysis, chosen) if chosen else None


def _asked(context: types.CodeActionContext, kind: str) -> bool:
    return context.only is None or any(kind == only or kind.startswith(f"{only}.") for only in context.only)


def _own(analysis: Analysis) -> Iterable[Diagnostic]:
    return (item for item in analysis.compiled.diagnostics if item.span and item.span.source is analysis.source)


def _touching(analysis: Analysis, where: types.Range) -> Iterable[Diagnostic]:
    start, end = offset(analysis.source, where.start), offset(analysis.source, where.end)
    return (item for item in _own(analysis) if item.span and item.span.start <= end and start <= item.span.end)


def _mends(analysis: Analysis, item: Diagnostic) -> list[Fix]:
    """The fixes of a diagnostic that an editor can take: they have edits, and all in files of the project."""
    return [fix for fix in item.fixes if fix.edits and all(analysis.uri_of(edit.span.source) for edit in fix.edits)]


def _quick(analysis: Analysis, item: Diagnostic, known: Sequence[types.Diagnostic]) -> Iterable[types.CodeAction]:
    fixes = _mends(analysis, item)
    place = range_of(item.span) if item.span else None
    linked = [other for other in known if other.code == item.code and other.range == place]
    for fix in fixes:
        yield types.CodeAction(
            fix.title,
            QUICK,
            diagnostics=linked or None,
            is_preferred=len(fixes) == 1,
            edit=_workspace_edit(analysis, fix.edits),
        )


def _uri(analysis: Analysis, edit: Edit) -> str:
    return analysis.uri_of(edit.span.source) or ""


def _overlaps(analysis: Analysis, edit: Edit, taken: Spans) -> bool:
    spans = taken.get(_uri(analysis, edit), [])
    place = bisect_left(spans, (edit.span.start, edit.span.end))
    return any(start <= edit.span.end and edit.span.start <= end for start, end in spans[max(place - 1, 0) : place + 1])


def _workspace_edit(analysis: Analysis, edits: Iterable[Edit]) -> types.WorkspaceEdit:
    changes: dict[str, list[types.TextEdit]] = {}
    for edit in edits:
        changes.setdefault(_uri(analysis, edit), []).append(types.TextEdit(range_of(edit.span), edit.text))
    return types.WorkspaceEdit(changes)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION)
    def asked(_: FaceServer, params: types.CodeActionParams) -> list[types.CodeAction]:
        if params.text_document.uri not in server.workspace.text_documents:
            return []
        return actions(server.desk.analysis(params.text_document.uri), params.range, params.context)
