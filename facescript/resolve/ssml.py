"""Turns a file of SSML into a line's text, its pauses, stresses, readings and marks, and how all of it is spoken.

The file is read by expat, sign by sign: no document type is let through, so there are no entities but the five of XML,
and nothing outside the file is ever opened.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from xml.parsers import expat

from facescript.ir.acts import Stretch
from facescript.resolve.project import Project, Refused
from facescript.resolve.ssml_values import PROSODY, PROSODY_FORMS, pause_of, reading_of
from facescript.resolve.texts import LONGEST, Plain, Text, tight
from facescript.speech.lines import CLAUSE_ENDS
from facescript.text import Source, Span

DEEPEST = 64
"""Tags inside tags."""

STRANGEST = 30
"""Kinds of tags without effect, each told once."""

STILL = frozenset({"meta", "metadata", "lexicon", "lookup", "desc", "mstts:backgroundaudio"})
"""Tags of which the content is no text."""

PLAIN = frozenset({"speak", "w", "token", "p", "s", "paragraph", "sentence"})
"""Tags whose content is said as it is."""

SENTENCES = {"p": 2, "paragraph": 2, "s": 1, "sentence": 1}
"""Tags at the end of which a sentence ends, and how much: after a paragraph there is always a breath."""


@dataclass(frozen=True, slots=True)
class Manner:
    """How a line is spoken, each a factor of the voice's own."""

    rate: float = 1.0
    pitch: float = 1.0
    volume: float = 1.0


@dataclass(frozen=True, slots=True)
class Ssml:
    """A file of SSML as a line's text and manner; `language` is what it says of itself ("" for nothing)."""

    text: Text
    manner: Manner
    language: str


@dataclass(slots=True)
class _Tag:
    """An open tag, the length of the text before it, and where it stands."""

    name: str
    values: Mapping[str, str]
    at: int
    byte: int


@dataclass(slots=True)
class _Whole:
    """A tag that only the whole line can have: it holds the text from `start` to `end`."""

    tag: _Tag
    start: int
    end: int


def read_ssml(project: Project, source: Source, span: Span, recorded: bool) -> Ssml:
    """What a file of SSML says, by a voice or as a recording or a file of times does (`recorded`). Its faults are
    reported at their places in it; then raises `Refused`."""
    return _Reader(project, source, recorded).read(span)


