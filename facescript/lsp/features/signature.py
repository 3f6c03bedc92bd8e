"""A place in a call or a statement to what it takes: parameters of expressions and actions, modifiers of verbs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from lsprotocol import types

from facescript.lsp.completion.before import before, lexed
from facescript.lsp.completion.here import Here
from facescript.lsp.completion.statements import Part, open_call, parts_of, row_of
from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset
from facescript.lsp.server import FaceServer
from facescript.lsp.vocabulary import parameters_of
from facescript.resolve.blocks import ROWS
from facescript.resolve.meanings import comment_of
from facescript.resolve.names import Definition
from facescript.resolve.words import VERBS, Modifier
from facescript.syntax.spacing import Token
from facescript.syntax.tree import Parameter
from facescript.text import Source


@dataclass(frozen=True, slots=True)
class _Piece:
    """A part of a signature: what is shown, and what is said of it."""

    text: str
    says: str = ""


def signature(analysis: Analysis, source: Source, place: types.Position) -> types.SignatureHelp | None:
    """What the call or the statement at a place of a text takes, and which part of it is written there."""
    found = before(source, offset(source, place))
    if found is None or not found.tokens or (found.text is not None and not found.cue):
        return None
    here = Here(found, analysis)
    called = open_call(found.tokens)
    if called is not None:
        return _call(here, found.tokens[called:])
    name = found.words[0]
    definition = here.project.names.find(name)
    parts = parts_of((*found.tokens, *lexed(source, found.start, found.word)))
    if name in ROWS:
        return _verb(name, parts)
    return _action(definition, parts) if definition is not None and definition.kind == "action" else None


def _call(here: Here, tokens: tuple[Token, ...]) -> types.SignatureHelp | None:
    """`crooked(lift = 40%, much)`; the argument at hand is the one that is named, else the one in its place."""
    definition = here.project.names.find(tokens[0][1])
    if definition is None or definition.kind != "expression" or not parameters_of(definition):
        return None
    part = parts_of(tokens[2:])[-1]
    parameters = parameters_of(definition)
    place = sum(token[0] == "COMMA" for token in tokens)
    active = _named(parameters, part.words[0]) if "=" in part.words else place
    pieces = [_Piece(" ".join(each.span.text.split())) for each in parameters]
    return _help(f"{definition.name}(", pieces, ", ", ")", active, comment_of(definition.node.span))


def _action(definition: Definition, parts: list[Part]) -> types.SignatureHelp | None:
    """`greet who, warmth = 60%`: the first behind the name, the others by theirs."""
    parameters = parameters_of(definition)
    pieces = [_Piece(" ".join(each.span.text.split())) for each in parameters]
    words = parts[-1].words
    active = 0 if len(parts) == 1 else _named(parameters, words[0]) if words else None
    return _help(f"{definition.name} ", pieces, ", ", "", active, comment_of(definition.node.span))


def _verb(name: str, parts: list[Part]) -> types.SignatureHelp:
    """`show SUM over TIME for TIME, posed`: the verb's form, direct modifiers, then those behind commas."""
    rows = ROWS[name]
    ordered = sorted(rows.values(), key=lambda row: (row.name == "as", not row.direct))
    pieces = [_Piece(VERBS[name].form, VERBS[name].help), *(_piece(row) for row in ordered)]
    row = row_of(rows, parts[-1].words) if len(parts) > 1 else None
    active = 0 if len(parts) == 1 else ordered.index(row) + 1 if row is not None else None
    return _help("", pieces, "", "", active, VERBS[name].help)


def _piece(row: Modifier) -> _Piece:
    return _Piece(f" {row.form}" if row.direct else f", {row.form}", row.help)


def _named(parameters: Iterable[Parameter], name: str) -> int | None:
    return next((place for place, each in enumerate(parameters) if each.name.text == name), None)


def _help(
    head: str, pieces: list[_Piece], between: str, tail: str, active: int | None, says: str
) -> types.SignatureHelp:
    """Parts are told by where they stand in the whole, in UTF-16 units. Without `active` none is at hand."""
    text, parameters = head, []
    for number, piece in enumerate(pieces):
        text += between if number else ""
        start = _units(text)
        text += piece.text
        parameters.append(types.ParameterInformation((start, _units(text)), piece.says or None))
    shown = types.SignatureInformation(text + tail, says or None, parameters)
    return types.SignatureHelp([shown], 0, active if active is not None else len(pieces))


def _units(text: str) -> int:
    return len(text.encode("utf-16-le")) // 2


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_SIGNATURE_HELP)
    def asked(_: FaceServer, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
        uri = params.text_document.uri
        if uri not in server.workspace.text_documents:
            return None
        return signature(server.desk.latest(uri), server.desk.source(uri), params.position)
