"""A script on a disk to a page of this machine that shows it as it changes: the server, and who talks to whom."""

from __future__ import annotations

import asyncio
import secrets
import signal
import tempfile
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from http import HTTPStatus
from pathlib import Path

from websockets.asyncio.server import ServerConnection, serve
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from facescript.preview.board import Board
from facescript.preview.borrowed import Borrowed
from facescript.preview.doors import HELP, LIVE, Doors
from facescript.preview.editor import Editor
from facescript.preview.help import Helpers
from facescript.preview.paper import Edit, Paper, Refusal
from facescript.preview.share import Sharing
from facescript.preview.watch import changes
from facescript.preview.workshop import Workshop
from facescript.web.doors import LOOPBACK, refused
from facescript.web.messages import Message, head_of, is_text, text
from facescript.web.sayings import Pace, Taken, understood
from facescript.world import LARGEST_SCRIPT, World, WorldFailure

USUAL = 3223
"""The port where none is asked for: FACE on a telephone. Where it is taken, any other will do."""

PAGES = 8
"""Pages that may be open at once."""

QUICKEST = 200
"""Messages a second from a page, over a few seconds."""

BEHIND = 256 << 20
"""Bytes that wait for a page that does not read them, at most; then it has to come again."""

FORSAKEN = 60.0
"""Seconds without a page after which nobody in an editor looks any more."""

AGAIN = 1.0
"""Seconds until a process that ended is begun again."""

Number = (int, float)
MAYBE = (int, float, type(None))
TAKEN: Taken = {
    "playhead": {"time": Number, "playing": (bool,)},
    "text": {"base": (int,), "from": (int,), "to": (int,), "text": (str,)},
    "curves": {"face": (str,), "channels": (list,)},
    "drag": {"version": (int,), "id": (int,), "handle": (str,), "by": MAYBE, "degree": MAYBE, "done": (bool,)},
    "jump": {"from": (int,), "to": (int,)},
    "undo": {},
    "share": {},
}
"""What a page may say: the kinds, and what belongs to each."""


class Guest:
    """A page: what waits to be sent to it, and the `pace` at which it speaks."""

    def __init__(self, connection: ServerConnection, waiting: Iterable[bytes]) -> None:
        self._connection = connection
        self._waiting = asyncio.Queue[bytes]()
        self._size = 0
        self.pace = Pace(QUICKEST)
        for message in waiting:
            self.tell(message)

    def tell(self, message: bytes) -> None:
        """Sends a message in its turn; never waits."""
        self._size += len(message)
        if self._size > BEHIND:
            self._connection.transport.abort()
            return
        self._waiting.put_nowait(message)

    async def send(self) -> None:
        """Sends what waits, until the page is gone."""
        with suppress(ConnectionClosed):
            while True:
                message = await self._waiting.get()
                await self._connection.send(message, text=is_text(message))
                self._size -= len(message)


