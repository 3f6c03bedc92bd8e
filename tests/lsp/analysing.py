"""Texts to the analysis of the first, as an editor would have them open."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from pygls.workspace import Workspace

from facescript.lsp.desk import Analysis, Desk

ROOT = Path("/project")
"""The folder that the documents lie in. It need not be there."""


def analysis(text: str, **other_files: str) -> Analysis:
    """The analysis of `main.face`; the others are open beside it, by their names without `.face`."""
    workspace = Workspace(ROOT.as_uri())
    for name, content in {"main": text, **other_files}.items():
        item = types.TextDocumentItem((ROOT / f"{name}.face").as_uri(), "face", 1, content)
        workspace.put_text_document(item)
    return Desk(workspace).analysis((ROOT / "main.face").as_uri())
