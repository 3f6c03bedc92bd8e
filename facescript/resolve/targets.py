"""`target` definitions to targets: fixed places, moving ones, crowds."""

from __future__ import annotations

from facescript.ir.play import Crowd, FixedTarget, MovingTarget, Target
from facescript.ir.values import PicturePlace, Point
from facescript.resolve.arithmetic import checked
from facescript.resolve.places import in_brackets, place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader, over, spelled
from facescript.resolve.scope import GLOBAL
from facescript.resolve.sums import primary
from facescript.resolve.tracks import track
from facescript.resolve.units import LARGEST, TIME, article
from facescript.syntax.tree import Declaration, Name, Phrase, String, Word
from facescript.syntax.tree import Point as PointWord
from facescript.text import Span

MOST_MEMBERS = 1_000
LOST = "lost"
"""The line between two keys of a moving target that nobody sees there."""

FORM = (
    "`target NAME at PLACE`, `target NAME moves` with keys below, `target NAME of (PLACE) (PLACE)`, or "
    '`target NAME from "track.csv"`'
)


def target(project: Project, node: Declaration) -> Target:
    """The target of a definition. Raises `Refused`."""
    phrase = node.phrases[0]
    opener = phrase.words[0] if phrase.words else None
    how = opener.text if isinstance(opener, Name) else ""
    if how == "moves":
        return _moving(project, node)
    _no_lines(project, node)
    if len(node.phrases) > 1:
        extra = node.phrases[1].span
        raise project.refuse("FS312", extra, text=extra.text, advice=f"it is written {FORM}")
    if how == "at":
        words = phrase.words[1:]
        found = place(project, Reader(words, GLOBAL, over(words) if words else phrase.span))
        return FixedTarget(node.name.text, found, node.span)
    if how == "of":
        return _crowd(project, node, phrase.words[1:])
    if how == "from":
        return _tracked(project, node, phrase.words[1:])
    span = opener.span if opener is not None else node.span
    raise project.refuse("FS312", span, text=span.text, advice=f"it is written {FORM}")


def _no_lines(project: Project, node: Declaration) -> None:
    if node.lines:
        span = _row_span(node.lines[0])
        raise project.refuse("FS312", span, text=span.text, advice="only a target that `moves` has lines below it")


def _row_span(row: tuple[Phrase, ...]) -> Span:
    return row[0].span.to(row[-1].span)


def _moving(project: Project, node: Declaration) -> MovingTarget:
    if len(node.phrases) > 1 or len(node.phrases[0].words) > 1:
        span = node.phrases[0].span.to(node.phrases[-1].span)
        raise project.refuse("FS312", span, text=span.text, advice="behind `moves` stand its keys, a line each, below")
    if not node.lines:
        raise project.refuse("FS332", node.span, name=node.name.text)
    times: list[float] = []
    places: list[Point] = []
    gaps: list[int] = []
    failed = False
    for row in node.lines:
        try:
            if _is_lost(row):
                gaps.append(len(times))
                continue
            time, point = _key(project, row)
            if times and time <= times[-1]:
                raise project.refuse("FS324", row[0].words[0].span, text=row[0].words[0].span.text)
            times.append(time)
            places.append(point)
        except Refused:
            failed = True
    if failed:
        raise Refused
    if not times:
        raise project.refuse("FS332", node.span, name=node.name.text)
    borders = (-LARGEST[TIME], *times, LARGEST[TIME])
    lost = tuple((borders[gap], borders[gap + 1]) for gap in dict.fromkeys(gaps))
    return MovingTarget(node.name.text, tuple(times), tuple(places), node.span, lost)


def _is_lost(row: tuple[Phrase, ...]) -> bool:
    """Whether a line says `lost`: nobody knows where the target is from the key before it to the key behind it."""
    words = row[0].words
    return len(row) == len(words) == 1 and isinstance(words[0], Name) and words[0].text == LOST


def _key(project: Project, row: tuple[Phrase, ...]) -> tuple[float, Point]:
    """A line `4s 80cm 10cm 2m`: a time and a place in the room."""
    span = _row_span(row)
    if len(row) > 1:
        raise project.refuse("FS312", row[1].span, text=row[1].span.text, advice="a key is a time and a place")
    reader = Reader(row[0].words, GLOBAL, span)
    time = checked(project, primary(project, reader), TIME, 0.0, draws=False)
    rest = reader.rest()
    found = place(project, Reader(rest, GLOBAL, over(rest) if rest else span))
    if isinstance(found, PicturePlace):
        raise project.refuse("FS330", over(rest), text=over(rest).text, forms="a place in the room, which can move")
    assert isinstance(time, float)
    return time, found


def _tracked(project: Project, node: Declaration, words: tuple[Word, ...]) -> MovingTarget:
    if len(words) != 1 or not isinstance(words[0], String):
        span = over(words) if words else node.phrases[0].span
        raise project.refuse("FS312", span, text=span.text, advice='a file stands behind `from`, as in "track.csv"')
    found = track(project, words[0])
    return MovingTarget(node.name.text, found.times, found.places, node.span, found.lost)


def _crowd(project: Project, node: Declaration, words: tuple[Word, ...]) -> Crowd:
    if not 1 <= len(words) <= MOST_MEMBERS:
        limits = f"1 to {MOST_MEMBERS} members"
        raise project.refuse("FS304", node.phrases[0].span, text=node.phrases[0].span.text, limits=limits)
    return Crowd(node.name.text, tuple(_member(project, word) for word in words), node.span)


def _member(project: Project, word: Word) -> Point | PicturePlace | str:
    if isinstance(word, PointWord):
        return in_brackets(project, word, GLOBAL)
    if not isinstance(word, Name):
        reader = Reader((word,), GLOBAL, word.span)
        raise project.refuse("FS312", word.span, text=reader.span.text, advice=f"it is written {FORM}")
    definition = project.names.find(spelled(word))
    if definition is None:
        raise project.unknown("FS202", word.text, project.names.known("target"), word.span)
    node = definition.node
    if definition.kind != "target" or _is_crowd(node):
        wanted = "one place or one target"
        kind = "a crowd" if definition.kind == "target" else article(definition.kind)
        raise project.refuse("FS214", word.span, name=word.text, kind=kind, wanted=wanted)
    return word.text


def _is_crowd(node: object) -> bool:
    if not isinstance(node, Declaration) or not node.phrases or not node.phrases[0].words:
        return False
    word = node.phrases[0].words[0]
    return isinstance(word, Name) and word.text == "of"
