"""An author at work in an editor: a line is offered, explained, mended and laid out, as the real client sees it."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from pytest_lsp import LanguageClient

SCRIPT = "# what is looked at\ntarget cup at 1cm 2cm 1m\nlook \nshow smlie  40%\n"


async def test_a_line_is_written_mended_and_laid_out(client: LanguageClient, tmp_path: Path) -> None:
    uri = (tmp_path / "a.face").as_uri()
    document = types.TextDocumentIdentifier(uri)
    client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "face", 1, SCRIPT)))
    change(client, uri, 2, types.Range(types.Position(2, 5), types.Position(2, 5)), "at ")
    end = types.Position(2, 8)
    found = await client.text_document_completion_async(types.CompletionParams(document, end))
    assert isinstance(found, types.CompletionList)
    cup = await client.completion_item_resolve_async(next(each for each in found.items if each.label == "cup"))
    assert isinstance(cup.documentation, types.MarkupContent) and "what is looked at" in cup.documentation.value
    shown = await client.text_document_signature_help_async(types.SignatureHelpParams(document, end))
    assert shown is not None and shown.signatures[0].label.startswith("look at TARGET")

    change(client, uri, 3, types.Range(end, end), "cup")
    said = await client.text_document_hover_async(types.HoverParams(document, end))
    assert said is not None and "target cup at 1cm 2cm 1m" in str(said.contents)

    where = types.Range(types.Position(3, 6), types.Position(3, 6))
    actions = await client.text_document_code_action_async(
        types.CodeActionParams(document, where, types.CodeActionContext([], [types.CodeActionKind.QuickFix]))
    )
    (action,) = actions or ()
    assert isinstance(action, types.CodeAction) and action.edit is not None and action.edit.changes is not None
    (mend,) = action.edit.changes[uri]
    change(client, uri, 4, mend.range, mend.new_text)
    options = types.FormattingOptions(4, True)
    (edit,) = await client.text_document_formatting_async(types.DocumentFormattingParams(document, options)) or ()
    assert edit.new_text == "show smile 40%\n"
    whole = types.Range(types.Position(0, 0), types.Position(2, 0))
    part = types.DocumentRangeFormattingParams(document, whole, options)
    assert not await client.text_document_range_formatting_async(part)

    await nobody_opened(client)


async def nobody_opened(client: LanguageClient) -> None:
    """What is asked of a document that no editor has opened is answered, with nothing."""
    document, place = types.TextDocumentIdentifier("file:///nowhere/at/all.face"), types.Position(7, 7)
    where = types.Range(place, place)
    options = types.FormattingOptions(4, True)
    found = await client.text_document_completion_async(types.CompletionParams(document, place))
    assert isinstance(found, types.CompletionList) and not found.items
    assert await client.text_document_hover_async(types.HoverParams(document, place)) is None
    assert await client.text_document_signature_help_async(types.SignatureHelpParams(document, place)) is None
    params = types.CodeActionParams(document, where, types.CodeActionContext([]))
    assert not await client.text_document_code_action_async(params)
    assert not await client.text_document_formatting_async(types.DocumentFormattingParams(document, options))


def change(client: LanguageClient, uri: str, version: int, where: types.Range, text: str) -> None:
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(
            types.VersionedTextDocumentIdentifier(version, uri), [types.TextDocumentContentChangePartial(where, text)]
        )
    )
