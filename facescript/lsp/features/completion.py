"""A place in a document to what an editor offers to write there."""

from __future__ import annotations

from lsprotocol import types

from facescript.lsp.completion.before import before
from facescript.lsp.completion.contexts import offered
from facescript.lsp.completion.here import MOST_LABELS, Here
from facescript.lsp.completion.offers import Offer, described
from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, position
from facescript.lsp.server import FaceServer
from facescript.lsp.vocabulary import project_of
from facescript.text import Source

KINDS = {
    "word": types.CompletionItemKind.Keyword,
    "verb": types.CompletionItemKind.Function,
    "action": types.CompletionItemKind.Method,
    "face": types.CompletionItemKind.Class,
    "kind": types.CompletionItemKind.Class,
    "target": types.CompletionItemKind.Reference,
    "expression": types.CompletionItemKind.Constant,
    "muscle": types.CompletionItemKind.Field,
    "channel": types.CompletionItemKind.Field,
    "modifier": types.CompletionItemKind.Property,
    "setting": types.CompletionItemKind.Property,
    "parameter": types.CompletionItemKind.TypeParameter,
    "let": types.CompletionItemKind.Variable,
    "life": types.CompletionItemKind.EnumMember,
    "look": types.CompletionItemKind.EnumMember,
    "colour": types.CompletionItemKind.Color,
    "voice": types.CompletionItemKind.EnumMember,
    "label": types.CompletionItemKind.Event,
    "unit": types.CompletionItemKind.Unit,
    "file": types.CompletionItemKind.File,
}


def completions(analysis: Analysis, source: Source, place: types.Position) -> list[types.CompletionItem]:
    """What may be written at a place of a text, which may be newer than its analysis."""
    found = before(source, offset(source, place))
    if found is None:
        return []
    where = types.Range(position(source, found.start), position(source, found.place))
    return [_item(offer, where, order) for order, offer in enumerate(offered(Here(found, analysis)))]


def _item(offer: Offer, where: types.Range, order: int) -> types.CompletionItem:
    return types.CompletionItem(
        offer.name,
        kind=KINDS[offer.kind],
        detail=offer.says or None,
        sort_text=f"{order:04}",
        text_edit=types.TextEdit(where, offer.text or offer.name),
    )


def _is_cut(items: list[types.CompletionItem]) -> bool:
    """Whether there may be more names of statements, so that an editor asks again when more of one is written."""
    return sum(item.kind == KINDS["label"] for item in items) >= 2 * MOST_LABELS


def documentation(analysis: Analysis, source: Source, place: types.Position, name: str) -> str | None:
    """What is said of one of the offers at a place, in Markdown."""
    found = before(source, offset(source, place))
    offers = offered(Here(found, analysis)) if found else []
    return next((described(project_of(analysis), offer) for offer in offers if offer.name == name), None)


def register(server: FaceServer) -> None:
    asked_at: list[tuple[str, types.Position]] = []

    @server.feature(types.TEXT_DOCUMENT_COMPLETION)
    def asked(_: FaceServer, params: types.CompletionParams) -> types.CompletionList:
        uri = params.text_document.uri
        if uri not in server.workspace.text_documents:
            return types.CompletionList(is_incomplete=False, items=[])
        asked_at[:] = [(uri, params.position)]
        items = completions(server.desk.latest(uri), server.desk.source(uri), params.position)
        return types.CompletionList(is_incomplete=_is_cut(items), items=items)

    @server.feature(types.COMPLETION_ITEM_RESOLVE)
    def resolved(_: FaceServer, item: types.CompletionItem) -> types.CompletionItem:
        """Adds what is told of an offer of the last list: to make all of it for every list would take too long."""
        for uri, place in asked_at:
            if uri in server.workspace.text_documents:
                text = documentation(server.desk.latest(uri), server.desk.source(uri), place, item.label)
                item.documentation = types.MarkupContent(types.MarkupKind.Markdown, text) if text else None
        return item
