"""A run of a play: what happens goes in, and what its faces do comes out, frame by frame."""

from __future__ import annotations

from dataclasses import replace
from math import ceil, inf, nextafter

import numpy as np

from facescript.ir.play import Play
from facescript.live.model import Frame, Happening, Layout, Mark, Sighting, Utterance
from facescript.live.run.company import Company
from facescript.live.run.curves import FaceCurves
from facescript.live.run.telling import Marks, Utterances, of_event
from facescript.motion.drivers import Floats
from facescript.motion.perform import FaceMotion, Memories, perform
from facescript.schedule.onwards import Onwards, Told, lines_of, nothing
from facescript.schedule.score import Score
from facescript.schedule.steps import TooMany
from facescript.speech.model import VoiceBox

STEP, STEPS = 2.0, 3
"""The horizon moves every so many seconds, and lies so many steps beyond the one that a time is in: life foresees a
line by two seconds and a half."""

LATELY = 4.0
"""Seconds after which what is over is forgotten: by then it has come to rest."""

BLOCK = 6
"""So many frames are worked out at once: numpy takes for one nearly as long as for six."""

CERTAIN = 0.1
"""But not more than so many seconds ahead: further on it hangs on what is still to be seen how somebody is followed."""

CLOSE = 1e-9
"""Seconds within which an event is at a frame's time."""


