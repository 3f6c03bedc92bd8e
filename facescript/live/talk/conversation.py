"""Statements that programs tell to events of a run: what speaks waits its turn, all else is done at once."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from math import inf

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic, Diagnostics
from facescript.ir.acts import Say
from facescript.live.model import Frame, Happening, Layout, Mark, Teller, Utterance
from facescript.live.talk.prompting import Prompting, says
from facescript.resolve.told import HUSHED, TOLD
from facescript.schedule.lengths import PAUSE
from facescript.speech.model import VoiceBox, VoiceFailure
from facescript.text import Source, Span

MOST = 100
"""Statements that wait their turn."""

PATIENCE = 1.0
"""Seconds for which a line that was told may not begin; then it is thought to be lost."""

Told = Callable[[dict[str, object]], None]
"""Who is told what became of a statement."""


class Refused(Exception):
    """What was told cannot be done: its diagnostics say why."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__("; ".join(one.message for one in diagnostics))
        self.diagnostics = tuple(diagnostics)


@dataclass(slots=True, eq=False)
class Turn:
    """Statements that speak, from when they are told to when they are over. `lines` are those that are still to begin,
    each with its face; `ends` when those that have begun do, by the numbers of their utterances."""

    text: str
    says: Sequence[tuple[str, Say]]
    told: Told
    spoken: Future[None]
    lines: list[tuple[str, str]]
    ends: dict[int, float] = field(default_factory=dict)
    since: float = inf
    broken: bool = False
    hushed: bool = False

    @property
    def plain(self) -> str:
        """What it says."""
        return " ".join(say.text for _, say in self.says)

    @property
    def faces(self) -> frozenset[str]:
        return frozenset(face for face, _ in self.says)

    @property
    def end(self) -> float:
        """When its last line is over; inf while that is not known."""
        return inf if self.lines or not self.ends else max(self.ends.values())

    def takes(self, utterance: Utterance) -> bool:
        """Whether an utterance is a line of it; it is noted when that is over."""
        line = utterance.face, utterance.text
        if utterance.number not in self.ends:
            if line not in self.lines and not (self.broken and line in [(face, say.text) for face, say in self.says]):
                return False
            if line in self.lines:
                self.lines.remove(line)
        self.broken = utterance.cut is not None
        self.ends[utterance.number] = _end(utterance)
        return True

    def over(self, time: float) -> bool:
        """Whether it is over; a line that another reaction broke off is begun again after it."""
        if self.broken and not self.hushed:
            return time > max(self.ends.values()) + 30.0
        lost = not self.ends and time > self.since + PATIENCE
        return lost or time >= self.end or (self.hushed and bool(self.ends) and time >= max(self.ends.values()))


