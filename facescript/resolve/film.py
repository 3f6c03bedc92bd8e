"""`film` lines to what the outputs are like."""

from __future__ import annotations

from dataclasses import replace

from facescript.ir.play import Film
from facescript.resolve.lines import match, segments
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import over
from facescript.resolve.scope import GLOBAL
from facescript.resolve.suggest import nearest
from facescript.resolve.suggest import replace as written_as
from facescript.resolve.sums import number
from facescript.resolve.texts import bare_text
from facescript.resolve.units import COUNT, FRAMES, LENGTH, SHARE, TIME, UNITS
from facescript.resolve.words import FILM
from facescript.syntax.tree import Integer, Name, Quantity, Setting, Size, String, Word
from facescript.text import Span

SCREENS = {"patent": 1 / 3, "measured": 0.6, "none": 1.0}
SIDES = (16, 8192)
"""Smallest and largest width and height in pixels."""

RATES = (1.0, 1000.0)
"""Slowest and fastest, pictures a second; tables may be finer by `--fps`."""

LONGEST = 4 * 3600.0
"""Seconds of a film."""


def film(project: Project, settings: list[Setting]) -> Film:
    """The film that all `film` lines describe; each thing may be said once."""
    found = Film()
    seen: dict[str, Span] = {}
    for setting in settings:
        for phrase in setting.phrases:
            for words in segments(phrase.words):
                try:
                    found = _said(project, found, words, seen)
                except Refused:
                    continue
    return found


def _said(project: Project, found: Film, words: tuple[Word, ...], seen: dict[str, Span]) -> Film:
    span = over(words)
    name, value = _which(project, words, span)
    if name in seen:
        raise project.refuse("FS310", span, name=FILM[name].form)
    seen[name] = span
    if name == "size":
        return _sized(project, found, words[0])
    if name == "rate":
        rate = number(project, value, GLOBAL, FRAMES, span)
        return replace(found, fps=_within(project, rate, RATES, "1fps to 1000fps", span))
    if name == "seed":
        return replace(found, seed=_whole(project, value, span))
    if name == "long":
        long = number(project, value, GLOBAL, TIME, span, least=0.001)
        return replace(found, long=_within(project, long, (0.001, LONGEST), f"1ms to {LONGEST:g}s", span))
    if name == "screen":
        return replace(found, screen=_screen(project, value, span))
    if name == "title":
        return replace(found, title=_text(project, name, value, span))
    if name == "author":
        return replace(found, author=_text(project, name, value, span))
    return replace(found, wide_cm=number(project, value, GLOBAL, LENGTH, span, least=1.0))


def _which(project: Project, words: tuple[Word, ...], span: Span) -> tuple[str, tuple[Word, ...]]:
    """The setting that words are, and its value."""
    if len(words) == 1 and isinstance(words[0], Size):
        return "size", words
    if len(words) == 1 and isinstance(words[0], Quantity) and (words[0].unit == "fps" or words[0].unit not in UNITS):
        return "rate", words
    row, value = match(words, {name: row for name, row in FILM.items() if name not in ("size", "rate")})
    if row is not None:
        return row.name, value
    taken = ", ".join(f"`{row.form}`" for row in FILM.values())
    clause = f"; it takes {taken}."
    first = next((word for word in words if isinstance(word, Name)), None)
    candidate = nearest(first.text, ("seed", "long", "screen", "wide")) if first is not None else None
    if first is not None and candidate is not None:
        clause = f"; did you mean `{candidate}`?"
        raise project.refuse(
            "FS308", span, fixes=(written_as(first.span, candidate),), text=span.text, called="film", meant=clause
        )
    raise project.refuse("FS308", span, text=span.text, called="film", meant=clause)


def _sized(project: Project, found: Film, word: Word) -> Film:
    assert isinstance(word, Size)
    for side in (word.width, word.height):
        _within(project, side, SIDES, f"{SIDES[0]} to {SIDES[1]} pixels a side", word.span)
    return replace(found, width=word.width, height=word.height)


def _within(project: Project, value: float, limits: tuple[float, float], said: str, span: Span) -> float:
    if not limits[0] <= value <= limits[1]:
        raise project.refuse("FS304", span, text=span.text, limits=said)
    return value


def _whole(project: Project, words: tuple[Word, ...], span: Span) -> int:
    if len(words) == 1 and isinstance(words[0], Integer):
        return words[0].value
    value = number(project, words, GLOBAL, COUNT, span)
    if value != int(value):
        raise project.refuse("FS304", span, text=span.text, limits="whole numbers")
    return int(value)


def _text(project: Project, name: str, words: tuple[Word, ...], span: Span) -> str:
    if len(words) != 1 or not isinstance(words[0], String) or not bare_text(words[0]):
        raise project.refuse("FS312", span, text=span.text, advice=f'it is written `{name} "TEXT"`')
    return bare_text(words[0])


def _screen(project: Project, words: tuple[Word, ...], span: Span) -> float:
    if len(words) == 1 and isinstance(words[0], Name):
        name = words[0].text
        if name in SCREENS:
            return SCREENS[name]
        candidate = nearest(name, SCREENS)
        known = ", ".join(f"`{screen}`" for screen in SCREENS)
        clause = f"did you mean `{candidate}`?" if candidate else f"there are {known}, or a percentage."
        raise project.refuse("FS329", words[0].span, name=name, what="screen", meant=clause)
    fraction = number(project, words, GLOBAL, SHARE, span, least=0.01)
    return _within(project, fraction, (0.01, 1.0), "1% to 100%", span)
