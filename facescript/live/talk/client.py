"""Calls of a program to messages for a face that runs elsewhere, and what became of them back: `connect`, for programs
that are asynchronous, and `connect_plain`, for those that are not."""

from __future__ import annotations

import asyncio
import itertools
import json
from collections.abc import AsyncIterable, AsyncIterator, Coroutine, Iterable, Iterator
from contextlib import asynccontextmanager, contextmanager
from threading import Thread
from typing import Any, TypeVar

from websockets.asyncio.client import ClientConnection
from websockets.asyncio.client import connect as open_connection
from websockets.exceptions import ConnectionClosed

from facescript.writing.calls import Calls

USUAL = "talk://127.0.0.1:8770"

T = TypeVar("T")

Message = dict[str, Any]


class Refusal(ValueError):
    """What was told is refused; `diagnostics` say why, as `facescript check --json` has them."""

    def __init__(self, refused: str | list[Message]) -> None:
        self.diagnostics: list[Message] = [{"message": refused}] if isinstance(refused, str) else refused
        super().__init__("; ".join(str(one["message"]) for one in self.diagnostics))


class Line:
    """What was told, and what becomes of it where it speaks."""

    def __init__(self, speaks: bool) -> None:
        self.speaks = speaks
        self._over: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        if not speaks:
            self._over.set_result("done")

    async def over(self) -> str:
        """Waits until it is over: `said`, `interrupted`, or `done` for what does not speak. Raises `Refusal` where no
        voice can say it, `ConnectionError` where the run is gone."""
        return await asyncio.shield(self._over)

    def take(self, message: Message) -> bool:
        """Notes what became of it; whether that is its end."""
        if self._over.done():
            return True
        how = next((how for how in ("said", "interrupted") if how in message), None)
        if how is not None:
            self._over.set_result(how)
        elif "refused" in message:
            self._over.set_exception(Refusal(message["refused"]))
            self._over.exception()  # who does not wait for it is not told
        return self._over.done()

    def lose(self) -> None:
        if not self._over.done():
            self._over.set_exception(ConnectionError("the run is gone"))
            self._over.exception()


