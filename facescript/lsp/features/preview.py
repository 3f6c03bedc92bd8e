"""A document to a page that plays it as it is typed: what is dragged there is edited here, what is clicked is shown."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from lsprotocol import types
from pygls.uris import to_fs_path

from facescript.lsp.offered import CARET, PREVIEW
from facescript.lsp.places import column, offset, position, units
from facescript.lsp.previews import Message, NoPreview, Preview, preview
from facescript.lsp.server import FaceServer
from facescript.text import Source

PAUSE = 0.05
"""Seconds between two texts that are handed on."""

MOST = 8
"""Scripts that have a preview at once: each is a process that draws."""

TITLE = "drag in the preview"


class Showing:
    """The pages of a server's documents, by their addresses."""

    def __init__(self, server: FaceServer) -> None:
        self._server = server
        self._pages: dict[str, Preview] = {}
        self._opening: dict[str, asyncio.Task[Preview]] = {}
        self._sent: dict[str, tuple[int, Source]] = {}
        self._waiting: dict[str, asyncio.TimerHandle] = {}
        self._tasks = set[asyncio.Task[None]]()

    async def show(self, uri: str, time: float | None) -> str:
        """The address of a document's page. Raises `NoPreview`."""
        if uri not in self._pages:
            if uri not in self._opening:
                self._opening[uri] = asyncio.create_task(self._open(uri))
            try:
                self._pages[uri] = await self._opening[uri]
            finally:
                self._opening.pop(uri, None)
            self._send(uri)
        if time is not None:
            self._pages[uri].tell("play", time=time)
        address: str = self._pages[uri].address.result()
        return address

    def changed(self, uri: str) -> None:
        """A document has been edited."""
        if uri in self._pages and uri not in self._waiting:
            self._waiting[uri] = asyncio.get_running_loop().call_later(PAUSE, self._send, uri)

    def caret(self, uri: str, place: types.Position) -> None:
        """The caret is at a place of a document."""
        if uri in self._pages:
            source = self._server.desk.source(uri)
            self._pages[uri].tell("caret", offset=units(source.text[: offset(source, place)]))

    def close(self) -> None:
        """Ends all pages."""
        for page in self._pages.values():
            page.close()
        self._pages.clear()

    async def _open(self, uri: str) -> Preview:
        if find_spec("websockets") is None:
            raise NoPreview('it needs an extra: pip install "facescript[preview]"')
        path = Path(to_fs_path(uri) or "")
        if uri not in self._server.workspace.text_documents or not uri.startswith("file:") or not path.is_file():
            raise NoPreview("the script has to be saved first")
        if len(self._pages) >= MOST:
            raise NoPreview(f"{MOST} scripts have one already; close a page, and try again in a minute")

        def hear(message: Message) -> None:
            task = asyncio.create_task(self._hear(uri, message))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

        def ended(why: str) -> None:
            self._pages.pop(uri, None)
            if why:
                self._warn(f"The preview of {path.name} is gone: {why}. Open it again to go on.")

        return await preview(path, self._server.desk.root(path), hear, ended)

    def _send(self, uri: str) -> None:
        """Hands the text on, with a number by which edits of it are known."""
        self._waiting.pop(uri, None)
        if uri in self._pages:
            number, source = self._sent.get(uri, (0, None))[0] + 1, self._server.desk.source(uri)
            self._sent[uri] = number, source
            self._pages[uri].tell("text", version=number, text=source.text)

    # -------------------------------------------------------------------------------------------- what a page says

    async def _hear(self, uri: str, message: Message) -> None:
        source = self._server.desk.source(uri)
        first, last = (column(source.text, int(str(message[edge]))) for edge in ("from", "to"))
        where = types.Range(position(source, first), position(source, last))
        if message["kind"] == "jump":
            await self._jump(uri, where)
        elif message["kind"] == "edit":
            number, known = self._sent.get(uri, (0, source))
            if message["version"] != number or known.text != source.text:
                self._warn("The script was edited meanwhile, so it was not changed by the preview.")
            else:
                await self._edit(uri, types.TextEdit(where, str(message["text"])))

    async def _jump(self, uri: str, where: types.Range) -> None:
        if not shows_documents(self._server):
            name = uri.rpartition("/")[2]
            self._tell(f"{name}:{where.start.line + 1}")
            return
        await self._server.window_show_document_async(
            types.ShowDocumentParams(uri, take_focus=True, selection=where, external=False)
        )

    async def _edit(self, uri: str, edit: types.TextEdit) -> None:
        document = self._server.workspace.text_documents.get(uri)
        version = document.version if document is not None else None
        identifier = types.OptionalVersionedTextDocumentIdentifier(uri=uri, version=version)
        whole = types.WorkspaceEdit(document_changes=[types.TextDocumentEdit(identifier, [edit])])
        if not takes_versions(self._server):
            whole = types.WorkspaceEdit(changes={uri: [edit]})
        result = await self._server.workspace_apply_edit_async(types.ApplyWorkspaceEditParams(whole, TITLE))
        if not result.applied:
            self._warn(f"The editor did not change the script: {result.failure_reason or 'it gave no reason'}.")

    def _warn(self, text: str) -> None:
        self._server.window_show_message(types.ShowMessageParams(types.MessageType.Warning, text))

    def _tell(self, text: str) -> None:
        self._server.window_show_message(types.ShowMessageParams(types.MessageType.Info, text))

    async def open_address(self, address: str) -> None:
        """Shows a page in a browser, or says where it is."""
        shown = False
        if shows_documents(self._server):
            result = await self._server.window_show_document_async(types.ShowDocumentParams(address, external=True))
            shown = result.success
        if not shown:
            self._tell(f"The preview is at {address}")

    def refuse(self, uri: str, why: str) -> None:
        self._warn(f"{uri.rpartition('/')[2]} cannot be previewed: {why}.")


def shows_documents(server: FaceServer) -> bool:
    """Whether the editor can be asked to show a document."""
    window = server.client_capabilities.window
    return window is not None and window.show_document is not None and window.show_document.support


def takes_versions(server: FaceServer) -> bool:
    """Whether the editor takes edits of a state of a document."""
    workspace = server.client_capabilities.workspace
    edit = workspace.workspace_edit if workspace is not None else None
    return edit is not None and bool(edit.document_changes)


def register(server: FaceServer) -> None:
    showing = Showing(server)
    server.followers.append(showing.changed)

    @server.command(PREVIEW)
    async def asked(_: FaceServer, *arguments: Any) -> str | None:
        uri, time, shown = (*arguments, *(None, None, True)[len(arguments) :])[:3]
        if not isinstance(uri, str):
            return None
        try:
            address = await showing.show(uri, float(time) if isinstance(time, int | float) else None)
        except NoPreview as fault:
            showing.refuse(uri, str(fault))
            return None
        if shown:
            await showing.open_address(address)
        return address

    @server.feature(CARET)
    def caret(_: FaceServer, params: Any) -> None:
        with suppress(AttributeError, TypeError, ValueError):
            place = params.position
            showing.caret(str(params.textDocument.uri), types.Position(int(place.line), int(place.character)))

    @server.feature(types.SHUTDOWN)
    def shutdown(_: FaceServer, __: None) -> None:
        showing.close()
