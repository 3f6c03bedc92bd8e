"""The language server itself: the features put together, over standard input and output, TCP or WebSocket."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from pygls.lsp.server import LanguageServer

from facescript import __version__
from facescript.lsp.desk import Desk

FEATURES = (
    "calls",
    "colours",
    "completion",
    "definition",
    "diagnostics",
    "fixes",
    "folding",
    "formatting",
    "highlight",
    "hover",
    "inlay_hints",
    "lenses",
    "links",
    "preview",
    "references",
    "rename",
    "selection",
    "semantic_tokens",
    "signature",
    "symbols",
    "workspace_symbols",
)
"""The files of `features/`."""


class FaceServer(LanguageServer):
    """A server of one editor."""

    def __init__(self) -> None:
        super().__init__("facescript", __version__)
        self._desk: Desk | None = None
        self.followers: list[Callable[[str], None]] = []
        """Who is told the address of a document that has been opened or edited."""

    @property
    def desk(self) -> Desk:
        if self._desk is None:
            self._desk = Desk(self.workspace)
        return self._desk


def make_server() -> FaceServer:
    server = FaceServer()
    for name in FEATURES:
        import_module(f"facescript.lsp.features.{name}").register(server)
    return server
