"""The language server itself: the features put together, over standard input and output, TCP or WebSocket.

An editor is answered at once: the features, and with them the compiler, are loaded when it says that it has heard what
is offered, or when it asks for one.
"""

from __future__ import annotations

import gc
import logging
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeVar

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from facescript import __version__
from facescript.lsp.documents import Documents
from facescript.lsp.offered import COMMANDS, OFFERED, Offer
from facescript.lsp.protocol import FaceProtocol, quiet_refusals

if TYPE_CHECKING:
    from facescript.lsp.desk import Desk

COLLECT = 10_000
"""New objects between two looks for rubbish: many short looks, where a command of the program looks seldom and long (an
edit must not wait for one)."""

Handler = Callable[..., Any]
F = TypeVar("F", bound=Handler)


class FaceServer(LanguageServer):
    """A server of one editor."""

    def __init__(self) -> None:
        super().__init__("facescript", __version__, protocol_cls=FaceProtocol)
        self._desk: Desk | None = None
        self._handlers: dict[str, Handler] = {}
        self.followers: list[Callable[[str], None]] = []
        """Who is told the address of a document that has been opened or edited."""
        super().feature(types.INITIALIZE)(lambda params: self._opened(params))
        super().feature(types.INITIALIZED)(lambda _: self._load())
        for offer in OFFERED:
            super().feature(offer.method, offer.options)(self._answering(offer))
        for offer in COMMANDS:
            super().command(offer.method)(self._executing(offer))

    @property
    def desk(self) -> Desk:
        if self._desk is None:
            from facescript.lsp.desk import Desk

            self._desk = Desk(self.workspace)
        return self._desk

    def feature(self, feature_name: str, options: Any = None) -> Callable[[F], F]:
        """Takes what answers a method that is offered; its options stand in `offered.py`."""

        def take(handler: F) -> F:
            self._handlers[feature_name] = handler
            return handler

        return take

    def command(self, command_name: str) -> Callable[[F], F]:
        """Takes what does a command that is offered."""
        return self.feature(command_name)

    def _answering(self, offer: Offer) -> Handler:
        def answer(params: Any) -> Any:
            return self._handler(offer)(self, params)

        return answer

    def _executing(self, offer: Offer) -> Handler:
        async def execute(*arguments: Any) -> Any:
            return await self._handler(offer)(self, *arguments)

        return execute

    def _handler(self, offer: Offer) -> Handler:
        if offer.method not in self._handlers:
            import_module(f"facescript.lsp.features.{offer.feature}").register(self)
        return self._handlers[offer.method]

    def _opened(self, params: types.InitializeParams) -> None:
        """Has the editor's documents kept as `documents.py` does."""
        pygls = self.workspace
        self.protocol._workspace = Documents(pygls.root_uri, pygls._sync_kind, params.workspace_folders or [])

    def _load(self) -> None:
        for offer in OFFERED:
            self._handler(offer)
        gc.collect()
        gc.freeze()  # the compiler itself is never rubbish
        gc.set_threshold(COLLECT)


def make_server() -> FaceServer:
    logging.getLogger("pygls.protocol.json_rpc").addFilter(quiet_refusals)
    return FaceServer()
