"""A run to the pages that show it, and what is touched on them to events: a server on this machine."""

from __future__ import annotations

import asyncio
import secrets
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from http import HTTPStatus
from math import ceil
from pathlib import Path, PurePosixPath

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from facescript.backends.page.document import called
from facescript.backends.page.figure import Object
from facescript.ir.play import Play
from facescript.live.model import Frame, Layout, Mark, Teller, Utterance
from facescript.live.page.easel import Easel
from facescript.live.page.guest import Guest
from facescript.live.page.lines import Lines
from facescript.live.page.offer import offer
from facescript.live.page.scenery import Scenery
from facescript.schedule.score import Score
from facescript.web.doors import LOOPBACK, file, files_of, is_stranger, names_of, refused
from facescript.web.messages import numbers
from facescript.web.sayings import Taken, understood

KIOSK = Path(__file__).with_name("kiosk")

USUAL = 5483
"""The port where none is asked for: LIVE on a telephone."""

PAGES = 8
"""Pages that may be open at once."""

FASTEST = 90.0
"""Frames a second that pages are told, at most: they draw what lies between."""

SILENT = 5.0
"""Seconds after which a page that answers nothing is gone."""

LARGEST = 4096
"""Bytes of what a page says, at most."""

SOCKET = "/live"

UNDER_WAY = 12
"""Frames that are being drawn at once, at most."""

AGAIN = 1.0
"""Seconds until a process that ended is begun again."""

COUNTED = ("sent", "dropped", "events", "refused", "easels lost")
"""What is counted, in the order in which it is told."""

TAKEN: Taken = {"touched": {"text": (str,)}, "key": {"text": (str,)}, "drew": {"number": (int,)}}
"""What a page may say: what was touched, which key was struck, and which frame it drew."""


