"""Calls to the text of a script: scenes built by a program, without text of the language but for places and sums."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from facescript.api.take import Take, loads
from facescript.resolve.words import FACE, FILM
from facescript.writing.calls import Calls, Value, number, quoted, worded

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
            self.line("film " + ", ".join(worded(FILM, name, value)[0] for name, value in film.items()))

    @property
    def text(self) -> str:
        """The script, as a `.face` file has it."""
        return "".join(line + "\n" for line in self._lines)

    def line(self, text: str) -> None:
        """A line as it is written in the language."""
        self._lines.append(INDENT * self._depth + text)

    def face(self, name: str, kind: str = "woman", **settings: Value) -> Actor:
        """A face of a kind, with what its definition may say."""
        words = [f"face {name} = {kind}", *(worded(FACE, key, value)[0] for key, value in settings.items())]
        self.line(", ".join(words))
        return Actor(self, name)

    def target(self, name: str, place: str) -> str:
        """A target at a place: `at 25deg 10deg 2m`, `at -40cm -8cm 30cm`. Its name is what `look` takes."""
        self.line(f"target {name} {place}")
        return name

    def wait(self, seconds: float) -> None:
        self.line(f"wait {number(seconds)}s")

    def scene(self, name: str, title: str = "") -> AbstractContextManager[None]:
        return _within(self, f"scene {name} {quoted(title)}" if title else f"scene {name}")

    def together(self) -> AbstractContextManager[None]:
        """What is called inside begins at once."""
        return _within(self, "together")

    def in_turn(self) -> AbstractContextManager[None]:
        return _within(self, "in turn")

    def at(self, time: str | float) -> AbstractContextManager[None]:
        """At a moment: seconds, or as the language has it (`hello."cup" + 300ms`)."""
        return _within(self, f"at {time if isinstance(time, str) else f'{number(time)}s'}")

    def repeat(self, how: str | int) -> AbstractContextManager[None]:
        """`4` times, or as the language has it."""
        return _within(self, f"repeat {how if isinstance(how, str) else f'{how} times'}")

    def take(self, folder: str | Path = ".", values: Mapping[str, str] | None = None, seed: int | None = None) -> Take:
        """A take of the script as it is now; files that it names lie in `folder`. Raises `ScriptFault`."""
        return loads(self.text, folder, values, seed)

    def _repr_html_(self) -> str:
        return self.take()._repr_html_()


class Actor(Calls[None]):
    """A face of a script: what is called is done by it."""

    def __init__(self, script: Script, name: str) -> None:
        self._script, self.name = script, name

    def __str__(self) -> str:
        return self.name

    def statement(self, words: str) -> None:
        self._script.line(f"{self.name}: {words}")


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
