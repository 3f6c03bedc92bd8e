"""All that an editor marks in a document: through a real client, and for texts that make no sense."""

from __future__ import annotations

import random
from itertools import pairwise
from pathlib import Path

from analysing import analysis
from lsprotocol import types
from pytest_lsp import LanguageClient

from facescript.lsp.features.colours import colours
from facescript.lsp.features.folding import folding
from facescript.lsp.features.inlay_hints import inlay_hints
from facescript.lsp.features.lenses import lenses
from facescript.lsp.features.links import links
from facescript.lsp.features.selection import selection
from facescript.lsp.features.semantic_tokens import semantic_tokens
from facescript.lsp.features.symbols import symbols
from facescript.lsp.tokens import tokens, unpack

TEXT = "scene a:\n    background #ff0000\n    nod as first\n"
EXAMPLES = Path(__file__).parents[2] / "examples"
SPOILERS = ('"', "[", "\U0001f600", "\n", ":", "    ", "#", "(", "as ", "*", "\u2028", "\0", "in turn:")


async def test_a_client_is_told_of_everything(client: LanguageClient, tmp_path: Path) -> None:
    uri = (tmp_path / "a.face").as_uri()
    client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "face", 1, TEXT)))
    document = types.TextDocumentIdentifier(uri)
    whole = types.Range(types.Position(0, 0), types.Position(3, 0))
    (scene,) = await client.text_document_document_symbol_async(types.DocumentSymbolParams(document)) or ()
    assert isinstance(scene, types.DocumentSymbol) and scene.children
    assert await client.text_document_folding_range_async(types.FoldingRangeParams(document))
    places = [types.Position(2, 5), types.Position(99, 99)]
    chains = await client.text_document_selection_range_async(types.SelectionRangeParams(document, places))
    assert chains and len(chains) == 2 and chains[0].parent
    full = await client.text_document_semantic_tokens_full_async(types.SemanticTokensParams(document))
    part = await client.text_document_semantic_tokens_range_async(types.SemanticTokensRangeParams(document, whole))
    assert full and part and full.data == part.data
    again = types.SemanticTokensDeltaParams(document, full.result_id or "")
    delta = await client.text_document_semantic_tokens_full_delta_async(again)
    assert isinstance(delta, types.SemanticTokensDelta) and not delta.edits
    hints = await client.text_document_inlay_hint_async(types.InlayHintParams(document, whole))
    assert hints and [hint.label for hint in hints] == ["0 → 0.7 s", "0 s", "0 → 0.7 s"]
    (colour,) = await client.text_document_document_color_async(types.DocumentColorParams(document))
    picked = await client.text_document_color_presentation_async(
        types.ColorPresentationParams(document, types.Color(0.0, 0.0, 1.0, 1.0), colour.range)
    )
    assert picked[0].label == "#0000ff"
    assert len(await client.text_document_code_lens_async(types.CodeLensParams(document)) or ()) == 2
    unknown = types.TextDocumentIdentifier((tmp_path / "nowhere.face").as_uri())
    assert not await client.text_document_document_link_async(types.DocumentLinkParams(unknown))


def test_spoilt_scripts_are_marked_as_far_as_they_can_be_read() -> None:
    dice = random.Random(6)
    text = (EXAMPLES / "evening.face").read_text("utf-8")
    for _ in range(25):
        at = dice.randrange(len(text))
        made = analysis(text[:at] + dice.choice(SPOILERS) + text[at + dice.randrange(30) :])
        found = [unpack(one) for one in tokens(made)]
        assert all(first[1] <= second[0] for first, second in pairwise(found))
        assert all(start < end and "\n" not in made.source.text[start:end] for start, end, *_ in found)
        for feature in (semantic_tokens, symbols, folding, colours, lenses, links):
            feature(made)
        place = types.Position(dice.randrange(60), dice.randrange(120))
        selection(made, [place, types.Position(0, 2**31 - 1)])
        inlay_hints(made, types.Range(types.Position(0, 0), place))
