"""Turns the acts and lines of a face in a scene into what its life heeds: turns, pauses, gaze shifts, busy eyes.

Each has a place that names it by what the author wrote: a turn by the text of its first line and which of that text it
is, a pause by its line and its number there, a gaze shift by its act. Draws are made by places, so a line that is put
in elsewhere shifts what comes later and redraws nothing.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import zip_longest
from zlib import crc32

from facescript.ir.acts import Glance, Look, Scan
from facescript.motion.life.stretches import Stretches
from facescript.schedule.score import TimedAct, TimedLine
from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.model import Spoken
from facescript.speech.sound.accents import stretches

TURN_GAP = 1.0
"""Seconds of silence that make a new turn."""

PAUSE = 0.12
"""Seconds of silence inside a line that make a pause; shorter ones are closures of the consonants."""

Place = tuple[object, ...]
"""What something of a scene is called in draws."""


@dataclass(frozen=True, slots=True)
class Turn:
    """A stretch of speech with no silence of `TURN_GAP` in it, seconds."""

    start: float
    end: float
    place: Place


@dataclass(frozen=True, slots=True)
class Pause:
    """When a face's speech comes to a pause, seconds."""

    start: float
    place: Place


@dataclass(frozen=True, slots=True)
class Shift:
    """A gaze shift that eyes and head set off to at `start` (s), of `amplitude` deg."""

    start: float
    amplitude: float
    place: Place


@dataclass(frozen=True, slots=True)
class Earlier:
    """What a face did in its scene before the acts and lines that are told of: how often it said which text, made which
    shift of gaze and had which life, and the turn that it was in."""

    said: Counter[str] = field(default_factory=Counter)
    shifted: Counter[str] = field(default_factory=Counter)
    lived: Counter[str] = field(default_factory=Counter)
    turn: Turn | None = None


FIRST = Earlier()
"""Nothing was before."""


class Occasions:
    """What the lives of one face in one scene heed; every question is about a part of the scene (seconds)."""

    def __init__(self, acts: Sequence[TimedAct], lines: Sequence[TimedLine], earlier: Earlier = FIRST) -> None:
        self._earlier = earlier.turn
        self._named = named = tuple(_named(lines, earlier.said))
        self._turns = tuple(_turns(named, earlier.turn))
        self._pauses = tuple(_pauses(named))
        self._shifts = sorted(_shifts(acts, earlier.shifted), key=lambda shift: shift.start)
        self.moving = Stretches((plan.starts, max(plan.landed, plan.head_done)) for act in acts for plan in act.plan)
        """When eyes or head go where the script sends them."""
        self.busy = Stretches((*self.moving, *_taken(acts)))
        """When the script has the eyes to itself: then, and in looks with `for`, glances and scans."""

    def lines(self, start: float, end: float) -> Iterator[tuple[TimedLine, Place]]:
        """The lines that sound between `start` and `end`: their text and how often it was said before names them."""
        return ((line, place) for line, place in self._named if line.start < end and line.end > start)

    def turns(self, start: float, end: float) -> Sequence[Turn]:
        """The turns to speak that have a part between `start` and `end`."""
        low = bisect_right(self._turns, start, key=lambda turn: turn.end)
        return self._turns[low : bisect_left(self._turns, end, key=lambda turn: turn.start)]

    def turn_before(self, time: float) -> Turn | None:
        """The turn that a line from a time on might go on with, as far as it came before that."""
        past = [(line, place) for line, place in self._named if line.start < time]
        turns = list(_turns(past, self._earlier))
        return turns[-1] if turns else None

    def pauses(self, start: float, end: float) -> Sequence[Pause]:
        """The pauses that begin in a part."""
        low, high = (bisect_left(self._pauses, time, key=lambda pause: pause.start) for time in (start, end))
        return self._pauses[low:high]

    def shifts(self, start: float, end: float) -> Sequence[Shift]:
        """The gaze shifts that begin in a part."""
        low, high = (bisect_left(self._shifts, time, key=lambda shift: shift.start) for time in (start, end))
        return self._shifts[low:high]


def _named(lines: Iterable[TimedLine], before: Counter[str]) -> Iterator[tuple[TimedLine, Place]]:
    """Every line with its text and how often that was said before."""
    said = Counter(before)
    for line in lines:
        text = text_of(line)
        yield line, (text, said[text])
        said[text] += 1


def text_of(line: TimedLine) -> str:
    """What a line is called in draws; a recording without words by its sound."""
    return " ".join(word.text for word in line.spoken.words) or f"{crc32(line.spoken.pcm):x}"


def _turns(named: Iterable[tuple[TimedLine, Place]], turn: Turn | None) -> Iterator[Turn]:
    """The turns of the lines, the first of which may go on with one."""
    for line, place in named:
        if turn is not None and line.start - turn.end < TURN_GAP:
            turn = Turn(turn.start, max(turn.end, line.end), turn.place)
            continue
        if turn is not None:
            yield turn
        turn = Turn(line.start, line.end, place)
    if turn is not None:
        yield turn


def _pauses(named: Iterable[tuple[TimedLine, Place]]) -> Iterator[Pause]:
    """Inside the lines and at their ends."""
    for line, place in named:
        for number, (_, ended) in enumerate(speech(line)):
            yield Pause(ended, (*place, number))


def speech(line: TimedLine) -> Iterator[tuple[float, float]]:
    """Where a line sounds, seconds from the film's start: stretches without a pause in them."""
    begun = ended = None
    for first, last in _sounding(line.spoken):
        first, last = line.start + first, min(line.start + last, line.end)
        if first >= line.end:
            break
        if begun is None or ended is None:
            begun = first
        elif first - ended >= PAUSE:
            yield begun, ended
            begun = first
        ended = last
    if begun is not None and ended is not None:
        yield begun, ended


def _sounding(spoken: Spoken) -> Sequence[tuple[float, float]]:
    """Where a line sounds, s from its start: by its phones, else by its words, else by ear. A shape of Mandarin is held
    for a part of its syllable only, which sounds until another begins or a silence is told of."""
    found = []
    for phone, after in zip_longest(spoken.phones, spoken.phones[1:]):
        if phone.symbol:
            found.append((phone.start, after.start if after and phone.symbol.startswith(PREFIX) else phone.end))
    return found or [(word.start, word.end) for word in spoken.words] or stretches(spoken)


def shift_name(act: TimedAct) -> str:
    """What an act of gaze is called in draws."""
    return f"{type(act.verb).__name__} {act.plan[0].aim!r}"


def _shifts(acts: Iterable[TimedAct], before: Counter[str]) -> Iterator[Shift]:
    """The shifts of gaze that take time: a jump `over 0ms` is none."""
    done = Counter(before)
    for act in acts:
        if not act.plan:
            continue
        name = shift_name(act)
        for number, plan in enumerate(act.plan):
            if not plan.instant:
                yield Shift(plan.starts, plan.amplitude, (name, done[name], number))
        done[name] += 1


def _taken(acts: Iterable[TimedAct]) -> Iterator[tuple[float, float]]:
    for act in acts:
        if isinstance(act.verb, (Glance, Scan)) or (isinstance(act.verb, Look) and act.verb.timing.lasting is not None):
            yield act.start, act.end