@dataclass(slots=True)
class _Reader:
    project: Project
    source: Source
    recorded: bool
    data: bytes = b""
    plain: Plain = field(default_factory=Plain)
    stretches: list[Stretch] = field(default_factory=list)
    tags: list[_Tag] = field(default_factory=list)
    wholes: list[_Whole] = field(default_factory=list)
    told: set[str] = field(default_factory=set)
    still: int = 0
    ended: int = 0
    language: str = ""

    def read(self, span: Span) -> Ssml:
        self.data = self.source.text.encode()
        parser = expat.ParserCreate("utf-8")
        parser.buffer_text = True
        parser.StartElementHandler = lambda name, values: self.start(name, values, parser.CurrentByteIndex)
        parser.EndElementHandler = lambda name: self.end()
        parser.CharacterDataHandler = self.put
        parser.StartDoctypeDeclHandler = lambda *_: self.refuse(
            "a document type may bring entities, which are never resolved", self.data.find(b"<!DOCTYPE")
        )
        try:
            parser.Parse(self.data, True)
        except expat.ExpatError as fault:
            raise self.refused(expat.ErrorString(fault.code), parser.ErrorByteIndex) from None
        text = "".join(self.plain.out)
        if not text:
            raise self.project.refuse("FS320", span)
        found = Text(text, tight(text, self.stretches), ())
        return Ssml(found, self.manner(), self.language)

    # -------------------------------------------------------------------------------------------- text

    def put(self, text: str) -> None:
        if self.still:
            return
        for part in re.split(r"(\s+)", text):
            if not part:
                continue
            if part.isspace():
                self.plain.space(part)
            else:
                self.sentence()
                self.plain.put(part)
        if self.plain.length > LONGEST:
            raise self.project.refuse("FS319", self.span(0), count=self.plain.length, most=LONGEST)

    def sentence(self) -> None:
        """A breath where a sentence has ended without its sign, or a paragraph."""
        last = self.plain.out[-1][-1:] if self.plain.out else ""
        if last and (self.ended == 2 or (self.ended == 1 and last not in CLAUSE_ENDS)):
            self.stretches.append(Stretch("breath", self.plain.length, self.plain.length))
        if self.ended:
            self.plain.space(" ")
        self.ended = 0

    # -------------------------------------------------------------------------------------------- tags

    def start(self, name: str, values: Mapping[str, str], byte: int) -> None:
        if len(self.tags) == DEEPEST:
            self.refuse(f"its tags stand more than {DEEPEST} deep in each other", byte)
        if not self.tags and name != "speak":
            self.refuse(f"it begins with `<{name}>`, not `<speak>`", byte)
        tag = _Tag(name, values, self.plain.length, byte)
        self.tags.append(tag)
        self.still += name in STILL
        if name == "speak":
            self.language = values.get("xml:lang", "")
        elif name in SENTENCES:
            self.ended = max(self.ended, 1) if self.plain.out else 0
        elif name in STILL:
            self.left_out(tag, "it says nothing of how a line sounds")
        elif name not in PLAIN and name not in _STARTS and name not in _ENDS:
            self.left_out(tag, "it is not understood; the text inside is spoken")
        if name in _STARTS:
            _STARTS[name](self, tag)

    def end(self) -> None:
        tag = self.tags.pop()
        self.still -= tag.name in STILL
        if tag.name in SENTENCES:
            self.ended = max(self.ended, SENTENCES[tag.name])
        elif tag.name in _ENDS:
            _ENDS[tag.name](self, tag)

    def pause(self, tag: _Tag) -> None:
        seconds = pause_of(tag.values)
        if seconds is None:
            self.refuse("a break's `time` is written `500ms` or `2s`", tag.byte)
        elif seconds:
            self.stretches.append(Stretch("pause", tag.at, tag.at, f"{seconds:.10g}"))

    def mark(self, tag: _Tag) -> None:
        name = tag.values.get("name", "").strip()
        if not name:
            self.refuse("a mark has no `name`", tag.byte)
        self.sentence()
        self.stretches.append(Stretch("mark", self.plain.length, self.plain.length, name))

    def emphasis(self, tag: _Tag) -> None:
        level = tag.values.get("level", "moderate")
        if level in ("strong", "moderate"):
            self.over(tag, "stress", "")
        elif level != "none":
            self.left_out(tag, f"there is no stress `{level}`")

    def reading(self, tag: _Tag) -> None:
        value = reading_of(tag.name, tag.values, "".join(self.plain.out)[tag.at :].strip())
        if value:
            self.over(tag, "reading", value)
        else:
            self.left_out(tag, "it says no reading that the voice could follow; the text inside is spoken")

    def over(self, tag: _Tag, kind: str, value: str) -> None:
        """A stretch over the text that a tag holds."""
        if self.plain.length > tag.at:
            self.stretches.append(Stretch(kind, tag.at, self.plain.length, value))  # type: ignore[arg-type]

    def whole(self, tag: _Tag) -> None:
        self.wholes.append(_Whole(tag, tag.at, self.plain.length))

    def manner(self) -> Manner:
        """What holds for the whole line; a line has one rate, pitch and volume, so what holds for a part is told."""
        factors = dict.fromkeys(PROSODY, 1.0)
        for whole in self.wholes:
            if whole.tag.name != "prosody":
                self.left_out(whole.tag, "the voice is the face's")
            elif whole.start > 0 or whole.end < self.plain.length:
                self.left_out(whole.tag, "it stands around a part of the text, and a line has one rate, pitch, volume")
            else:
                for name, value in whole.tag.values.items():
                    self.factor(factors, whole.tag, name, value)
        return Manner(**factors)

    def factor(self, factors: dict[str, float], tag: _Tag, name: str, value: str) -> None:
        found = PROSODY[name](value) if name in PROSODY else None
        if self.recorded and name in ("rate", "pitch"):
            self.left_out(
                tag, f"a recording is heard, and the times of a file are kept, as they are; `{name}` is for a voice"
            )
        elif found is None:
            form = f"`{name}` is written {PROSODY_FORMS[name]}" if name in PROSODY else f"`{name}` is not understood"
            self.left_out(tag, form)
        else:
            factors[name] *= found

    # -------------------------------------------------------------------------------------------- faults

    def span(self, byte: int) -> Span:
        """The tag at a byte of the file, or the sign there."""
        start = min(len(self.data[:byte].decode(errors="replace")), len(self.source.text))
        close = self.source.text.find(">", start, start + 200)
        return Span(self.source, start, close + 1 if close >= 0 else min(start + 1, len(self.source.text)))

    def refused(self, reason: str, byte: int) -> Refused:
        return self.project.refuse("FS517", self.span(byte), reason=reason)

    def refuse(self, reason: str, byte: int) -> None:
        raise self.refused(reason, byte)

    def left_out(self, tag: _Tag, reason: str) -> None:
        """Tells of a tag without effect, once a kind of tag and reason."""
        if f"{tag.name} {reason}" not in self.told:
            self.told.add(f"{tag.name} {reason}")
            if len(self.told) > STRANGEST:
                self.refuse("too many of its tags are not understood", tag.byte)
            self.project.report("FS518", self.span(tag.byte), tag=f"<{tag.name}>", reason=reason)


_STARTS: Mapping[str, Callable[[_Reader, _Tag], None]] = {"break": _Reader.pause, "mark": _Reader.mark}
_ENDS: Mapping[str, Callable[[_Reader, _Tag], None]] = {
    "emphasis": _Reader.emphasis,
    "phoneme": _Reader.reading,
    "sub": _Reader.reading,
    "say-as": _Reader.reading,
    "prosody": _Reader.whole,
    "lang": _Reader.whole,
    "voice": _Reader.whole,
}
