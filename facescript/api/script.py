"""Calls to the text of a script: scenes built by a program, without text of the language but for places and sums."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from facescript.api.take import Take, loads
from facescript.resolve.words import FACE, FILM, MODIFIERS, VALUE, Modifier

Value = str | float | int | bool
"""A number is of the unit that belongs there: seconds, a share (0.6 is 60 %), times a minute, a count; text is taken as
it is written in the language, but in quotes where a file or a text belongs."""

INDENT = "    "


class Script:
    """A script that is written call by call.

    >>> from facescript import Script
    >>> script = Script(size="640x480", seed=3)
    >>> ada = script.face("ada", "woman", voice="en-gb female")
    >>> cup = script.target("cup", "at 25deg 10deg 2m")
    >>> ada.say("There is my *cup*!", as_="hello")
    >>> with script.at('hello."cup"'):
    ...     ada.look(cup, over=0.3, head=0.4)
    >>> print(script.text, end="")
    film 640x480, seed 3
    face ada = woman, voice en-gb female
    target cup at 25deg 10deg 2m
    ada: say "There is my *cup*!" as hello
    at hello."cup":
        ada: look at cup over 0.3s, head 40%
    >>> script.take().faces
    ('ada',)

    Modifiers are keywords, by the language's words (`docs/language.md`): an underscore stands for a blank, and behind a
    word that Python has kept for itself. `True` is for those without a value (`eyes_only=True`).
    """

    def __init__(self, **film: Value) -> None:
        self._lines: list[str] = []
        self._depth = 0
        if film:
            self.line("film " + ", ".join(_worded(FILM, name, value)[0] for name, value in film.items()))

    @property
    def text(self) -> str:
        """The script, as a `.face` file has it."""
        return "".join(line + "\n" for line in self._lines)

    def line(self, text: str) -> None:
        """A line as it is written in the language."""
        self._lines.append(INDENT * self._depth + text)

    def face(self, name: str, kind: str = "woman", **settings: Value) -> Actor:
        """A face of a kind, with what its definition may say."""
        words = [f"face {name} = {kind}", *(_worded(FACE, key, value)[0] for key, value in settings.items())]
        self.line(", ".join(words))
        return Actor(self, name)

    def target(self, name: str, place: str) -> str:
        """A target at a place: `at 25deg 10deg 2m`, `at -40cm -8cm 30cm`. Its name is what `look` takes."""
        self.line(f"target {name} {place}")
        return name

    def wait(self, seconds: float) -> None:
        self.line(f"wait {_number(seconds)}s")

    def scene(self, name: str, title: str = "") -> AbstractContextManager[None]:
        return _within(self, f"scene {name} {_quoted(title)}" if title else f"scene {name}")

    def together(self) -> AbstractContextManager[None]:
        """What is called inside begins at once."""
        return _within(self, "together")

    def in_turn(self) -> AbstractContextManager[None]:
        return _within(self, "in turn")

    def at(self, time: str | float) -> AbstractContextManager[None]:
        """At a moment: seconds, or as the language has it (`hello."cup" + 300ms`)."""
        return _within(self, f"at {time if isinstance(time, str) else f'{_number(time)}s'}")

    def repeat(self, how: str | int) -> AbstractContextManager[None]:
        """`4` times, or as the language has it."""
        return _within(self, f"repeat {how if isinstance(how, str) else f'{how} times'}")

    def take(self, folder: str | Path = ".", values: Mapping[str, str] | None = None, seed: int | None = None) -> Take:
        """A take of the script as it is now; files that it names lie in `folder`. Raises `ScriptFault`."""
        return loads(self.text, folder, values, seed)

    def _repr_html_(self) -> str:
        return self.take()._repr_html_()


class Actor:
    """A face of a script: what is called is done by it."""

    def __init__(self, script: Script, name: str) -> None:
        self._script, self.name = script, name

    def __str__(self) -> str:
        return self.name

    def do(self, words: str, **modifiers: Value) -> None:
        """A statement as it is written in the language, such as an action of a library: `do("greet(60%)")`."""
        closer = [_worded(MODIFIERS, name, value) for name, value in modifiers.items()]
        joined = [f"{' ' if direct else ', '}{text}" for text, direct in sorted(closer, key=lambda one: not one[1])]
        self._script.line(f"{self.name}: {words}{''.join(joined)}")

    def look(self, at: str | Actor, **modifiers: Value) -> None:
        """Turns the gaze there and stays on it."""
        self.do(f"look at {at}", **modifiers)

    def glance(self, at: str | Actor, **modifiers: Value) -> None:
        """Looks there and back."""
        self.do(f"glance {at}", **modifiers)

    def show(self, expression: str, **modifiers: Value) -> None:
        """Makes a sum of expressions and muscles the face's own: `smile 60% + brow.inner 20%`."""
        self.do(f"show {expression}", **modifiers)

    def add(self, expression: str, **modifiers: Value) -> None:
        """Lays a sum on top of what is shown."""
        self.do(f"add {expression}", **modifiers)

    def drop(self, name: str, **modifiers: Value) -> None:
        """Lets go of what was added, or of a statement by its name."""
        self.do(f"drop {name}", **modifiers)

    def say(self, text: str, **modifiers: Value) -> None:
        """Speaks a text; what stands in it in brackets is done, and `*word*` is stressed, as in the language."""
        self.do(f"say {_quoted(text)}", **modifiers)

    def nod(self, degree: float = 1.0, **modifiers: Value) -> None:
        self.do(f"nod {_share(degree)}", **modifiers)

    def shake(self, degree: float = 1.0, **modifiers: Value) -> None:
        self.do(f"shake {_share(degree)}", **modifiers)

    def blink(self, degree: float = 1.0, **modifiers: Value) -> None:
        self.do(f"blink {_share(degree)}", **modifiers)


@contextmanager
def _within(script: Script, head: str) -> Iterator[None]:
    """Lines inside of a block; one without any is left out, for the language has none."""
    script.line(f"{head}:")
    before, script._depth = len(script._lines), script._depth + 1
    try:
        yield
    finally:
        script._depth -= 1
        if len(script._lines) == before:
            script._lines.pop()


def _worded(table: Mapping[str, Modifier], name: str, value: Value) -> tuple[str, bool]:
    """A keyword and its value as the language has them, and whether they follow without a comma."""
    key = name.rstrip("_").replace("_", " ")
    row = table.get(key) or table.get(key.replace(" ", "-"))
    if row is None:
        raise TypeError(f"`{name}` is no word that belongs here: {', '.join(table)}")
    if (value is True) != (not row.takes):
        raise TypeError(f"`{name}` takes {'a ' + row.takes if row.takes else 'no value: `True`'}")
    said = _valued(row.takes, value)
    return " ".join(said if word == VALUE else word for word in row.pattern), row.direct


def _valued(kind: str, value: Value) -> str:
    if kind in ("file", "text"):
        return _quoted(str(value))
    if isinstance(value, str):
        return value
    units = {"time": "s", "rate": "/min", "frame rate": "fps", "angle": "deg", "length": "cm"}
    if kind in ("percentage", "screen"):
        return _share(value)
    return f"{_number(value)}{units.get(kind, '')}"


def _share(value: float) -> str:
    return f"{_number(100.0 * value)}%"


def _number(value: float) -> str:
    """A number as the language has it: without an exponent."""
    return f"{value:.6f}".rstrip("0").rstrip(".")


def _quoted(text: str) -> str:
    plain = re.sub(r"\s+", " ", text.replace("\\", "\\\\").replace('"', '\\"'))
    return f'"{plain}"'