class Conversation:
    """What is told to a run's faces, and a source and a sink of the run for it. All is called in the run's event loop.

    Statements that speak with a face that is speaking, or that has others waiting, wait; the pause between two is that
    of two lines of a script. What they say is spoken by `voice` in a thread of its own while they wait.
    """

    def __init__(self, prompting: Prompting, voice: VoiceBox, fps: float) -> None:
        self._prompting, self._voice = prompting, voice
        self._teller: Teller | None = None
        self._waiting: list[Turn] = []
        self._current: list[Turn] = []
        self._ears: list[Told] = []
        self._time, self._frame = 0.0, 1.0 / fps
        self._silent: dict[str, float] = {}
        self._counts = {"told": 0, "refused": 0, "answers dropped": 0}
        self._mouth = ThreadPoolExecutor(1, "voice")

    # ------------------------------------------------------------------------------------------------ what is told

    def tell(self, text: str, told: Told, *, now: bool = False) -> bool:
        """Does statements of the language; whether they speak. Then `told` gets `{"begun": ...}`, and at last
        `{"said": ...}` or `{"interrupted": ...}`, with what they say and the time of the run. With `now` they break off
        what their faces are saying, and what waits. Raises `Refused`."""
        diagnostics = Diagnostics()
        reaction = self._prompting.prompter.reaction(text, diagnostics)
        if reaction is None:
            raise self._refused(list(diagnostics))
        self._counts["told"] += 1
        lines = says(reaction.body)
        if not lines:
            why = self._event(Happening(TOLD, 0.0, text))
            if why is not None:
                raise self._refused([diagnose("FS995", reaction.span, reason=why)])
            return False
        faces = {face for face, _ in lines}
        if now:
            self.interrupt(*faces)
        if len(self._waiting) >= MOST:
            raise self._refused([diagnose("FS993", reaction.span, most=MOST)])
        spoken = self._mouth.submit(self._speak, [say for _, say in lines])
        turn = Turn(text, lines, told, spoken, [(face, say.text) for face, say in lines])
        self._waiting.append(turn)
        loop = asyncio.get_running_loop()
        spoken.add_done_callback(lambda _: _soon(loop, self._go_on))
        return True

    def interrupt(self, *faces: str) -> None:
        """What the faces say, all if none is named, breaks off at the end of its word, though not before it has begun;
        what waits is dropped."""
        for turn in [one for one in self._waiting if not faces or one.faces & set(faces)]:
            self._waiting.remove(turn)
            self._over(turn, "interrupted")
        for turn in self._current:
            if not turn.hushed and (not faces or turn.faces & set(faces)):
                whys = [self._event(Happening(HUSHED, turn.since, face)) for face in sorted(turn.faces)]
                turn.hushed = not any(whys)

    def speaking(self) -> dict[str, str]:
        """What each face is saying that is saying something, by its name."""
        return {face: one.plain for one in self._current for face in one.faces if one.ends}

    def waiting(self) -> int:
        """How many statements wait their turn."""
        return len(self._waiting)

    def listen(self, told: Told) -> Callable[[], None]:
        """Tells of all that begins: words, events that were heeded, acts. Ends when what it gives is called."""
        self._ears.append(told)
        return lambda: self._ears.remove(told)

    def unread(self) -> None:
        """A program does not read what it is told: an answer to it was dropped."""
        self._counts["answers dropped"] += 1

    def _refused(self, diagnostics: list[Diagnostic]) -> Refused:
        self._counts["refused"] += 1
        return Refused(diagnostics)

    def _speak(self, lines: list[Say]) -> None:
        for line in lines:
            self._voice.speak(line)

    # ------------------------------------------------------------------------------------------------ whose turn it is

    def _go_on(self) -> None:
        """Begins with all whose turn it is."""
        busy = dict(self._silent)
        for turn in self._current:
            for face in turn.faces:
                busy[face] = max(busy.get(face, 0.0), turn.end)
        for turn in tuple(self._waiting):
            free = max(busy.get(face, -PAUSE) for face in turn.faces)
            if free + PAUSE <= self._time + self._frame and turn.spoken.done():
                self._waiting.remove(turn)
                self._begin(turn, free + PAUSE)
            busy.update(dict.fromkeys(turn.faces, inf))

    def _begin(self, turn: Turn, time: float) -> None:
        failure = turn.spoken.exception()
        if isinstance(failure, VoiceFailure):
            whole = Span(Source("told", turn.text), 0, len(turn.text))
            turn.told({"refused": [diagnose(failure.code, whole, reason=failure.args[0])]})
            return
        if failure is not None:
            raise failure
        why = self._event(Happening(TOLD, max(time, 0.0), turn.text))
        if why is not None:
            self._over(turn, "interrupted")
            return
        turn.since = max(time, self._time)
        self._current.append(turn)

    def _event(self, happening: Happening) -> str | None:
        return None if self._teller is None else self._teller.event(happening)

    def _over(self, turn: Turn, how: str) -> None:
        turn.told({how: turn.plain, "time": round(self._time, 3)})

    # ------------------------------------------------------------------------------------------------ source and sink

    async def run(self, teller: Teller) -> None:
        self._teller = teller
        await asyncio.Event().wait()

    async def open(self, layout: Layout) -> None:
        """Nothing is to be begun."""

    def frame(self, frame: Frame) -> None:
        self._time = frame.time
        for turn in [one for one in self._current if one.over(frame.time)]:
            self._current.remove(turn)
            said = turn.end < inf and not turn.broken
            if said:
                self._silent.update(dict.fromkeys(turn.faces, turn.end))
            self._over(turn, "said" if said else "interrupted")
        self._go_on()

    def mark(self, mark: Mark) -> None:
        if self._ears and not (mark.kind == "event" and mark.text.startswith((TOLD, HUSHED))):
            said: dict[str, object] = {mark.kind: mark.text, "face": mark.face, "label": mark.label}
            said["time"] = round(mark.time, 3)
            for ear in tuple(self._ears):
                ear(said)

    def utter(self, utterance: Utterance) -> None:
        for turn in self._current:
            begins = not turn.ends
            if turn.takes(utterance):
                if begins:
                    turn.told({"begun": turn.plain, "time": round(utterance.start, 3)})
                return

    async def close(self) -> None:
        self._mouth.shutdown(wait=False, cancel_futures=True)

    def counts(self) -> dict[str, int]:
        return dict(self._counts)


def _end(utterance: Utterance) -> float:
    return utterance.start + utterance.spoken.duration if utterance.cut is None else utterance.cut


def _soon(loop: asyncio.AbstractEventLoop, act: Callable[[], None]) -> None:
    """Later in the loop's own thread; never where the loop has ended."""
    with suppress(RuntimeError):
        loop.call_soon_threadsafe(act)
