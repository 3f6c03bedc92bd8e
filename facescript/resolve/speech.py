"""`say` to an act: its text, its voice, its files; and voices as faces have them."""

from __future__ import annotations

import re
from dataclasses import replace

from facescript.ir.acts import Say, Voice
from facescript.resolve.files import project_path
from facescript.resolve.lines import Line
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader
from facescript.resolve.scope import GLOBAL, Scope, expand, inside
from facescript.resolve.sums import left_over
from facescript.resolve.texts import Inline, pieces_of, read_text
from facescript.resolve.units import SHARE
from facescript.speech.voices.registry import ENGINES
from facescript.syntax.tree import Dotted, Name, String, Word
from facescript.text import Source, Span
from facescript.world import WorldFailure

_LANGUAGE = re.compile(r"[a-z]{2,3}(-[a-z0-9]{1,8})*")
_VARIANT = re.compile(r"[A-Za-z][\w-]*")

SLOWEST = 0.1
"""The smallest `rate` or `pitch` factor."""


def say(project: Project, line: Line, place: Place, more: tuple[String, ...]) -> tuple[Say, tuple[Inline, ...]]:
    """A spoken line and the statements between its brackets, which still have to be read. Raises `Refused`."""
    reader = line.reader()
    reader.next()
    recording, times = _named(project, line, "from"), _named(project, line, "timed")
    if reader.word("ssml"):
        return _ssml(project, line, reader, place, more, recording, times), ()
    pieces, scope = _pieces(project, reader, more, recording is not None)
    line.finish(reader)
    voice = spoken_with(_voice_of(project, place), line)
    if recording is not None or times is not None:
        _as_it_was(project, line)
    if not pieces:
        return Say("", voice, recording=recording, times=times), ()
    text = read_text(project, pieces, scope, line.span)
    return Say(text.plain, voice, text.stretches, recording=recording, times=times), text.inlines


def _ssml(
    project: Project,
    line: Line,
    reader: Reader,
    place: Place,
    more: tuple[String, ...],
    recording: str | None,
    times: str | None,
) -> Say:
    """A line whose text is a file of SSML. Raises `Refused`."""
    from facescript.resolve.ssml import read_ssml  # a parser of XML: only lines with SSML pay it

    source = _file(project, reader, "ssml").source
    _nothing_more(project, more)
    line.finish(reader)
    voice = spoken_with(_voice_of(project, place), line)
    recorded = recording is not None or times is not None
    if recorded:
        _as_it_was(project, line)
    found = read_ssml(project, source, line.span, recorded)
    if found.language and _primary(found.language) != _primary(voice.language):
        project.report("FS519", line.span, written=found.language, voice=voice.language)
    manner = found.manner
    voice = replace(
        voice, rate=voice.rate * manner.rate, pitch=voice.pitch * manner.pitch, volume=voice.volume * manner.volume
    )
    return Say(found.text.plain, voice, found.text.stretches, recording=recording, times=times)


def _primary(language: str) -> str:
    """The language without its country; Chinese is Mandarin, whatever it is called."""
    first = language.lower().replace("_", "-").split("-")[0]
    return "cmn" if first == "zh" else first


def _voice_of(project: Project, place: Place) -> Voice:
    return project.faces[place.face].voice if place.face in project.faces else Voice()


def _nothing_more(project: Project, more: tuple[String, ...]) -> None:
    for string in more:
        project.report("FS312", string.span, text=string.span.text, advice="the line's text stands elsewhere")


def _named(project: Project, line: Line, modifier: str) -> str | None:
    """The file of the project that `from` or `timed` names, None where the line has none. Raises `Refused`."""
    words = line.parts.get(modifier)
    if words is None:
        return None
    if len(words) != 1 or not isinstance(words[0], String):
        span = line.spans[modifier]
        raise project.refuse("FS312", span, text=span.text, advice=f'it is written `{modifier} "FILE"`')
    return _path(project, words[0])


def _path(project: Project, word: String) -> str:
    """The path in the project of a file that is there. Raises `Refused`."""
    path = project_path(word.span, word.value)
    try:
        found = project.world_of(path).path(path).is_file()
    except WorldFailure as failure:
        raise project.refuse("FS701", word.span, path=word.value, reason=failure.args[0]) from None
    if not found:
        raise project.refuse("FS701", word.span, path=word.value, reason="there is no such file")
    return path


