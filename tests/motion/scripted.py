"""Random scripts of one face, drawn by Hypothesis, and what is performed of them: statements of every kind at random
times, spoken by a voice that says a letter every 70 ms.

Lengths are those of people: a gesture takes from 350 ms on, and a channel of the head or of an eye goes no faster than
`HEAD_PACE` and `EYE_PACE` on average. What is at once is `over 0ms`, which only `cuts` draws.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from facescript.compile import compile_source
from facescript.ir.acts import Say
from facescript.motion.perform import FaceMotion
from facescript.performance.channels import INDEX
from facescript.schedule.score import Score
from facescript.speech.lines import words
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.text import Source
from facescript.world import World

Floats = NDArray[np.float64]

LETTER = 0.07
"""Seconds a letter."""

PHONES = {"y": "i", "c": "k", "x": "s", "q": "k", "h": "h", "j": "ʒ"}

LIVES = ("still", "calm", "reading", "conversation", "announcer")

HEAD = """film 640x360, seed {seed}, screen none
face ada = woman
    life {life}
    gaze {habit}
target lamp at 25deg 10deg 2m
target shelf at -40deg 15deg 3m
target floor at 10deg -35deg 1m
target cup at 10cm -12cm 40cm
target fly moves
    0s -60cm 10cm 2m
    2s  50cm -5cm 2m
    4s -10cm 20cm 1m
target crowd of (-60cm 0cm 2m) (0cm 5cm 2m) (50cm 10cm 2m)
scene main:
"""


class Letters:
    """A voice that says each letter for 70 ms, at the line's rate; a space is a short silence."""

    def speak(self, line: Say) -> Spoken:
        length = LETTER / line.voice.rate
        phones = [
            PhoneTime(PHONES.get(sign, sign) if sign.isalpha() else "", at * length, (at + 1) * length, sign in "aeiou")
            for at, sign in enumerate(line.text.lower())
        ]
        spoken = tuple(
            WordTime(line.text[word.first : word.last], word.first, word.last, word.first * length, word.last * length)
            for word in words(line.text)
        )
        return Spoken(b"", 8000, len(phones) * length, spoken, tuple(phones))


@dataclass(frozen=True)
class Played:
    """A script and the motion of its only face."""

    text: str
    score: Score

    @property
    def motion(self) -> FaceMotion:
        return FaceMotion(self.score, self.score.faces[0])

    def channels(self, times: Floats) -> dict[str, Floats]:
        return dict(zip(INDEX, self.motion.sample(times).T, strict=True))


def played(text: str) -> Played:
    """A script performed; it must have no errors."""
    compiled = compile_source(Source("made.face", text), World(Path(__file__).parent), Letters())
    assert compiled.score is not None, [item.message for item in compiled.diagnostics] + [text]
    return Played(text, compiled.score)


def script(lines: Sequence[str], life: str = "still", seed: int = 1, habit: str = "", length: float = 4.0) -> str:
    """The statements in one scene, those without `at` one after another."""
    head = HEAD.format(life=life, seed=seed, habit=habit)
    head = head.replace("    gaze \n", "")
    return head + "".join(f"    {line}\n" for line in (*lines, f"wait until {length:g}s"))


# ------------------------------------------------------------------------------------------------ words


def one_of(*words: str) -> st.SearchStrategy[str]:
    return st.sampled_from(words)


