"""An act to the statement that may be changed for it: one of this script, and played once."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from dataclasses import dataclass

from facescript.diagnostics.model import Diagnostics
from facescript.preview.dragging.amounts import Stuck
from facescript.preview.dragging.standing import Standing, standings
from facescript.resolve.lines import Words, match, segments
from facescript.resolve.words import MODIFIERS
from facescript.schedule.score import Score, TimedAct
from facescript.syntax import tree
from facescript.syntax.parser import parse_phrases
from facescript.text import Span

INLINE = frozenset(("look", "glance", "scan", "show", "add", "drop", "nod", "shake", "tilt", "blink", "wink"))
"""Verbs that a bracket in a text may begin with; without one it is an `add`."""


@dataclass(frozen=True, slots=True)
class Said:
    """A statement: its phrases, as `verb` reads them, and where it stands; None inside of a text."""

    script: tree.Script
    verb: str
    phrases: tuple[tree.Phrase, ...]
    standing: Standing | None

    def modifier(self, name: str) -> Words | None:
        """The words of a modifier's value; None where it is not written."""
        row = {name: MODIFIERS[name]}
        for number, phrase in enumerate(self.phrases):
            for place, words in enumerate(segments(phrase.words)):
                found, value = match(words, row) if number or place else (None, ())
                if found is not None:
                    return value
        return None

    def behind(self) -> int:
        """Where a modifier that follows directly may be added: behind those of the first phrase, before its name."""
        parts = segments(self.phrases[0].words)
        named = isinstance(parts[-1][0], tree.Name) and parts[-1][0].text == "as"
        return parts[-2 if named else -1][-1].span.end


class Allowed:
    """The statements of a script that has a score."""

    def __init__(self, script: tree.Script, score: Score) -> None:
        self._script = script
        self._plays = Counter(_place(act.span) for act in score.acts)
        self._standings = standings(script)
        self._places = sorted(self._standings)

    def said(self, act: TimedAct) -> Said:
        """What an act's statement says. Raises `Stuck` where it may not be changed."""
        if act.span.source.name != self._script.source.name:
            raise Stuck(f"it is written in {act.span.source.name}: open that script to change it.")
        standing = self._standings.get(_place(act.span))
        line = standing or self._around(act.span)
        if line is None:
            raise Stuck("it stands before the scenes, and holds from their first moment.")
        if any(isinstance(level.block, tree.Repeat) for level in line.levels):
            raise Stuck("it stands in a `repeat`: each of its passes would change.")
        count = self._plays[_place(act.span)]
        if count > 1:
            raise Stuck(f"its line is played {count} times, and all of them would change.")
        return self._bracket(act.span) if standing is None else self._line(standing)

    def _line(self, standing: Standing) -> Said:
        phrases = standing.act.phrases
        return Said(self._script, phrases[0].words[0].span.text, phrases, standing)

    def _bracket(self, span: Span) -> Said:
        """A statement inside of a text."""
        inner = Span(self._script.source, span.start + 1, span.end - 1)
        phrases = parse_phrases(inner, Diagnostics()) if span.text.startswith("[") else None
        if not phrases:
            raise Stuck("it stands in a text that is read from elsewhere.")
        verb = phrases[0].words[0].span.text
        return Said(self._script, verb if verb in INLINE else "add", phrases, None)

    def _around(self, span: Span) -> Standing | None:
        """The line of speech that a bracket stands in."""
        index = bisect_right(self._places, (span.start, span.end)) - 1
        while index >= 0 and self._places[index][1] < span.end:
            index -= 1
        return self._standings[self._places[index]] if index >= 0 else None


def _place(span: Span) -> tuple[int, int]:
    return span.start, span.end
