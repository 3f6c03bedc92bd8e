"""The language server itself: the features put together, over standard input and output, TCP or WebSocket."""

from __future__ import annotations

import logging
from importlib import import_module

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from facescript import __version__
from facescript.lsp.desk import Desk
from facescript.lsp.documents import Documents
from facescript.lsp.protocol import FaceProtocol, quiet_refusals

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
        super().__init__("facescript", __version__, protocol_cls=FaceProtocol)
        self._desk: Desk | None = None

    @property
    def desk(self) -> Desk:
        if self._desk is None:
            self._desk = Desk(self.workspace)
        return self._desk


def make_server() -> FaceServer:
    server = FaceServer()
    logging.getLogger("pygls.protocol.json_rpc").addFilter(quiet_refusals)

    @server.feature(types.INITIALIZE)
    def initialized(_: FaceServer, params: types.InitializeParams) -> None:
        server.protocol._workspace = Documents(
            server.workspace.root_uri, server.workspace._sync_kind, params.workspace_folders or []
        )

    for name in FEATURES:
        import_module(f"facescript.lsp.features.{name}").register(server)
    return server
