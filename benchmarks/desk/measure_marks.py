"""What an editor marks in a script of 2,000 lines: the processor's time of each answer, once the script is compiled."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import gettempdir

from _scripts import lines_of
from lsprotocol import types
from pygls.workspace import Workspace
from row import Row

from facescript.lsp.desk import Analysis, Desk
from facescript.lsp.features.colours import colours
from facescript.lsp.features.folding import folding
from facescript.lsp.features.inlay_hints import inlay_hints
from facescript.lsp.features.lenses import lenses
from facescript.lsp.features.links import links
from facescript.lsp.features.selection import selection
from facescript.lsp.features.semantic_tokens import semantic_tokens
from facescript.lsp.features.symbols import symbols

RUNS = 40

SCREEN = types.Range(types.Position(1_000, 0), types.Position(1_060, 0))
"""The lines that are seen at once."""


def rows() -> Iterator[Row]:
    """The answer that has a bar first; the others are told."""
    made = _analysis(lines_of(2_000))
    assert made.compiled.score is not None
    yield _row("semantic tokens of 2,000 lines", lambda: semantic_tokens(made), 60)
    yield _row("semantic tokens of a screen", lambda: semantic_tokens(made, SCREEN), None)
    yield _row("hints of a screen", lambda: inlay_hints(made, SCREEN), None)
    yield _row("selection at a place", lambda: selection(made, [SCREEN.start]), None)
    for feature in (symbols, folding, colours, lenses, links):
        yield _row(f"{feature.__name__} of 2,000 lines", lambda feature=feature: feature(made), None)


def _analysis(text: str) -> Analysis:
    uri = (Path(gettempdir()) / "marks.face").as_uri()
    workspace = Workspace(None)
    workspace.put_text_document(types.TextDocumentItem(uri, "face", 1, text))
    return Desk(workspace).analysis(uri)


def _row(what: str, answer: Callable[[], object], bar: int | None) -> Row:
    took = []
    for _ in range(RUNS):
        start = time.process_time()
        answer()
        took.append((time.process_time() - start) * 1000)
    took.sort()
    most = took[int(len(took) * 0.99)]
    found = f"p50 {took[len(took) // 2]:.1f} ms, p99 {most:.1f} ms"
    return Row(what, f"p99 {bar} ms" if bar else "", found, most <= bar if bar else None)


if __name__ == "__main__":
    for row in rows():
        print(row)