def maybe(phrase: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(st.just(""), phrase)


def joined(*parts: st.SearchStrategy[str] | str) -> st.SearchStrategy[str]:
    made = [st.just(part) if isinstance(part, str) else part for part in parts]
    return st.tuples(*made).map("".join)


def quantity(low: int, high: int, unit: str) -> st.SearchStrategy[str]:
    return st.integers(low, high).map(lambda number: f"{number}{unit}")


DEGREE = quantity(5, 100, "%")
EASE = one_of("", " ease smooth", " ease in", " ease out", " ease in-out")

EXPRESSIONS = one_of(
    "smile", "frown", "happiness", "sadness", "surprise", "anger", "fear", "disgust", "contempt", "inquisitive",
    "smile.left", "brows", "AU1", "AU4", "AU5", "AU6.right", "AU7", "AU12", "AU23", "AU24", "AU25", "AU27", "AU28",
    "AU43", "AU42", "brow.inner.left", "lip.press", "lip.pucker", "mouth.open", "mouth.jaw", "lid.left", "lid",
    "blink", "blink.right",
)  # fmt: skip

FACE_TERM = joined(EXPRESSIONS, " ", DEGREE)
FACE_SUM = st.one_of(FACE_TERM, joined(FACE_TERM, one_of(" + ", " - "), FACE_TERM))


@st.composite
def turns(draw: st.DrawFn) -> str:
    """An add on channels of the head or the eyes, however fast it is to be."""
    name = draw(one_of("head.yaw", "head.pitch", "head.roll", "eye.yaw", "eye.left.pitch", "eye.right.yaw"))
    angle = draw(st.integers(-25, 25).filter(bool))
    length = draw(st.integers(5, 1500))
    lasting = draw(maybe(joined(" for ", quantity(5, 1500, "ms"), " back in ", quantity(5, 1500, "ms"))))
    return f"add {name} {angle}deg over {length}ms{lasting}"


LENGTHS = st.one_of(
    joined(" over ", quantity(100, 1500, "ms")),
    joined(" for ", quantity(300, 2000, "ms"), maybe(joined(" back in ", quantity(150, 800, "ms")))),
    st.just(""),
)

SHOWS = joined("show ", FACE_SUM, LENGTHS, EASE)
ADDS = joined("add ", FACE_SUM, LENGTHS, EASE)
DROPS = joined(
    "drop ", one_of("smile", "frown", "AU4", "brows", "mouth.open"), maybe(joined(" over ", quantity(150, 900, "ms")))
)

NODS = joined("nod", maybe(joined(" ", DEGREE)), maybe(joined(" for ", quantity(20, 1500, "ms"))))
SHAKES = joined("shake", maybe(joined(" ", DEGREE)), maybe(joined(" for ", quantity(20, 1800, "ms"))))
TILTS = joined(
    "tilt ", one_of("left", "right"), maybe(joined(" ", DEGREE)), maybe(joined(" for ", quantity(20, 1500, "ms")))
)
MOVES = st.one_of(NODS, SHAKES, TILTS)
BLINKS = st.one_of(
    joined("blink", maybe(joined(" ", DEGREE)), maybe(joined(" for ", quantity(10, 600, "ms")))),
    joined("wink ", one_of("left", "right"), maybe(joined(" for ", quantity(10, 600, "ms")))),
)

STILL_AIMS = one_of("camera", "lamp", "shelf", "floor", "cup", "crowd.3")
AIMS = st.one_of(
    STILL_AIMS.map("at {}".format),
    one_of("at fly", "away"),
    joined(one_of("left ", "right "), quantity(5, 40, "deg")),
    joined(one_of("up ", "down "), quantity(3, 22, "deg")),
)
MANNER = st.one_of(
    st.just(""),
    one_of(", eyes only", ", head only", ", head then eyes", ", eyes then head"),
    joined(", head ", quantity(0, 100, "%")),
)
PACE = maybe(one_of(", speed 80%", ", speed 60%", ", speed 200%", ", latency 150ms"))
LASTS = st.one_of(st.just(""), joined(" over ", quantity(5, 1500, "ms")), joined(" for ", quantity(300, 1500, "ms")))
LOOKS = joined("look ", AIMS, LASTS, MANNER, PACE)
GLANCES = joined(
    "glance ", st.one_of(STILL_AIMS, st.just("fly")), maybe(joined(" for ", quantity(300, 900, "ms"))), MANNER
)
SCANS = joined("scan crowd, ", quantity(300, 900, "ms"), " each", one_of("", ", nearest first", ", at random"))
SPELLS = joined("life ", st.sampled_from(LIVES), maybe(joined(" over ", quantity(400, 1000, "ms"))))

GAZES = st.one_of(LOOKS, LOOKS, GLANCES, SCANS)
FACES = st.one_of(SHOWS, ADDS, ADDS, DROPS)
TEXTS = one_of("My baby has a map.", "Bob, a pump, maybe.", "Good evening, mom.", "We see you.", "Umbababa!")
STATEMENTS = st.one_of(GAZES, FACES, BLINKS, SPELLS)


@st.composite
def statements(draw: st.DrawFn, kinds: st.SearchStrategy[str] = STATEMENTS, most: int = 8, moves: int = 1) -> list[str]:
    """Statements at times of their own, no two at one; `moves` gestures of the head and channels that turn head or eyes
    at most: people do not shake their heads twice at a time."""
    found = draw(st.lists(kinds, max_size=most))
    if moves:
        found += draw(st.lists(st.one_of(MOVES, turns()), max_size=moves))
    starts = draw(st.lists(st.integers(0, 350), min_size=len(found), max_size=len(found), unique=True))
    return [f"at {start * 10}ms: {each}" for start, each in zip(starts, found, strict=True)]


@st.composite
def spoken(draw: st.DrawFn) -> list[str]:
    """Up to two lines that do not overlap, slow and fast."""
    rates = one_of("", ", rate 60%", ", rate 150%", ", rate 250%")
    firsts, gaps = st.integers(2, 30), st.integers(0, 150)
    lines = draw(st.lists(joined('say "', TEXTS, '"', rates), max_size=2))
    starts = [draw(firsts) * 10, 2600 + draw(gaps) * 10]
    return [f"at {start}ms: {line}" for start, line in zip(starts, lines, strict=False)]


@st.composite
def scripts(draw: st.DrawFn, kinds: st.SearchStrategy[str] = STATEMENTS, most: int = 8, moves: int = 1) -> str:
    """A script of `statements`, lines, a life and a habit of gaze."""
    lines = [*draw(statements(kinds, most, moves)), *draw(spoken())]
    life, seed = draw(st.sampled_from(LIVES)), draw(st.integers(0, 10_000))
    return script(lines, life, seed, draw(one_of("", "", "head-mover", "eye-mover")))