class Preview:
    """The pages of one script: `name` is its path in the project `world`; `editor` is where it is written, if one is
    known."""

    def __init__(self, paper: Paper, world: World, name: str, folder: Path, editor: Editor | None) -> None:
        self._paper, self._world, self._name, self._folder = paper, world, name, folder
        self._editor, self._from = editor, b""
        self._board, self._guests = Board(), set[Guest]()
        self._left = time.monotonic()
        self._used: list[str] = []
        self._sharing = Sharing(world.root, name, folder)
        self._loop = asyncio.get_running_loop()
        self._workshop = self._opened()
        self._tell(text("editor", connected=editor is not None))
        self.publish()

    def publish(self) -> None:
        """The script is another now: pages and workshop are told."""
        paper = self._paper
        about = {"version": paper.version, "text": paper.text}
        root = self._world.root.absolute()
        place = {"root": root.as_uri(), "uri": (root / self._name).as_uri(), "scratch": paper.scratch}
        self._tell(text("script", name=self._name, writable=paper.writable, **place, **about))
        self._workshop.tell({"kind": "text", **about})

    async def watch(self) -> None:
        """Follows the files of the script for ever."""
        async for changed in changes(self._files):
            if not self._paper.read():
                if not changed - {self._paper.path}:
                    continue
                self._paper.version += 1
            self.publish()

    async def receive(self, connection: ServerConnection) -> None:
        """One page, from its first word to its last."""
        guest = Guest(connection, [*self._board.all(), *([self._from] if self._from else [])])
        self._guests.add(guest)
        self._from = b""
        sending = asyncio.create_task(guest.send())
        try:
            async for said in connection:
                if guest.pace.floods():
                    await connection.close(1008, "too many messages")
                    return
                self._take(guest, said)
        except ConnectionClosed:
            pass
        finally:
            self._guests.discard(guest)
            self._left = time.monotonic()
            sending.cancel()

    @property
    def full(self) -> bool:
        """Whether no further page may come."""
        return len(self._guests) >= PAGES

    @property
    def forsaken(self) -> bool:
        """Whether no page has been there for a while."""
        return not self._guests and time.monotonic() - self._left > FORSAKEN

    def close(self) -> None:
        self._workshop.close()

    def hear(self, message: Message) -> None:
        """Takes what the editor says; the first page that comes plays from where it was asked for."""
        assert isinstance(self._paper, Borrowed)
        if message["kind"] == "text":
            if self._paper.hear(message):
                self.publish()
        elif message["kind"] == "caret":
            first, last = self._paper.line(int(str(message["offset"])))
            self._tell(text("lit", **{"from": first, "to": last}))
        else:
            play = text("play", time=message["time"])
            self._from = b"" if self._guests else play
            self._tell(play)

    def _opened(self) -> Workshop:
        """A workshop, whose messages come here in the server's own thread."""

        def soon(act: Callable[..., None], *values: object) -> None:
            with suppress(RuntimeError):  # the server ends
                self._loop.call_soon_threadsafe(act, *values)

        return Workshop(
            self._world.root, self._name, self._folder, lambda made: soon(self._made, made), lambda: soon(self._ended)
        )

    def _ended(self) -> None:
        """The workshop's process is gone, as when memory runs out: another begins."""
        self._loop.call_later(AGAIN, self._begin_again)

    def _begin_again(self) -> None:
        self._workshop = self._opened()
        self.publish()

    def _made(self, message: bytes) -> None:
        """Takes what the workshop has made."""
        head = head_of(message) if message.startswith(USED) else None
        if head is not None:
            self._used = [str(name) for name in head["files"]]  # type: ignore[attr-defined]
        elif message.startswith(DRAGGED):
            self._dragged(head_of(message))
        else:
            self._tell(message)

    def _dragged(self, found: Message) -> None:
        """An edit that a drag is, which is shown or made."""
        if not found["done"]:
            self._tell(text("would", **{name: found[name] for name in ("from", "to", "text")}))
            return
        try:
            self._make({"base": found["version"], **found})
        except Refusal as fault:
            self._tell(text("refused", what="drag", why=fault.args[0]))

    def _tell(self, message: bytes) -> None:
        self._board.take(message)
        for guest in self._guests:
            guest.tell(message)

    def _files(self) -> Iterable[Path]:
        """The script's file and those that it uses."""
        if self._paper.path is not None:
            yield self._paper.path
        for name in self._used:
            with suppress(WorldFailure):
                yield self._world.path(name)

    def _take(self, guest: Guest, said: str | bytes) -> None:
        """What a page says; nonsense is passed over, but told."""
        message = understood(said, TAKEN)
        if message is None:
            guest.tell(text("refused", what="", why="it is no message of this page"))
            return
        kind = message["kind"]
        if kind == "share":
            self._sharing.share(self._paper.text, guest.tell)
        elif kind == "jump":
            if self._editor is not None:
                self._editor.tell(**message)  # type: ignore[arg-type]
        elif kind not in ("text", "undo"):
            self._workshop.tell(message)
        else:
            try:
                self._make(message)
            except Refusal as fault:
                guest.tell(text("refused", what=kind, why=fault.args[0]))

    def _make(self, message: Message) -> None:
        """Makes or takes back an edit, and tells of it; one in an editor is told as a text when it is made. Raises
        `Refusal`."""
        before = self._paper.version
        edit = self._paper.undo() if message["kind"] == "undo" else self._edited(message)
        self._tell(text("edited", **{"from": edit.first, "to": edit.last, "text": edit.text}))
        if self._paper.version != before:
            self.publish()

    def _edited(self, message: Message) -> Edit:
        """Makes an edit that a page asks for. Raises `Refusal`."""
        base, first, last, new = (message[name] for name in ("base", "from", "to", "text"))
        edit = Edit(first, last, new)  # type: ignore[arg-type]
        self._paper.edit(base, edit)  # type: ignore[arg-type]
        return edit


USED, DRAGGED = b'{"kind":"used"', b'{"kind":"dragged"'


async def run(
    paper: Paper, world: World, name: str, port: int, told: Callable[[str], None], editor: Editor | None = None
) -> None:
    """Serves until the process is told to end; `told` gets the address. Raises `OSError` where the port is taken.

    With an `editor` it ends with it too, and when nobody looks any more.
    """
    with tempfile.TemporaryDirectory(prefix="facescript-") as made:
        folder = Path(made)
        doors: list[Doors] = []
        pages: list[Preview] = []
        helpers = Helpers()

        def request(connection: ServerConnection, asked: Request) -> Response | None:
            way = doors[0].way(asked)
            if way is None:
                return refused(HTTPStatus.FORBIDDEN)
            if way == HELP:
                return None
            if way != LIVE:
                return doors[0].answer(way, asked)
            return refused(HTTPStatus.SERVICE_UNAVAILABLE) if pages[0].full else None

        async def receive(connection: ServerConnection) -> None:
            assert connection.request is not None
            helped = doors[0].way(connection.request) == HELP
            await (helpers.help if helped else pages[0].receive)(connection)

        async with serve(
            receive,
            LOOPBACK,
            port,
            process_request=request,
            max_size=2 * LARGEST_SCRIPT,
            max_queue=16,
            compression=None,
            open_timeout=5.0,
            close_timeout=1.0,
        ) as server:
            bound = next(iter(server.sockets)).getsockname()[1]
            key = "" if editor is None else secrets.token_urlsafe(16)
            doors.append(Doors(bound, folder, key))
            pages.append(Preview(paper, world, name, folder, editor))
            watching = asyncio.create_task(pages[0].watch())
            told(f"http://{LOOPBACK}:{bound}/{f'{key}/' if key else ''}")
            try:
                await _ended(pages[0], editor)
            finally:
                watching.cancel()
                pages[0].close()


async def _ended(page: Preview, editor: Editor | None) -> None:
    """Waits until the process is told to end; listens to its editor."""
    ended, loop = asyncio.Event(), asyncio.get_running_loop()
    with suppress(NotImplementedError):  # on Windows an interrupt comes as an exception
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, ended.set)
    if editor is None:
        await ended.wait()
        return

    def soon(act: Callable[..., None], *values: object) -> None:
        with suppress(RuntimeError):  # the server ends
            loop.call_soon_threadsafe(act, *values)

    editor.listen(lambda message: soon(page.hear, message), lambda: soon(ended.set))
    while not ended.is_set() and not page.forsaken:
        with suppress(TimeoutError):
            await asyncio.wait_for(ended.wait(), 1.0)