class Run:
    """A play that goes on until nobody asks for frames any more.

    Frames are asked for in rising order; some may be skipped. What comes out is a function of the play, `fps`, and
    what was heard and seen at which times: neither a clock nor chance has a part in it. Raises `VoiceFailure` where the
    first lines cannot be spoken.
    """

    def __init__(self, play: Play, voice: VoiceBox, fps: float = 60.0, told: Told = nothing) -> None:
        self._fps = fps
        self._onwards = Onwards(play, voice, told)
        self._company = Company(self._onwards)
        self._shift = inf
        self._speak(play)
        self._time, self._solved, self._missed = 0.0, 0.0, 0
        self._waiting: list[Happening] = []
        self._heeded: list[Mark] = []
        self._marks, self._utterances = Marks(), Utterances()
        self.score = self._onwards.solve(STEPS * STEP)
        performance = perform(self.score)
        self._seen = {face.name: face for face in play.faces if face.seen}
        self._memories: dict[str, Memories] = {name: {} for name in self._seen}
        self._curves: dict[str, FaceCurves] = {}
        self._curves = {name: FaceCurves(self._motion(self.score, name)) for name in self._seen}
        self._columns = performance.columns
        self.layout = Layout(
            fps, tuple(self._seen), performance.names, performance.channels, play.film.title, play.film.seed
        )
        self._block: tuple[int, Floats] = (0, np.empty((0, len(self.layout.names))))

    def _speak(self, play: Play) -> None:
        """Have every line of the play spoken, so that none is waited for when it is due."""
        for line, span in lines_of(play):
            self._onwards.voices.speak(line, span)

    def _motion(self, score: Score, name: str) -> FaceMotion:
        before = self._curves[name].motion if name in self._curves else None
        return FaceMotion(score, self._seen[name], self._memories[name], before)

    # ------------------------------------------------------------------------------------------------ what goes in

    def hear(self, event: Happening) -> None:
        """Something happens at a time of the run, s; before the last frame's time is at it. No person bears the name of
        a crowd."""
        if not self._company.takes(event.person):
            return
        event = replace(event, time=max(event.time, self._time))
        self._waiting.append(event)
        self._waiting.sort(key=lambda one: one.time)

    def see(self, sighting: Sighting) -> None:
        """Somebody is at a place at a time of the run; frames from the next one on know of it."""
        self._company.see(sighting)

    def doubts(self) -> dict[str, int]:
        """The sightings that were not believed and the moments that could not be solved, and why."""
        missed = {"moments of more statements than can be solved": self._missed} if self._missed else {}
        return {**self._company.doubts(), **missed}

    # ------------------------------------------------------------------------------------------------ what comes out

    def frame(self, number: int) -> Frame:
        """The frame of a number, which is not below that of the last."""
        time = number / self._fps
        self._advance(time)
        self._time = time
        return Frame(number, time, self._row(number))

    def marks(self, time: float) -> list[Mark]:
        """What began since the last call up to a time, the last frame's at most."""
        heeded = [mark for mark in self._heeded if mark.time <= time]
        self._heeded = [mark for mark in self._heeded if mark.time > time]
        return self._marks.tell(self.score, heeded, time)

    def utterances(self, time: float) -> list[Utterance]:
        """The lines that are about to sound at a time, the last frame's at most, and those that break off."""
        return self._utterances.tell(self.score, time)

    # ------------------------------------------------------------------------------------------------ how it goes on

    def _advance(self, time: float) -> None:
        """Take in all that happens up to a time, each in its turn."""
        if self._company.pass_to(time):
            self._solve(nextafter(self._time, inf))
        while True:
            step = (self._solved // STEP + 1.0) * STEP
            event = self._waiting[0].time if self._waiting else inf
            if min(step, event) > time + CLOSE and self._shift > time and not self._nearest(time):
                return
            if event <= min(step, self._shift):
                self._take(self._number(event))
            elif self._shift < step:
                self._solve(self._shift)
            else:
                self._solved = step
                self._forget(step - LATELY)
                self._solve(min(step, self._number(step) / self._fps))
                self._company.forget(self.score)

    def _nearest(self, time: float) -> bool:
        """Whether another is nearest now, as happens like any event."""
        event = self._company.nearest(self.score, time)
        if event is not None:
            self.hear(event)
        return event is not None

    def _number(self, time: float) -> int:
        """The number of the first frame that shows what happens at a time."""
        return ceil(time * self._fps - CLOSE)

    def _take(self, number: int) -> None:
        """Heed the events that one frame is the first to show, at once."""
        now = [event for event in self._waiting if self._number(event.time) == number]
        self._waiting = self._waiting[len(now) :]
        for event in now:
            self._company.hear(event)
        heeded = [self._onwards.heed(event) for event in now]
        self._heeded += (of_event(event) for event, waited in zip(now, heeded, strict=True) if waited)
        if any(heeded) or any(event.person for event in now):
            self._solve(min(now[0].time, number / self._fps))

    def _forget(self, time: float) -> None:
        """What is over by a time is not worked out again."""
        gone = self._onwards.forget(time)
        for name, memories in self._memories.items():
            lines = [line for line in gone.lines if line.face == name]
            acts = [act for act in gone.acts if act.face == name]
            over = {(line.start, id(line.spoken)) for line in lines}
            said = (line for line in self.score.lines if line.face == name)
            first = min((line.start for line in said if (line.start, id(line.spoken)) not in over), default=np.inf)
            if gone.scene in memories:
                memories[gone.scene] = memories[gone.scene].pass_to(time, lines, acts, first)

    def _solve(self, time: float) -> None:
        """Go on from a time by what is known now."""
        self._company.meet()
        try:
            self.score = self._onwards.solve((self._solved // STEP + STEPS) * STEP)
        except TooMany:
            self._missed += 1
            return
        for name, curves in self._curves.items():
            curves.turn(time, self._motion(self.score, name))
        scenes = {(scene.name, scene.again) for scene in self.score.scenes}
        for memories in self._memories.values():
            for key in [key for key in memories if key not in scenes]:
                del memories[key]
        self._shift = self._company.next_shift(self.score, time)
        self._block = (0, self._block[1][:0])

    # ------------------------------------------------------------------------------------------------ frames

    def _row(self, number: int) -> Floats:
        first, rows = self._block
        if not first <= number < first + len(rows):
            first, rows = number, self._sample(number)
            self._block = first, rows
        row: Floats = rows[number - first]
        return row

    def _sample(self, number: int) -> Floats:
        """The frames from one to the end of its block."""
        block = max(1, min(BLOCK, int(CERTAIN * self._fps)))
        last = (number // block + 1) * block
        times = np.arange(number, last) / self._fps
        found = [curves.sample(times)[:, self._columns[name]] for name, curves in self._curves.items()]
        return np.concatenate(found, axis=1) if found else np.empty((len(times), 0))
