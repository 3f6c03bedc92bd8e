"""A document to its outline: scenes, reactions, definitions, faces and named statements, nested as the script is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer
from facescript.lsp.walk import Node, inside, name_of
from facescript.syntax import tree
from facescript.text import Span

Kind = types.SymbolKind

DECLARED = {"face": Kind.Class, "life": Kind.Struct, "kind": Kind.Interface, "target": Kind.Variable}


def symbols(analysis: Analysis) -> list[types.DocumentSymbol]:
    """What a script names, in the order written. A block is told where something in it is."""
    return list(_symbols(analysis.compiled.script.items))


def _symbols(nodes: Sequence[Node]) -> Iterator[types.DocumentSymbol]:
    for node in nodes:
        within = list(_symbols(inside(node)))
        head = _head(node)
        if head is not None:
            name, kind, detail, chosen = head
            yield types.DocumentSymbol(name, kind, range_of(node.span), range_of(chosen), detail, children=within)
        elif within and isinstance(node, tree.Cast):
            yield from within
        elif within:
            header, where = _header(node), range_of(node.span)
            yield types.DocumentSymbol(_line(header), Kind.Object, where, range_of(header), children=within)


def _head(node: Node) -> tuple[str, types.SymbolKind, str, Span] | None:
    """Name, kind, detail and the place of the name of what has one."""
    match node:
        case tree.Scene():
            return node.name.text, Kind.Module, node.title.value if node.title else "scene", node.name.span
        case tree.When():
            return f"when {_line(node.event.span)}", Kind.Event, "", node.event.span
        case tree.ExpressionDefinition():
            return node.name.text, Kind.Function, _line(node.value.span), node.name.span
        case tree.ActionDefinition():
            return node.name.text, Kind.Method, _parameters(node), node.name.span
        case tree.LetDefinition():
            return node.name.text, Kind.Constant, _line(node.value.span), node.name.span
        case tree.VisemeDefinition():
            return node.sound.span.text, Kind.String, _line(node.value.span), node.sound.span
        case tree.Declaration():
            detail = _line(node.phrases[0].span.to(node.phrases[-1].span))
            return node.name.text, DECLARED[node.kind], detail, node.name.span
        case tree.Act():
            named = name_of(node)
            return (named.text, Kind.Key, _line(_phrases(node)), named.span) if named else None
    return None


def _parameters(node: tree.ActionDefinition) -> str:
    return ", ".join(parameter.span.text for parameter in node.parameters)


def _phrases(act: tree.Act) -> Span:
    return act.phrases[0].span.to(act.phrases[-1].span)


def _line(span: Span) -> str:
    """The text of a stretch in one line."""
    return " ".join(span.text.split())


def _header(node: Node) -> Span:
    """A block as far as its colon."""
    start = node.span.start
    match node:
        case tree.Repeat():
            end = node.how.span.end
        case tree.Moment():
            end = node.time.span.end
        case tree.On():
            end = node.word.span.end
        case tree.Group():
            last = node.kind.split()[-1]
            end = node.span.source.text.index(last, start) + len(last)
        case _:
            end = node.span.end
    return Span(node.span.source, start, end)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def asked(_: FaceServer, params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
        return symbols(server.desk.analysis(params.text_document.uri))
