"""A text, and others open beside it, to the analysis that features answer from."""

from __future__ import annotations

from lsprotocol.types import TextDocumentItem
from pygls.workspace import Workspace

from facescript.lsp.desk import Analysis, Desk

FOLDER = "file:///nowhere/project"


def analysis(text: str, **other_files: str) -> Analysis:
    """The document `a.face` of a project that is nowhere on the disk; `studio="..."` is its open file `studio.face`."""
    workspace = Workspace(FOLDER)
    for name, content in {"a": text, **other_files}.items():
        workspace.put_text_document(TextDocumentItem(f"{FOLDER}/{name}.face", "face", 1, content))
    return Desk(workspace).analysis(f"{FOLDER}/a.face")
