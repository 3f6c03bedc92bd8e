"""Messages of programs on a WebSocket to what a conversation is told, and back: answers, and what became of it."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import partial
from typing import Any

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from facescript.diagnostics.model import Diagnostic
from facescript.diagnostics.render import as_json
from facescript.live.talk.conversation import Conversation, Refused
from facescript.live.talk.sentences import Sentences
from facescript.writing.quotes import quoted

BEHIND = 1000
"""Messages that wait for a program that does not read them; what is more is dropped."""

MOST_STREAMS = 20
"""Texts of one program that come in pieces at a time."""

FORMS: Mapping[str, Mapping[str, tuple[type, ...]]] = {
    "do": {"now": (bool,)},
    "stream": {"face": (str,), "over": (bool,)},
    "interrupt": {},
    "ask": {},
    "listen": {},
}
"""What a message may be: the word that says its kind, with what may stand beside it and the `id`."""

FORM = 'a message is such as {"id": 1, "do": "ada: say \\"Hello.\\""}'

Send = Callable[[dict[str, object]], None]


class Talk:
    """Talks with programs for a conversation; `faces` are those of the script."""

    def __init__(self, conversation: Conversation, faces: tuple[str, ...]) -> None:
        self._conversation, self._faces = conversation, faces

    async def receive(self, connection: ServerConnection) -> None:
        """A program, from its first message to its last. What it told is done all the same when it is gone."""
        waiting = asyncio.Queue[str](BEHIND)

        def send(answer: dict[str, object]) -> None:
            try:
                waiting.put_nowait(json.dumps(answer))
            except asyncio.QueueFull:
                self._conversation.unread()

        guest = Guest(self._conversation, self._faces, send)
        sending = asyncio.create_task(_send(connection, waiting))
        try:
            with suppress(ConnectionClosed):
                async for message in connection:
                    guest.take(message)
        finally:
            guest.leave()
            sending.cancel()


async def _send(connection: ServerConnection, waiting: asyncio.Queue[str]) -> None:
    with suppress(ConnectionClosed):
        while True:
            await connection.send(await waiting.get())


class Guest:
    """A program that talks: its messages are answered, and told of, under the `id` that they bear."""

    def __init__(self, conversation: Conversation, faces: tuple[str, ...], send: Send) -> None:
        self._conversation, self._faces, self._send = conversation, faces, send
        self._streams: dict[object, Stream] = {}
        self._leave: Callable[[], None] | None = None

    def take(self, data: str | bytes) -> None:
        """A message; what is wrong with it is answered."""
        message = _read(data)
        if isinstance(message, str):
            self._send({"refused": message})
            return
        kind = next(kind for kind in FORMS if kind in message)
        answer = partial(self._answer, message.get("id"))
        try:
            getattr(self, f"_{kind}")(message, answer)
        except Refused as fault:
            answer({"refused": [as_json(one) for one in fault.diagnostics]})

    def leave(self) -> None:
        """It is gone."""
        if self._leave is not None:
            self._leave()

    def _answer(self, name: object, answer: dict[str, object]) -> None:
        if isinstance(answer.get("refused"), list):
            found: Any = answer["refused"]
            answer = {**answer, "refused": [as_json(one) if isinstance(one, Diagnostic) else one for one in found]}
        self._send({"id": name, **answer})

    def _do(self, message: Mapping[str, Any], answer: Send) -> None:
        speaks = self._conversation.tell(message["do"], answer, now=message.get("now", False))
        answer({"taken": True, "speaks": speaks})

    def _stream(self, message: Mapping[str, Any], answer: Send) -> None:
        name = message.get("id")
        stream = self._streams.get(name)
        if stream is None:
            if len(self._streams) >= MOST_STREAMS:
                answer({"refused": f"at most {MOST_STREAMS} texts come in pieces at a time"})
                return
            stream = self._streams[name] = Stream(self._conversation, self._face(message), answer)
            answer({"taken": True, "speaks": True})
        stream.take(message["stream"], message.get("over", False))
        if stream.closed:
            del self._streams[name]

    def _face(self, message: Mapping[str, Any]) -> str:
        return message.get("face") or (self._faces[0] if len(self._faces) == 1 else "")

    def _interrupt(self, message: Mapping[str, Any], answer: Send) -> None:
        face = message["interrupt"]
        for stream in self._streams.values():
            if face in ("", stream.face):
                stream.deaf = True
        self._conversation.interrupt(*([face] if face else []))
        answer({"taken": True})

    def _ask(self, message: Mapping[str, Any], answer: Send) -> None:
        answer({"speaking": self._conversation.speaking(), "waiting": self._conversation.waiting()})

    def _listen(self, message: Mapping[str, Any], answer: Send) -> None:
        if self._leave is None:
            self._leave = self._conversation.listen(lambda mark: self._send({"mark": mark}))
        answer({"taken": True})


class Stream:
    """A text that comes in pieces, and is said sentence by sentence as they are complete. Its signs are themselves. It
    is over when all that it said is; once interrupted it is `deaf`."""

    def __init__(self, conversation: Conversation, face: str, answer: Send) -> None:
        self._conversation, self.face, self._answer = conversation, face, answer
        self._sentences = Sentences()
        self._open, self._whole = 0, True
        self.deaf = self.closed = False

    def take(self, piece: str, over: bool) -> None:
        """More of it. Raises `Refused`."""
        found = list(self._sentences.take(piece))
        if over:
            self.closed = True
            found += self._sentences.rest()
        for sentence in () if self.deaf else found:
            self._say(sentence)
        self._end()

    def _say(self, sentence: str) -> None:
        try:
            self._conversation.tell(f"{f'{self.face}: ' if self.face else ''}say {quoted(sentence)}", self._told)
        except Refused:
            self.deaf = True
            raise
        self._open += 1

    def _told(self, event: dict[str, object]) -> None:
        if "begun" in event:
            self._answer({"sentence": event["begun"], "time": event["time"]})
            return
        self._open -= 1
        self._whole = self._whole and "said" in event
        if "refused" in event:
            self._answer(event)
        self._end()

    def _end(self) -> None:
        if self.closed and not self._open:
            self._answer({"said" if self._whole and not self.deaf else "interrupted": ""})


def _read(data: str | bytes) -> dict[str, Any] | str:
    """A message, or why it is none."""
    try:
        message = json.loads(data)
    except (ValueError, RecursionError):
        return f"it is no JSON; {FORM}"
    kinds = [kind for kind in FORMS if kind in message] if isinstance(message, dict) else []
    if len(kinds) != 1 or not isinstance(message.get("id"), str | int | None) or len(str(message.get("id"))) > 100:
        return FORM
    rest = {name: value for name, value in message.items() if name not in (kinds[0], "id")}
    fits = all(name in FORMS[kinds[0]] and isinstance(value, FORMS[kinds[0]][name]) for name, value in rest.items())
    return message if fits and isinstance(message[kinds[0]], str) else FORM
