"""The states of a script, one after another, to what the page is told: faults, score, frames and sound, in small steps.

`hear` takes what the page or the file says, `step` does a little of what is most urgent: an edit before all, then the
picture at the playhead, then what an author asked for, the sound, the lines that still wait for a voice, and the other
frames.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import cast

from facescript.backends.job import Job
from facescript.compile import Compiled, Settings
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic
from facescript.pictures import PictureFailure
from facescript.preview.curves import curves
from facescript.preview.faults import told
from facescript.preview.frames import Frames
from facescript.preview.hands import Hands
from facescript.preview.lanes import timeline
from facescript.preview.places import Units, carried
from facescript.preview.playhead import Stretch, moved, stretches
from facescript.preview.sound import Sound
from facescript.preview.voice import PatientVoice
from facescript.project import compile_any, is_play
from facescript.recompile import Recompiler
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.web.messages import Message, text
from facescript.world import ReadWorld, WorldFailure

ASKED = 64
"""Questions that wait, at most; the oldest are dropped."""


@dataclass(frozen=True, slots=True)
class Good:
    """The last state of the script that could be played."""

    version: int
    text: str
    stretches: list[Stretch]
    job: Job


class Session:
    """One script of a project, `name` its path there; sound goes into files of `folder`."""

    def __init__(self, root: Path, name: str, folder: Path) -> None:
        self._world, self._name = ReadWorld(root), name
        self._recompiler, self._voice = Recompiler(), PatientVoice(self._world, open_studio(self._world))
        self._drafts = Recompiler()
        self._hands: Hands | None = None
        self._frames, self._sound = Frames(), Sound(folder)
        self._text: tuple[int, str] | None = None
        self._read = 0, ""
        self._good: Good | None = None
        self._playhead = 0.0
        self._mixing: Iterator[bytes | None] | None = None
        self._asked: list[Message] = []
        self._fresh = False

    def hear(self, message: Message) -> None:
        """Takes a message of the page, or `text`: {version, text} of the script as it is now."""
        kind = message["kind"]
        if kind == "text":
            self._text = int(message["version"]), str(message["text"])  # type: ignore[call-overload]
        elif kind == "playhead":
            self._playhead = float(message["time"])  # type: ignore[arg-type]
            self._frames.came()
        else:
            waiting = [other for other in self._asked if not _is_draft(other) or not _is_draft(message)]
            self._asked = [*waiting, message][-ASKED:]

    @property
    def busy(self) -> bool:
        """Whether there is something to do."""
        waits = self._text or self._asked or self._mixing or self._voice.waiting
        return bool(waits) or self._frames.busy

    def step(self) -> Iterator[bytes]:
        """Does a little; what the page is told of it."""
        if self._text is not None:
            if self._text[1] == self._read[1]:
                self._recompiler = Recompiler()  # a file that the script uses is another: nothing is as it was
            self._read, self._text = self._text, None
            yield from self._compile()
        elif self._fresh:
            self._fresh = False
            yield from self._draw()
        elif self._asked:
            yield from self._answer(self._asked.pop(0))
        elif self._mixing is not None:
            yield from self._mix(self._mixing)
        elif self._voice.waiting:
            self._voice.catch_up()
            if not self._voice.waiting:
                yield from self._compile()
        else:
            yield from self._draw()

    def give_up(self) -> None:
        """Leaves what it was about: the fault would come again."""
        self._text, self._mixing, self._fresh = None, None, False
        self._asked.clear()
        self._voice.begin()
        self._frames.stop()

    def _compile(self) -> Iterator[bytes]:
        version, script = self._read
        source, units = Source(self._name, script), Units(script)
        self._voice.begin()
        self._hands = None
        compiled = self._compiled(source)
        yield text("used", files=sorted(self._world.names))
        yield text("diagnostics", version=version, items=told(self._faults(compiled), source, units))
        if compiled.score is None or compiled.play is None or compiled.score.duration <= 0:
            return
        score, before = compiled.score, self._good
        job = Job(compiled.play, score, self._world.read, 0.0, score.duration)
        self._good = Good(version, script, stretches(score, source), job)
        was, playhead = self._playhead, None
        if before is not None:
            playhead = moved(was, before.stretches, self._good.stretches, carried(before.text, script))
            self._playhead = playhead = min(playhead, score.duration)
        told_of = timeline(score, compiled.play, source, units)
        if not is_play(source):
            self._hands = Hands(version, compiled, cast(list[Message], told_of["acts"]), units, self._drafted)
            self._hands.give_handles()
        yield text("score", version=version, **told_of, playhead=playhead, was=was)
        yield from self._frames.show(job, version)
        self._mixing, self._fresh = self._sound.mix(score, version), True

    def _faults(self, compiled: Compiled) -> Iterator[Diagnostic]:
        """What the compiler says, and that a script of definitions alone cannot be played."""
        yield from compiled.diagnostics
        if compiled.score is not None and compiled.score.duration <= 0:
            yield diagnose("FS911", None, name=self._name)

    def _compiled(self, source: Source) -> Compiled:
        if is_play(source):
            return compile_any(source, self._world, self._voice.answers, Settings())
        return self._recompiler.compile(source, self._world, self._voice.answers).finished()

    def _drafted(self, source: Source) -> Compiled:
        """A text that may become the script's; what was compiled of the script stays as it is."""
        return self._drafts.compile(source, self._world, self._voice.answers).finished()

    def _draw(self) -> Iterator[bytes]:
        """A chunk; where a picture of the script cannot be read any more, the frames end."""
        try:
            yield from self._frames.draw(self._playhead)
        except (PictureFailure, WorldFailure):
            self._frames.stop()

    def _mix(self, mixing: Iterator[bytes | None]) -> Iterator[bytes]:
        for message in mixing:
            if message is not None:
                yield message
            return
        self._mixing = None

    def _answer(self, asked: Message) -> Iterator[bytes]:
        if self._good is not None and asked["kind"] == "curves":
            yield curves(self._good.job, self._good.version, asked)
        elif asked["kind"] == "drag":
            missing = text("refused", what="", why="the script has no times now: mend what is wrong with it first.")
            yield missing if self._hands is None else self._hands.answer(asked)


def _is_draft(message: Message) -> bool:
    """Whether a message asks what a drag would do: of several, the latest counts."""
    return message["kind"] == "drag" and not message["done"]
