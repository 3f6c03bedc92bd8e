"""The rules of time: when each statement starts, settles, and is done with all that stands beside it."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field

from facescript.ir.acts import At, Cue, Do, Repeat, Say, Verb, WaitUntil
from facescript.ir.values import Mark, Moment
from facescript.schedule.faults import Faults
from facescript.schedule.labels import Labels
from facescript.schedule.lengths import PAUSE, Lengths, sayings
from facescript.schedule.solver import Need, Rule
from facescript.schedule.steps import DONE, NEVER, SETTLED, START, Step, Time, after_line
from facescript.schedule.voices import CLOSE, Voices, ends_at, starts_at


@dataclass(slots=True)
class Times:
    """The rules for one round of the solution. `requests` are the lines of reactions, when they are due and when they
    start, `cut` the repeats that have not come to their end. Where there is a `horizon` no pass begins beyond it."""

    lengths: Lengths
    voices: Voices
    labels: Labels
    faults: Faults
    requests: list[tuple[Step, float, float]] = field(default_factory=list)
    cut: list[tuple[Step, float]] = field(default_factory=list)
    horizon: float = NEVER

    def rule(self, step: Step, edge: int) -> Rule | Time:
        if edge == START:
            return self._start(step)
        return self._settled(step) if edge == SETTLED else self._done(step)

    def circle(self, needs: list[Need]) -> None:
        self.faults.circle(needs)

    # -------------------------------------------------------------------------------------------- starts

    def _start(self, step: Step) -> Rule | Time:
        if isinstance(step.node, At):
            return self._moment(step, step.node.moment)
        if step.before is not None:
            need = step.before, SETTLED
        else:
            assert step.parent is not None
            need = step.parent, START
        known = need[0].times[need[1]]
        return self._following(step, need) if known is None else self._follows(step, known)

    def _following(self, step: Step, need: Need) -> Rule:
        return self._follows(step, (yield need))

    def _follows(self, step: Step, forerunner: Time) -> Time:
        """The start of a step, where what it follows has settled."""
        time, rough = forerunner
        if isinstance(step.node, Do) and isinstance(step.node.verb, Say):
            if after_line(step):
                time += PAUSE
            if step.root.reaction:
                due, time = time, max(time, self.lengths.facts.delays.get(step.key(), time))
                self.requests.append((step, due, time))
        return time, rough

    def _moment(self, step: Step, moment: Moment) -> Rule:
        """A time as it is written; NEVER where the seed has chosen another branch than the one it refers to."""
        if moment.mark is None:
            assert step.clock is not None
            time, rough = yield (step.clock, START)
        else:
            found = yield from self._mark(step, moment.mark)
            if found is None:
                step.quiet = True
                self.faults.not_chosen(step, moment.mark)
                return NEVER, False
            time, rough = found
        time += self.lengths.concrete.amount(moment.offset, step.place, "moment")
        if time < step.root.start - CLOSE:
            self.faults.before_start(step, time, rough)
            time = step.root.start
        return time, rough

    def _mark(self, step: Step, mark: Mark) -> Generator[Need, Time, Time | None]:
        target = yield from self.labels.find(step, mark.label)
        if target is None:
            return None
        if isinstance(target.node, Do) and isinstance(target.node.verb, Say):
            end = yield (target, SETTLED)
            return end if mark.edge == "end" and mark.word is None else self._said(target, mark)
        return (yield (target, SETTLED if mark.edge == "end" else START))

    def _said(self, line: Step, mark: Mark) -> Time:
        """The start of a line, or the start or end of one of its words, in its last saying."""
        assert isinstance(line.node, Do) and isinstance(line.node.verb, Say)
        say = line.node.verb
        start, rough = line.sayings[-1][0], line.rough(START)
        if mark.word is None:
            return start, rough
        word = self.voices.word(say, line.node.span, mark.word, mark.nth)
        return start + word[mark.edge == "end"], line.rough(SETTLED)

    # -------------------------------------------------------------------------------------------- settling

    def _settled(self, step: Step) -> Rule | Time:
        node = step.node
        if isinstance(node, Repeat):
            return self._passes(step, node)
        if not isinstance(node, Do):
            return self._all_done(step)
        if isinstance(node.verb, WaitUntil):
            return self._wait(step, node.verb.moment)
        known = step.times[START]
        return self._settling(step, node.verb) if known is None else self._settles(step, node.verb, known)

    def _all_done(self, step: Step) -> Rule:
        return (yield (step, DONE))

    def _settling(self, step: Step, verb: Verb) -> Rule:
        return self._settles(step, verb, (yield (step, START)))

    def _settles(self, step: Step, verb: Verb, start: Time) -> Time:
        """When an act that starts then has settled."""
        if isinstance(verb, Say):
            return self._line(step, verb, *start)
        return start[0] + self.lengths.settle(step, verb), start[1]

    def _wait(self, step: Step, moment: Moment) -> Rule:
        start, rough = yield (step, START)
        time, rough_moment = yield from self._moment(step, moment)
        if step.quiet:
            return start, rough
        rough = rough or rough_moment
        if time < start - CLOSE:
            self.faults.past(step, time, start, rough)
        return max(start, time), rough

    def _line(self, step: Step, say: Say, start: float, rough: bool) -> Time:
        """When a line has settled; its sayings and their cues are made on the way."""
        assert isinstance(step.node, Do)
        step.verb = say
        spoken = self.voices.speak(say, step.node.span)
        holds = self.lengths.facts.holds.after(step.node.face or "", start, step.root.rank)
        step.sayings = sayings(start, spoken, step.limit, holds)
        rough = rough or spoken.estimated
        step.children = []
        if start < NEVER:
            for number, (begin, cut) in enumerate(step.sayings, step.begun.first if step.begun else 0):
                self._cues(step, say, number * len(say.cues), begin, NEVER if cut is None else cut, rough)
        return step.sayings[-1][0] + spoken.duration, rough

    def _cues(self, step: Step, say: Say, first: int, begin: float, cut: float, rough: bool) -> None:
        """Make the cues of one saying that come to be before it is cut; `first` is the index of the first."""
        assert step.children is not None
        for index, cue in enumerate(say.cues, first):
            start, until = self._cue(step, say, cue)
            if begin + start >= cut:
                continue
            child = step.child(cue.body, index)
            child.until, child.limit = min(step.until, begin + until), min(step.limit, cut)
            child.times[START] = (begin + start, rough)
            step.children.append(child)

    def _cue(self, step: Step, say: Say, cue: Cue) -> tuple[float, float]:
        """Seconds from the line's start to a cue and to its end."""
        if cue.at is None:
            assert cue.word is not None
            return self.voices.word(say, step.node.span, cue.word, cue.nth)[0], NEVER
        spoken = self.voices.speak(say, step.node.span)
        start = starts_at(spoken, cue.at)
        if cue.until is None:
            return start, NEVER
        until = ends_at(spoken, cue.until)
        if until <= start:
            self.faults.empty_cue(cue)
        return start, until

    def _passes(self, step: Step, repeat: Repeat) -> Rule:
        start, rough = yield (step, START)
        limit, time, number = step.limit, start, 0
        end = NEVER
        if repeat.lasting is not None:
            end = start + self.lengths.concrete.amount(repeat.lasting, step.place, "lasting")
            limit = min(limit, end)
        if limit == NEVER and repeat.times is None and self.horizon == NEVER:
            self.faults.endless(step)
            return start, rough
        step.children = []
        if step.begun is not None:
            number, time = step.begun.first, step.begun.done
        while time < min(limit, self.horizon) and (repeat.times is None or number < repeat.times):
            number += 1
            entry = self._pass(step, repeat, number, limit)
            if entry.before is None and number > 1:
                entry.times[START] = (time, rough)
            before, (time, loose) = time, (yield (entry, SETTLED))
            rough = rough or loose
            if repeat.times is None and time <= before:
                self.faults.no_time(step)
                return start, rough
        if repeat.lasting is not None:
            return end, step.rough(START)
        if repeat.times is None:
            return NEVER, False
        if number < repeat.times:
            self.cut.append((step, time))
            if time < limit:
                return NEVER, False
        return time, rough

    def _pass(self, step: Step, repeat: Repeat, number: int, limit: float) -> Step:
        assert step.children is not None
        entry = step.child(repeat.body, number, step.children[-1] if step.children else None)
        entry.limit, entry.passes = limit, (*step.passes, number)
        entry.quiet = repeat.times is None
        step.children.append(entry)
        return entry

    # -------------------------------------------------------------------------------------------- all of it

    def _done(self, step: Step) -> Rule | Time:
        known = step.times[SETTLED]
        if known is not None and isinstance(step.node, Do) and not step.children:
            return known
        return self._all_inside(step)

    def _all_inside(self, step: Step) -> Rule:
        latest = yield (step, SETTLED if isinstance(step.node, (Do, Repeat)) else START)
        if step.begun is not None:
            latest = max(latest[0], step.begun.done), latest[1]
        if isinstance(step.node, At) and latest[0] == NEVER:
            return latest
        if isinstance(step.node, Repeat):
            return latest
        for child in step.inside():
            time, rough = yield (child, DONE)
            if isinstance(child.node, At) and time == NEVER and child.time(START) == NEVER:
                continue
            latest = max(latest[0], time), latest[1] or rough
        return (NEVER, False) if step.goes_on else latest
