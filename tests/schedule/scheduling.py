"""Scripts to scores with a voice that says a word every 300 ms, so that times can be read off."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Say, Verb
from facescript.ir.wording import unspaced
from facescript.resolve.resolver import resolve
from facescript.schedule.scheduler import schedule
from facescript.schedule.score import Score
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

WORD = 0.3
"""Seconds a word; without spaces, a character."""


@dataclass(frozen=True, slots=True)
class Metronome:
    """A voice that says a word every 300 ms."""

    estimated: bool = False

    def speak(self, line: Say) -> Spoken:
        words = tuple(
            WordTime(line.text[first:last], first, last, round(WORD * number, 6), round(WORD * (number + 1), 6))
            for number, (first, last) in enumerate(stretches(line.text))
        )
        end = words[-1].end
        return Spoken(b"", 8000, end, words, (PhoneTime("a", 0.0, end),), self.estimated)


def stretches(text: str) -> list[tuple[int, int]]:
    """The words of a text, each without the signs around it."""
    found: list[list[int]] = []
    for at, sign in enumerate(text):
        if not sign.isalnum():
            continue
        if found and found[-1][1] == at and not unspaced(sign):
            found[-1][1] = at + 1
        else:
            found.append([at, at + 1])
    return [(first, last) for first, last in found]


@dataclass(frozen=True, slots=True)
class Scheduled:
    """A script's score and what there was to say about its times."""

    score: Score | None
    diagnostics: Diagnostics

    @property
    def solved(self) -> Score:
        assert self.score is not None, [item.message for item in self.diagnostics]
        return self.score

    @property
    def codes(self) -> list[str]:
        return [item.code for item in self.diagnostics if item.code.startswith("FS4")]

    def starts(self, kind: type[Verb]) -> list[float]:
        """The starts of the acts of one kind."""
        return [round(act.start, 6) for act in self.solved.acts if isinstance(act.verb, kind)]


def scheduled(text: str, estimated: bool = False) -> Scheduled:
    """A script by way of the parser and the resolver."""
    diagnostics = Diagnostics()
    source = Source("script.face", text)
    play = resolve(parse(source, diagnostics), World(Path(__file__).parent), diagnostics)
    assert play is not None, [item.message for item in diagnostics]
    return Scheduled(schedule(play, Metronome(estimated), diagnostics), diagnostics)
