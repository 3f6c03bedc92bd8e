"""A definition of a kind of face to the kind as data. A fault in one of its rows is reported and the row left out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress

from facescript.ir.acts import Voice
from facescript.ir.kind import Kind, KindHead, KindJaw, KindShape, Measures, Pull, Shade, Tint
from facescript.performance.channels import PARTS
from facescript.resolve.kinds.checks import check
from facescript.resolve.kinds.moves import pull, shade
from facescript.resolve.kinds.row import Row, Words, spelled
from facescript.resolve.kinds.shapes import shape
from facescript.resolve.kinds.words import AMOUNTS, EYE, LOOKS, MOUTH, ROWS, TINTED
from facescript.resolve.lines import Line
from facescript.resolve.project import Project, Refused
from facescript.resolve.scope import GLOBAL
from facescript.resolve.speech import spoken_with, voice_named
from facescript.resolve.words import FACE
from facescript.syntax.tree import Colour, Declaration, Phrase, Word

HEADER = "kind NAME = eyes 116 apart, at 360 318"


def kind(project: Project, node: Declaration) -> Kind:
    """The kind of a definition. Raises `Refused` where something is missing without which nothing can be drawn."""
    return _read(project, node).kind()


def head(project: Project, node: Declaration) -> KindHead:
    """What a face may choose of the kind of a definition, of which the rows of shapes may be missing."""
    return _read(project, node).head()


def _read(project: Project, node: Declaration) -> _Reader:
    reader = _Reader(project, node)
    for phrases in node.lines:
        with suppress(Refused):
            reader.take(phrases)
    return reader


class _Reader:
    """What the rows of a kind have said so far."""

    def __init__(self, project: Project, node: Declaration) -> None:
        self.project, self.node = project, node
        header = Row(project, node.phrases, HEADER)
        self.distance = _header(header, node.phrases[0], ("eyes", 1, "apart"))[0]
        _positive(header, self.distance)
        x, y = _header(header, node.phrases[-1], ("at", 2, ""))
        self.eyes_at = x, y
        self.colours: dict[str, str] = {}
        self.measures: dict[str, tuple[float, ...]] = {}
        self.outline: tuple[tuple[float, float], ...] = ()
        self.locks: tuple[tuple[float, float], ...] = ()
        self.points: dict[str, tuple[float, float]] = {}
        self.eyes: list[Measures] = []
        self.mouth: Measures | None = None
        self.jaw = KindJaw()
        self.voice: Voice | None = None
        self.channels: list[str] = []
        self.looks: dict[str, tuple[str, ...]] = {}
        self.amounts: dict[str, float] = {}
        self.tints: dict[str, tuple[Tint, ...]] = {}
        self.shapes: list[KindShape] = []
        self.pulls: list[Pull] = []
        self.shades: list[Shade] = []
        self.spoilt = False

    def take(self, phrases: tuple[Phrase, ...]) -> None:
        """One row."""
        first = phrases[0].words[0]
        name = spelled(first)
        if name not in ROWS:
            self.spoilt = True
            clause, fixes = self.project.meant(name, ROWS, first.span)
            raise self.project.refuse("FS240", first.span, fixes=fixes, name=first.span.text, meant=clause)
        row = Row(self.project, phrases, ROWS[name])
        reading: Mapping[str, Callable[[Row], None]] = {
            "voice": self._voice, "has": self._has, "colours": self._colours, "outline": self._outline,
            "jaw": self._jaw, "eye": self._eye, "mouth": self._mouth, "point": self._point, "locks": self._locks,
            "look": self._look, "tints": self._tints, "amount": self._amount, "shape": self._shape,
            "muscle": self._muscle, "shade": self._shade, "nose": self._nose,
        }  # fmt: skip
        try:
            reading.get(name, self._pair)(row)
        except Refused:
            self.spoilt = True
            raise

    # -------------------------------------------------------------------------------------------- rows

    def _pair(self, row: Row) -> None:
        words = row.phrases[0].words
        self.measures[spelled(words[0])] = row.numbers(words[1:], 2, row.span)
        _positive(row, *self.measures[spelled(words[0])])

    def _nose(self, row: Row) -> None:
        base = _header(row, Phrase(row.phrases[0].words[1:], row.phrases[0].span), ("base", 1, ""))
        width = _header(row, row.phrases[-1], ("width", 1, ""))
        self.measures["nose"] = (*base, *width)

    def _jaw(self, row: Row) -> None:
        start = _header(row, Phrase(row.phrases[0].words[1:], row.phrases[0].span), ("from", 1, ""))
        self.jaw = KindJaw(start[0], _header(row, row.phrases[-1], ("drop", 1, ""))[0])
        _positive(row, self.jaw.drop)

    def _voice(self, row: Row) -> None:
        line = Line(self.project, "face", (Phrase((), row.span), *row.phrases), FACE, GLOBAL)
        self.voice = spoken_with(voice_named(self.project, line.parts["voice"], line.spans["voice"]), line)

    def _has(self, row: Row) -> None:
        for words in _list(row):
            self.channels.append(row.name(row.one(words, row.span), "part with a channel of its own", PARTS))

    def _colours(self, row: Row) -> None:
        for words in _list(row):
            if len(words) != 2 or not isinstance(words[1], Colour):
                raise row.refuse(row.span)
            self.colours[row.name(words[0], "colour")] = words[1].text.lower()[:7]

    def _outline(self, row: Row) -> None:
        spots = row.spots(row.phrases[0].words[1:], 2, row.span)
        self.outline = tuple((spot.numbers[0], spot.numbers[1]) for spot in spots)

    def _locks(self, row: Row) -> None:
        self.locks = tuple(row.pair(word) for word in row.phrases[0].words[1:])

    def _point(self, row: Row) -> None:
        for words in _list(row):
            if len(words) != 2:
                raise row.refuse(row.span)
            self.points[row.name(words[0], "point")] = row.pair(words[1])

    def _look(self, row: Row) -> None:
        name, first = _named(row)
        words = [row.one(each, row.span) for each in (first, *(phrase.words for phrase in row.phrases[1:]))]
        self.looks[row.name(name, "look", LOOKS)] = tuple(row.name(word, "choice") for word in words)

    def _tints(self, row: Row) -> None:
        family, first = _named(row)
        items = [first, *(phrase.words for phrase in row.phrases[1:])]
        self.tints[row.name(family, "family of colours", TINTED)] = tuple(_tint(row, item) for item in items)

    def _amount(self, row: Row) -> None:
        words = row.phrases[0].words
        if len(words) != 3:
            raise row.refuse(row.span)
        self.amounts[row.name(words[1], "amount", AMOUNTS)] = row.share(words[2])

    def _eye(self, row: Row) -> None:
        words = row.phrases[0].words
        name, at = "", (0.0, 0.0)
        if len(words) == 4 and spelled(words[2]) == "at":
            name, at = row.name(words[1], "eye"), row.pair(words[3])
            row.phrases = (Phrase((), row.span), *row.phrases[1:])
        self.eyes.append(Measures(_measures(row, EYE), name, at))

    def _mouth(self, row: Row) -> None:
        self.mouth = Measures(_measures(row, MOUTH))

    def _shape(self, row: Row) -> None:
        self.shapes.append(shape(row, self.colours, self.looks))

    def _muscle(self, row: Row) -> None:
        self.pulls.append(pull(row, self.amounts))

    def _shade(self, row: Row) -> None:
        self.shades.append(shade(row, self.amounts))

    # -------------------------------------------------------------------------------------------- the whole

    def head(self) -> KindHead:
        """What a face may choose of it."""
        families = dict.fromkeys(name.partition(".")[0] for name in self.colours)
        tints = tuple(self.tints.items())
        looks, amounts = tuple(self.looks.items()), tuple(self.amounts.items())
        return KindHead(self.voice, tuple(self.channels), looks, amounts, tuple(families), tints)

    def kind(self) -> Kind:
        """The kind, if everything it needs is there."""
        name = self.node.name
        there = {"outline": self.outline, "eye": self.eyes, "mouth": self.mouth, **self.measures}
        for row in ("outline", "shell", "nose", "eye", "mouth"):
            if not there.get(row) and not self.spoilt:
                raise self.project.refuse("FS244", name.span, what=f"line `{row}`", name=name.text, form=ROWS[row])
        if self.spoilt or self.mouth is None:
            raise Refused
        shell, nose = self.measures["shell"], self.measures["nose"]
        made = Kind(
            name.text, self.distance, self.eyes_at, self.outline, (shell[0], shell[1]), (nose[0], nose[1]),
            tuple(self.eyes), self.mouth, tuple(self.shapes), tuple(self.pulls), tuple(self.shades),
            tuple(self.colours.items()), name.span, self.jaw, self.head(),
            tuple(self.points.items()), self.locks,
        )  # fmt: skip
        check(self.project, made)
        return made


def _positive(row: Row, *values: float) -> None:
    """Refuses a length that is none."""
    if min(values) <= 0.0:
        raise row.refuse(row.span)


def _header(row: Row, phrase: Phrase, form: tuple[str, int, str]) -> tuple[float, ...]:
    """The numbers of a clause `WORD NUMBERS WORD`."""
    first, count, last = form
    words = phrase.words
    tail = words[-1:] if last else ()
    if not words or spelled(words[0]) != first or (last and spelled(words[-1]) != last):
        raise row.refuse(phrase.span)
    return row.numbers(words[1 : len(words) - len(tail)], count, phrase.span)


def _list(row: Row) -> list[Words]:
    """The items of a row that is a list, the first behind its first word."""
    return [row.phrases[0].words[1:], *(phrase.words for phrase in row.phrases[1:])]


def _named(row: Row) -> tuple[Word, Words]:
    """The name behind a row's first word, and the words after it."""
    words = row.phrases[0].words
    if len(words) < 2:
        raise row.refuse(row.span)
    return words[1], words[2:]


def _tint(row: Row, words: Words) -> Tint:
    """`blond #d8b36a`, `blond #d8b36a with pale fair`."""
    if len(words) < 2 or not isinstance(words[1], Colour) or (len(words) > 2 and spelled(words[2]) != "with"):
        raise row.refuse(row.span)
    goes = tuple(row.name(word, "skin") for word in words[3:])
    return Tint(row.name(words[0], "colour"), words[1].text.lower()[:7], goes)


def _measures(row: Row, known: Mapping[str, tuple[int, bool]]) -> tuple[tuple[str, tuple[float, ...]], ...]:
    """Measures by name, all that are needed among them."""
    found = []
    for words in _list(row):
        if not words:
            continue
        name = row.name(words[0], "measure", known)
        found.append((name, row.numbers(words[1:], known[name][0], row.span)))
    missing = [name for name, (_, needed) in known.items() if needed and name not in dict(found)]
    if missing:
        what = ", ".join(f"`{name}`" for name in missing)
        raise row.project.refuse("FS244", row.span, what=what, name=spelled(row.phrases[0].words[0]), form=row.form)
    _positive(row, *(dict(found)[name][0] for name in ("half-width", "iris") if name in known))
    return tuple(found)