class Talk:
    """A run that is talked to."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection = connection
        self._ids = itertools.count(1)
        self._answers: dict[int, asyncio.Future[Any]] = {}
        self._lines: dict[int, Line] = {}
        self._marks = asyncio.Queue[Message | None]()
        self._reading = asyncio.create_task(self._read())

    def face(self, name: str = "") -> Face:
        """A face by its name; without one, the only one of the script."""
        return Face(self, name)

    async def do(self, statements: str, *, now: bool = False) -> Line:
        """Statements of the language, with the names of the script; several stand on lines of their own. With `now`
        they break off what is being said. Raises `Refusal`."""
        return await self.tell({"do": statements, "now": now})

    async def interrupt(self, face: str = "") -> None:
        """What is said breaks off at the end of its word, and what waits is dropped."""
        await self.ask({"interrupt": face})

    async def speaking(self) -> dict[str, str]:
        """What each face is saying that is saying something."""
        found: dict[str, str] = (await self.ask({"ask": "speaking"}))["speaking"]
        return found

    async def waiting(self) -> int:
        """How many statements wait their turn."""
        return int((await self.ask({"ask": "waiting"}))["waiting"])

    async def marks(self) -> AsyncIterator[Message]:
        """What begins from now on: words, lines, acts, events: `{"word": "cup", "face": "ada", "time": 3.2}`."""
        await self.ask({"listen": ""})
        while (mark := await self._marks.get()) is not None:
            yield mark

    async def tell(self, message: Message) -> Line:
        """Something that may speak. Raises `Refusal`."""
        line: Line = await self._asked(next(self._ids), message)
        return line

    async def stream(self, face: str, pieces: AsyncIterable[str] | Iterable[str]) -> Line:
        """A text that comes in pieces, of any length. Raises `Refusal`."""
        number, line = next(self._ids), None
        async for piece in _each(pieces):
            message = {"stream": piece, "face": face}
            if line is None:
                line = await self._asked(number, message)
            else:
                await self._send(number, message)
        last = {"stream": "", "face": face, "over": True}
        if line is None:
            return Line(speaks=False)
        await self._send(number, last)
        found: Line = line
        return found

    async def ask(self, message: Message) -> Message:
        answer: Message = await self._asked(next(self._ids), message)
        return answer

    async def close(self) -> None:
        self._reading.cancel()
        await self._connection.close()

    async def _asked(self, number: int, message: Message) -> Any:
        """The first answer to a message: a line for what was taken and speaks. Raises `Refusal`, `ConnectionError`."""
        answer = self._answers[number] = asyncio.get_running_loop().create_future()
        await self._send(number, message)
        return await answer

    async def _send(self, number: int, message: Message) -> None:
        try:
            await self._connection.send(json.dumps({"id": number, **message}))
        except ConnectionClosed:
            raise ConnectionError("the run is gone") from None

    async def _read(self) -> None:
        """Takes what comes, until the run is gone."""
        try:
            async for data in self._connection:
                self._take(json.loads(data))
        except ConnectionClosed:
            pass
        finally:
            for line in self._lines.values():
                line.lose()
            for answer in self._answers.values():
                if not answer.done():
                    answer.set_exception(ConnectionError("the run is gone"))
            self._marks.put_nowait(None)

    def _take(self, message: Message) -> None:
        if "mark" in message:
            self._marks.put_nowait(message["mark"])
            return
        number = int(message.get("id") or 0)
        answer, line = self._answers.pop(number, None), self._lines.get(number)
        if answer is not None and "refused" in message:
            answer.set_exception(Refusal(message["refused"]))
        elif answer is not None and "speaks" in message:
            line = Line(message["speaks"])
            if line.speaks:
                self._lines[number] = line
            answer.set_result(line)
        elif answer is not None:
            answer.set_result(message)
        elif line is not None and line.take(message):
            del self._lines[number]


class Face(Calls[Coroutine[Any, Any, Line]]):
    """A face of a run: what is called is done by it at once; what speaks waits until it has done speaking. Numbers and
    modifiers are those of `facescript.Script`."""

    def __init__(self, talk: Talk, name: str) -> None:
        self._talk, self.name = talk, name

    def __str__(self) -> str:
        return self.name

    def statement(self, words: str) -> Coroutine[Any, Any, Line]:
        return self._talk.do(f"{self.name}: {words}" if self.name else words)

    async def say_stream(self, pieces: AsyncIterable[str] | Iterable[str]) -> Line:
        """Says a text that comes in pieces, each sentence as soon as it is complete. It is plain: no sign in it has a
        meaning. Gives the line once all pieces have come."""
        return await self._talk.stream(self.name, pieces)

    async def interrupt(self) -> None:
        """What it says breaks off at the end of its word, and what waits is dropped."""
        await self._talk.interrupt(self.name)

    async def speaking(self) -> str | None:
        """What it is saying, None where it is silent."""
        found = await self._talk.speaking()
        return found.get(self.name) if self.name else next(iter(found.values()), None)


@asynccontextmanager
async def connect(address: str = USUAL, token: str = "") -> AsyncIterator[Talk]:
    """A run that `facescript live SCRIPT --from talk://...` has begun. Raises `OSError` where there is none."""
    headers = {"Authorization": f"Bearer {token}"} if token else {}
    place = f"ws://{address.removeprefix('talk://').rstrip('/')}/talk"
    async with open_connection(place, additional_headers=headers, compression=None, proxy=None) as connection:
        talk = Talk(connection)
        try:
            yield talk
        finally:
            await talk.close()


# ------------------------------------------------------------------------------------------------ without asyncio


class PlainLine:
    def __init__(self, plain: PlainTalk, line: Line) -> None:
        self._plain, self._line, self.speaks = plain, line, line.speaks

    def over(self) -> str:
        """Waits until it is over, as `Line.over`."""
        return self._plain.wait(self._line.over())


class PlainFace(Calls[PlainLine]):
    """A face of a run, for programs that wait."""

    def __init__(self, plain: PlainTalk, face: Face) -> None:
        self._plain, self._face = plain, face

    def statement(self, words: str) -> PlainLine:
        return self._plain.line(self._face.statement(words))

    def say_stream(self, pieces: Iterable[str]) -> PlainLine:
        return self._plain.line(self._face.say_stream(pieces))

    def interrupt(self) -> None:
        self._plain.wait(self._face.interrupt())

    def speaking(self) -> str | None:
        return self._plain.wait(self._face.speaking())


class PlainTalk:
    """A run that is talked to by a program that waits for each answer; any thread may call it."""

    def __init__(self, loop: asyncio.AbstractEventLoop, talk: Talk) -> None:
        self._loop, self._talk = loop, talk

    def face(self, name: str = "") -> PlainFace:
        return PlainFace(self, self._talk.face(name))

    def do(self, statements: str, *, now: bool = False) -> PlainLine:
        return self.line(self._talk.do(statements, now=now))

    def interrupt(self, face: str = "") -> None:
        self.wait(self._talk.interrupt(face))

    def speaking(self) -> dict[str, str]:
        return self.wait(self._talk.speaking())

    def waiting(self) -> int:
        return self.wait(self._talk.waiting())

    def marks(self) -> Iterator[Message]:
        marks = self._talk.marks()
        while (mark := self.wait(anext(marks, None))) is not None:
            yield mark

    def line(self, told: Coroutine[Any, Any, Line]) -> PlainLine:
        return PlainLine(self, self.wait(told))

    def wait(self, work: Coroutine[Any, Any, T]) -> T:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()


@contextmanager
def connect_plain(address: str = USUAL, token: str = "") -> Iterator[PlainTalk]:
    """The same as `connect` without asyncio: its loop runs in a thread of its own."""
    loop = asyncio.new_event_loop()
    thread = Thread(target=loop.run_forever, daemon=True, name="talk")
    thread.start()
    opening = connect(address, token)
    try:
        talk = asyncio.run_coroutine_threadsafe(opening.__aenter__(), loop).result()
        try:
            yield PlainTalk(loop, talk)
        finally:
            asyncio.run_coroutine_threadsafe(opening.__aexit__(None, None, None), loop).result()
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        loop.close()


async def _each(pieces: AsyncIterable[str] | Iterable[str]) -> AsyncIterator[str]:
    """The pieces one by one; those of an ordinary iterator in a thread, for it may wait."""
    if isinstance(pieces, AsyncIterable):
        async for piece in pieces:
            yield piece
        return
    waiting = iter(pieces)
    while (found := await asyncio.to_thread(next, waiting, None)) is not None:
        yield found
