"""A document to its colours, which an editor shows and picks; and a picked colour to how it is written."""

from __future__ import annotations

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.meanings import Meaning
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer
from facescript.lsp.tokens import tokens, unpack
from facescript.text import Span

OPAQUE = 255


def colours(analysis: Analysis) -> list[types.ColorInformation]:
    """Every `#rrggbb` and `#rrggbbaa`, in texts too."""
    found = (unpack(one) for one in tokens(analysis))
    spans = [Span(analysis.source, start, end) for start, end, meaning, _ in found if meaning is Meaning.COLOUR]
    return [types.ColorInformation(range_of(span), _colour(span.text)) for span in spans]


def _colour(text: str) -> types.Color:
    red, green, blue, alpha = (part / OPAQUE for part in bytes.fromhex(text[1:].ljust(8, "f")))
    return types.Color(red, green, blue, alpha)


def presentation(colour: types.Color, where: types.Range) -> types.ColorPresentation:
    """As an author writes it: with its opacity only where it has one."""
    parts = [_byte(part) for part in (colour.red, colour.green, colour.blue, colour.alpha)]
    text = "#" + bytes(parts if parts[-1] < OPAQUE else parts[:-1]).hex()
    return types.ColorPresentation(text, types.TextEdit(where, text))


def _byte(part: float) -> int:
    return round(min(max(part, 0.0), 1.0) * OPAQUE)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_COLOR)
    def asked(_: FaceServer, params: types.DocumentColorParams) -> list[types.ColorInformation]:
        return colours(server.desk.analysis(params.text_document.uri))

    @server.feature(types.TEXT_DOCUMENT_COLOR_PRESENTATION)
    def picked(_: FaceServer, params: types.ColorPresentationParams) -> list[types.ColorPresentation]:
        return [presentation(params.color, params.range)]