class Page:
    """The pages of a run: a sink of what they show and sound, and a source of what is touched on them.

    `name` is the script's, `score` gives the score of the run as it is now, and `pictures` reads a background picture
    by its path. The page is at a `port` of this machine, else at the usual one or any; where it is is `told`.
    """

    def __init__(
        self,
        play: Play,
        name: str,
        score: Callable[[], Score],
        pictures: Callable[[str], bytes],
        port: int | None,
        told: Callable[[str], None],
    ) -> None:
        self._play, self._score, self._pictures = play, score, pictures
        self._name, self._port, self._told = name, port, told
        self._offer, self._lines = offer(play), Lines(play)
        self._files = files_of(KIOSK)
        self._guests = set[Guest]()
        self._counts = Counter[str]()
        self._teller: Teller | None = None
        self._names = frozenset[str]()
        self._server: Server | None = None
        self._easel: Easel | None = None
        self._closed = False
        self._figure: list[bytes] = []
        self._under_way: dict[int, Object] = {}
        self._time, self._next = 0.0, 0

    async def open(self, layout: Layout) -> None:
        """Begins to draw, and listens. Raises `OSError` where the port is taken."""
        self._stride = max(1, ceil(layout.fps / FASTEST))
        self._scenery = Scenery(self._score(), layout, self._pictures)
        self._server = await self._listening()
        self._about = {
            "run": secrets.token_hex(8),
            "title": layout.title or called(PurePosixPath(self._name).stem),
            "pace": layout.fps / self._stride,
            "touched": self._offer.touched,
            "keys": self._offer.keys,
            "language": self._lines.language,
        }
        self._easel = self._drawing()
        port = next(iter(self._server.sockets)).getsockname()[1]
        self._names = names_of(port)
        self._told(f"{self._name} is shown at http://{LOOPBACK}:{port}/ (Ctrl-C ends it)")

    def frame(self, frame: Frame) -> None:
        """Has a frame drawn if a page will draw it. Of frames that come while dozens wait none is kept."""
        self._time = frame.time
        if self._easel is None or not self._figure or frame.number < self._next or self._unwatched:
            return
        if len(self._under_way) >= UNDER_WAY:
            self._counts["dropped"] += 1
            return
        self._next = frame.number + self._stride
        scene = self._scenery.scene(frame, self._score())
        for layer in scene.layers:
            self._tell(layer)
        self._under_way[frame.number] = scene.head
        self._easel.draw(frame.number, scene.pose)

    def mark(self, mark: Mark) -> None:
        """Pages show what is said, not what begins."""

    def utter(self, utterance: Utterance) -> None:
        self._tell(self._lines.take(utterance))

    async def close(self) -> None:
        self._closed = True
        if self._easel is not None:
            self._easel.close()
        if self._server is not None:
            self._server.close()
            await self._server.wait_closed()

    def counts(self) -> dict[str, int]:
        """Pages that are open, frames they were sent and that were dropped for them, and what they said."""
        counts = self._counts.copy()
        for guest in self._guests:
            counts.update(sent=guest.sent, dropped=guest.dropped)
        return {"pages": len(self._guests), **{name: counts[name] for name in COUNTED}}

    async def run(self, teller: Teller) -> None:
        """Tells of what is touched until it is cancelled."""
        self._teller = teller
        try:
            await asyncio.get_running_loop().create_future()
        finally:
            self._teller = None

    async def _listening(self) -> Server:
        """The server, at the port that was asked for, else at the usual one or where that is taken at any."""
        for port in (USUAL, 0) if self._port is None else (self._port,):
            try:
                return await serve(
                    self._receive,
                    LOOPBACK,
                    port,
                    process_request=self._answer,
                    max_size=LARGEST,
                    max_queue=16,
                    compression=None,
                    open_timeout=SILENT,
                    close_timeout=1.0,
                    ping_interval=SILENT,
                    ping_timeout=SILENT,
                )
            except OSError:
                if port == 0 or self._port is not None:
                    raise
        raise AssertionError("there is a port to try")

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """The page's files to who is of this machine, and a WebSocket to as many as may come."""
        if is_stranger(request, self._names):
            return refused(HTTPStatus.FORBIDDEN)
        path = request.path.partition("?")[0]
        if path != SOCKET:
            return file(self._files, path)
        return refused(HTTPStatus.SERVICE_UNAVAILABLE) if len(self._guests) >= PAGES else None

    async def _receive(self, connection: ServerConnection) -> None:
        """One page, from its first word to its last."""
        guest = Guest(connection, self._known())
        self._guests.add(guest)
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
            self._counts.update(sent=guest.sent, dropped=guest.dropped)
            sending.cancel()

    @property
    def _unwatched(self) -> bool:
        """Whether no page would draw a frame."""
        return all(guest.idle for guest in self._guests)

    def _known(self) -> Iterator[bytes]:
        """What a page is told when it comes, once there is a figure."""
        if self._figure:
            yield from (*self._figure, *self._scenery.told, *self._lines.sounding(self._time))

    def _drawing(self) -> Easel:
        """An easel, whose messages come here in the loop's own thread."""
        loop = asyncio.get_running_loop()

        def soon(act: Callable[..., None], *values: object) -> None:
            with suppress(RuntimeError):  # the loop ends
                loop.call_soon_threadsafe(act, *values)

        return Easel(
            self._play.film,
            self._play.faces,
            self._about,
            lambda messages: soon(self._begun, messages),
            lambda number, made: soon(self._drawn, number, made),
            lambda: soon(self._ended),
        )

    def _ended(self) -> None:
        """The easel's process is gone, as when memory runs out: another begins."""
        asyncio.get_running_loop().call_later(AGAIN, self._draw_again)

    def _draw_again(self) -> None:
        if not self._closed:
            self._counts["easels lost"] += 1
            self._under_way.clear()
            self._easel = self._drawing()

    def _begun(self, figure: list[bytes]) -> None:
        self._figure = figure
        for message in self._known():
            self._tell(message)

    def _drawn(self, number: int, made: bytes) -> None:
        """A frame is there: pages that draw it are sent it."""
        head = self._under_way.pop(number, None)
        if head is not None:
            message = numbers("frame", [made], **head)
            for guest in self._guests:
                guest.show(number, message)

    def _tell(self, message: bytes) -> None:
        for guest in self._guests:
            guest.tell(message)

    def _take(self, guest: Guest, said: str | bytes) -> None:
        message = understood(said, TAKEN)
        if message is None:
            self._counts["refused"] += 1
        elif message["kind"] == "drew":
            guest.drew(int(str(message["number"])))
        else:
            self._happened(str(message["kind"]), str(message["text"]))

    def _happened(self, kind: str, about: str) -> None:
        """Tells the run of what a page offers."""
        happening = self._offer.happening(kind, about)
        if happening is None or self._teller is None:
            self._counts["refused"] += 1
            return
        self._counts["refused" if self._teller.event(happening) else "events"] += 1
