"""A document to what may be played from: a lens over each scene and each named statement that has its time."""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.features.inlay_hints import short
from facescript.lsp.places import range_of
from facescript.lsp.played import played
from facescript.lsp.server import FaceServer
from facescript.lsp.walk import acts, name_of
from facescript.schedule.score import Score
from facescript.syntax import tree
from facescript.text import Span

PLAY = "facescript.play"
"""The client's command: the document's address, and the time in seconds to play from."""


def lenses(analysis: Analysis) -> list[types.CodeLens]:
    """In the order written; none where the script is not solved."""
    score = analysis.compiled.score
    if score is None:
        return []
    found = [*_scenes(analysis, score), *_named(analysis)]
    return [_lens(analysis, span, time) for span, time in sorted(found, key=lambda place: place[0].start)]


def _scenes(analysis: Analysis, score: Score) -> Iterator[tuple[Span, float]]:
    """Each scene's head; where there is none, the first statement."""
    starts = {scene.name: scene.start for scene in reversed(score.scenes)}
    items = analysis.compiled.script.items
    heads = [item for item in items if isinstance(item, tree.Scene)]
    for item in heads:
        if item.name.text in starts:
            yield item.name.span, starts[item.name.text]
    first = next(acts(items, 0, len(analysis.source.text)), None)
    if not heads and first is not None and name_of(first) is None:
        yield first.phrases[0].span, 0.0


def _named(analysis: Analysis) -> Iterator[tuple[Span, float]]:
    """Each named statement where it is first played."""
    end = len(analysis.source.text)
    found = played(analysis, 0, end)
    for act in acts(analysis.compiled.script.items, 0, end):
        name = name_of(act)
        place = act.span.start, act.span.end
        plays = [*found.acts.get(place, ()), *found.calls.get(place, ())] if found else []
        if name is not None and plays:
            yield act.phrases[0].span, min(one.start for one in plays)


def _lens(analysis: Analysis, span: Span, time: float) -> types.CodeLens:
    command = types.Command(f"▶ play from {short(time)} s", PLAY, arguments=[analysis.uri, round(time, 6)])
    return types.CodeLens(range_of(span), command)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_CODE_LENS)
    def asked(_: FaceServer, params: types.CodeLensParams) -> list[types.CodeLens]:
        return lenses(server.desk.analysis(params.text_document.uri))
