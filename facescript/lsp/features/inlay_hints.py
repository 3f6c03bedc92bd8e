"""A document to the times that are shown in it: from when until when each statement is played, how long a line is."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass

from lsprotocol import types

from facescript.ir.acts import Say, SetBackground, SetLife, View
from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, position
from facescript.lsp.played import Played, played
from facescript.lsp.server import FaceServer
from facescript.lsp.walk import acts, between
from facescript.schedule.phrases import phrase
from facescript.schedule.score import FOREVER, TimedAct, TimedBlock, TimedLine, TimedScene
from facescript.syntax import tree

MOST_STARTS = 12
"""Plays of one statement that its tooltip tells one by one."""

SET_BEFORE = {SetBackground: "background", View: "view", SetLife: "life"}
"""What a scene is given before it begins stands for no line in it, unless a line says so."""


@dataclass(frozen=True, slots=True)
class Times:
    """One play of a statement."""

    start: float
    settled: float
    about: bool = False
    about_end: bool = False

    @property
    def text(self) -> str:
        first = ("~" if self.about else "") + short(self.start)
        last = ("~" if self.about_end else "") + short(self.settled)
        return f"{first} s" if first == last else f"{first} → {last} s"


def inlay_hints(analysis: Analysis, where: types.Range) -> list[types.InlayHint]:
    """Those of the lines of a range, each at its line's end; none where the script is not solved."""
    source = analysis.source
    start = offset(source, types.Position(where.start.line, 0))
    end = offset(source, where.end)
    found = played(analysis, start, end)
    if found is None:
        return []
    hints = [*_scenes(analysis, start, end), *_Hints(analysis, found).of(start, end)]
    return [hint for hint in hints if where.start.line <= hint.position.line <= where.end.line]


def short(seconds: float) -> str:
    """`2.3`: a time to a hundredth of a second."""
    return f"{seconds:.2f}".rstrip("0").rstrip(".")


def _scenes(analysis: Analysis, start: int, end: int) -> Iterator[types.InlayHint]:
    score = analysis.compiled.score
    timed: dict[str, TimedScene] = {}
    for scene in reversed(score.scenes if score else ()):
        timed[scene.name] = scene
    for node in between(analysis.compiled.script.items, start, end):
        if isinstance(node, tree.Scene) and node.name.text in timed:
            scene = timed[node.name.text]
            label = Times(scene.start, scene.end).text
            yield _hint(analysis, node.name.span.end, label, "the scene, from its first moment to its last")


class _Hints:
    """Makes the hints of statements out of what is played."""

    def __init__(self, analysis: Analysis, found: Played) -> None:
        self.analysis, self.found = analysis, found
        self.places = sorted(found.acts)

    def of(self, start: int, end: int) -> Iterator[types.InlayHint]:
        for act in acts(self.analysis.compiled.script.items, start, end):
            hint = self.hint(act)
            if hint is not None:
                yield hint

    def hint(self, act: tree.Act) -> types.InlayHint | None:
        place = act.span.start, act.span.end
        done = [one for one in self.found.acts.get(place, ()) if _stands_for(one, act)]
        lines = self.found.lines.get(place, [])
        plays = [_times(one, lines) for one in done] or [_block(one) for one in self.found.calls.get(place, ())]
        if not plays:
            return None
        label = plays[0].text
        if lines:
            label += f" ({_length(lines[0])})"
        if len(plays) > 1:
            label += f", first of {len(plays)}"
        told = [*_told(done[0] if done else None, plays[0]), *self.cues(act), *_again(plays)]
        return _hint(self.analysis, act.phrases[-1].span.end, label, "\n\n".join(told))

    def cues(self, act: tree.Act) -> Iterator[str]:
        """What is done on the words of a line, as it is first played."""
        texts = [word.span for word in act.phrases[0].words if isinstance(word, tree.String)]
        for span in (*texts, *(more.span for more in act.more)):
            first = bisect_left(self.places, (span.start, 0))
            for place in self.places[first : bisect_left(self.places, (span.end, 0))]:
                done = self.found.acts[place][0]
                yield f"`{phrase(done.verb)}` {_times(done, []).text}"


def _stands_for(done: TimedAct, act: tree.Act) -> bool:
    word = SET_BEFORE.get(type(done.verb))
    first = act.phrases[0].words[0]
    return word is None or (isinstance(first, tree.Name) and first.text == word)


def _times(done: TimedAct, lines: list[TimedLine]) -> Times:
    about_end = done.estimated or (isinstance(done.verb, Say) and any(line.spoken.estimated for line in lines))
    return Times(done.start, done.settled, done.estimated, about_end)


def _block(block: TimedBlock) -> Times:
    return Times(block.start, block.settled, block.estimated, block.estimated)


def _length(line: TimedLine) -> str:
    return f"{'~' if line.spoken.estimated else ''}{short(line.end - line.start)} s"


def _told(done: TimedAct | None, first: Times) -> Iterator[str]:
    """All times of an act, to a millisecond."""
    yield f"starts at {first.start:.3f} s"
    if done is not None and done.plan:
        shift = done.plan[0]
        if shift.uses_eyes:
            yield f"the eyes leave at {shift.eye_onset:.3f} s and are there at {shift.landed:.3f} s"
        if shift.uses_head and shift.head_done > shift.head_onset:
            yield f"the head leaves at {shift.head_onset:.3f} s and is there at {shift.head_done:.3f} s"
    yield f"has settled at {first.settled:.3f} s, when the next statement may start"
    if done is not None and done.released == FOREVER:
        yield "lasts until something takes its place, or the scene ends"
    elif done is not None and done.end > done.settled:
        yield f"lets go at {done.released:.3f} s" + (f", gone at {done.end:.3f} s" if done.end < FOREVER else "")
    if first.about_end:
        yield "`~`: it rests on a line that no voice has spoken yet; a build has the true times"


def _again(plays: list[Times]) -> Iterator[str]:
    if len(plays) > 1:
        starts = ", ".join(short(one.start) for one in plays[:MOST_STARTS])
        more = f" and {len(plays) - MOST_STARTS} more" if len(plays) > MOST_STARTS else ""
        yield f"played {len(plays)} times, at {starts} s{more}"


def _hint(analysis: Analysis, at: int, label: str, told: str) -> types.InlayHint:
    """A hint at the end of the line that an offset is in."""
    source = analysis.source
    line, column = source.position(at)
    end = at - column + 1 + len(source.line(line).rstrip())
    tooltip = types.MarkupContent(types.MarkupKind.Markdown, told)
    return types.InlayHint(position(source, end), label, tooltip=tooltip, padding_left=True)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    def asked(_: FaceServer, params: types.InlayHintParams) -> list[types.InlayHint]:
        return inlay_hints(server.desk.analysis(params.text_document.uri), params.range)