def _as_it_was(project: Project, line: Line) -> None:
    """A recording is heard as it was spoken: its rate and melody are not for the script to say."""
    for name in ("rate", "pitch", "range"):
        if name in line.parts:
            project.report("FS506", line.spans[name], name=name)


def _pieces(
    project: Project, reader: Reader, more: tuple[String, ...], recorded: bool
) -> tuple[tuple[Span, ...], Scope]:
    """The text of a line, and the scope that it was written in: a parameter's is the caller's. Raises `Refused`."""
    found = _elsewhere(project, reader)
    if found is not None:
        _nothing_more(project, more)
        return found
    strings = []
    while isinstance(word := reader.peek(), String):
        strings.append(word)
        reader.next()
    if not strings and not recorded:
        raise project.refuse("FS312", reader.here(), text=reader.here().text, advice='it is written `say "TEXT"`')
    return pieces_of((*strings, *more)), reader.scope


def _elsewhere(project: Project, reader: Reader) -> tuple[tuple[Span, ...], Scope] | None:
    """A text in a file, in a cell of a table, or behind a name (a parameter, a `let`); None where it stands here."""
    if reader.word("text"):
        return (_file(project, reader, "text"),), reader.scope
    word = reader.peek()
    expansion = expand(project, word, reader.scope) if isinstance(word, Name | Dotted) else None
    if word is None or expansion is None:
        return None
    reader.next()
    if expansion.cell is not None:
        cell = expansion.cell
        place = f"{cell.file} row {cell.row} {cell.column}"
        return (Span(Source(place, cell.text), 0, len(cell.text)),), GLOBAL
    with inside(project, expansion, word.span):
        inner = Reader(expansion.words, expansion.scope, word.span)
        found = _pieces(project, inner, (), False)
        left_over(project, inner)
    return found


def _file(project: Project, reader: Reader, kind: str) -> Span:
    word = reader.next()
    if not isinstance(word, String):
        span = word.span if word is not None else reader.span
        raise project.refuse("FS312", span, text=span.text, advice=f'it is written `say {kind} "FILE"`')
    name = project_path(word.span, word.value)
    try:
        source = project.world_of(name).source(name)
    except WorldFailure as failure:
        raise project.refuse("FS701", word.span, path=word.value, reason=failure.args[0]) from None
    return Span(source, 0, len(source.text))


def spoken_with(voice: Voice, line: Line) -> Voice:
    """A voice with a line's `rate pitch range volume`, each a factor of the voice's own. Raises `Refused`."""
    least = {"rate": SLOWEST, "pitch": SLOWEST, "range": 0.0, "volume": 0.0}
    factors = {name: line.factor(name, SHARE, limit) for name, limit in least.items()}
    changed = {name: getattr(voice, name) * factor for name, factor in factors.items() if factor is not None}
    return replace(voice, **changed)


def voice_named(project: Project, words: tuple[Word, ...], span: Span) -> Voice:
    """`en-us female`: a language as espeak-ng names it, and a variant; or `en-us piper "amy.onnx"`: another engine and
    its voice. Whether they exist is found when they speak, but for a file."""
    texts = [word.text if isinstance(word, Name) else word.value if isinstance(word, String) else "" for word in words]
    if not texts or not _LANGUAGE.fullmatch(texts[0]):
        where = words[0].span if words else span
        raise project.refuse("FS326", where, text=where.text)
    if (len(texts) > 1 and not _VARIANT.fullmatch(texts[1])) or len(texts) > 3 or not _is_quoted(words[2:]):
        where = words[1].span.to(words[-1].span)
        advice = "behind the language stands `female`, `male`, one variant's name, or an engine and its voice in quotes"
        raise project.refuse("FS312", where, text=where.text, advice=advice)
    if len(texts) == 2 and texts[1] in ENGINES:
        advice = f'behind an engine stands its voice, as in `{texts[0]} {texts[1]} "NAME"`'
        raise project.refuse("FS312", words[1].span, text=texts[1], advice=advice)
    if len(texts) < 3:
        return Voice(texts[0], "".join(texts[1:]))
    row, last = ENGINES.get(texts[1]), words[2]
    if row is not None and row.files and isinstance(last, String):
        return Voice(texts[0], _path(project, last), engine=texts[1])
    return Voice(texts[0], texts[2], engine=texts[1])


def _is_quoted(words: tuple[Word, ...]) -> bool:
    return all(isinstance(word, String) and word.value for word in words)
