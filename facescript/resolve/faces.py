"""`face` definitions to faces: kind, voice, life, place, size, looks."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from typing import Literal

from facescript.ir.acts import Life, Voice
from facescript.ir.kind import Kind, KindHead
from facescript.ir.play import Face
from facescript.ir.values import PicturePlace
from facescript.resolve.kinds.kind import kind as kind_of
from facescript.resolve.kinds.library import kind_names, library_head
from facescript.resolve.lines import Line, segments
from facescript.resolve.lives import KINDS as KNOBS
from facescript.resolve.lives import USUAL as CALM
from facescript.resolve.lives import preset
from facescript.resolve.looks import looks
from facescript.resolve.names import Definition
from facescript.resolve.places import picture_place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader
from facescript.resolve.scope import GLOBAL
from facescript.resolve.speech import spoken_with, voice_named
from facescript.resolve.suggest import nearest, replace
from facescript.resolve.units import SHARE
from facescript.resolve.words import FACE, UNSEEN, USUAL
from facescript.syntax.tree import Declaration, Name, Phrase
from facescript.text import Span

ONLY = "somebody"
"""The name of the face of a script that declares none: `view somebody 180%`. Outputs with one face carry no name."""

GAZES: tuple[Literal["eye-mover", "head-mover"], ...] = ("eye-mover", "head-mover")


def define_default(project: Project, span: Span) -> Definition:
    """Makes the face of a script that declares none known by the name `ONLY`, where nothing else is."""
    node = Declaration("face", Name(ONLY, span), (), (), span)
    definition = Definition("face", ONLY, node, span, own=False)
    project.names.written.setdefault(ONLY, definition)
    return definition


def default_face(project: Project, span: Span) -> Face:
    """The woman of a script that declares no face."""
    try:
        life = preset(project, CALM, span)
    except Refused:
        life = Life(CALM)
    return Face(ONLY, USUAL, _head(USUAL, None).voice or Voice(), life, span)


def face(project: Project, node: Declaration) -> Face:
    """The face of a definition. A fault in one of its lines is reported and the line left out."""
    kind, own = _kind(project, node)
    head = _head(kind, own)
    line = _Settings(project, node)
    voice = line.try_voice(head.voice or Voice())
    chosen = looks(project, line.line, kind, head)
    return Face(
        node.name.text,
        kind,
        voice,
        line.try_life(),
        node.span,
        line.try_gaze(),
        line.try_place(),
        line.try_size(),
        chosen.colours,
        chosen.choices,
        chosen.amounts,
        chosen.hair,
        head.channels,
        own,
    )


def _kind(project: Project, node: Declaration) -> tuple[str, Kind | None]:
    """A kind of the library, `unseen`, or one that the script defines; for a slip, which is reported, the usual one."""
    words = node.phrases[0].words if node.phrases else ()
    word = words[0] if words else None
    text = word.text if isinstance(word, Name) else ""
    defined = project.names.written.get(text)
    if defined is not None and defined.kind == "kind" and isinstance(defined.node, Declaration):
        project.names.used.add(text)
        return text, drawn(project, defined.node)
    known = (*kind_names(), UNSEEN)
    if text in known:
        return text, None
    span = word.span if word is not None else node.name.span
    candidate = nearest(span.text, (*known, *project.names.known("kind")))
    fixes = (replace(span, candidate),) if candidate and word is not None else ()
    there = ", ".join(f"`{kind}`" for kind in known[:-1])
    clause = f"did you mean `{candidate}`?" if candidate else f"there are {there} and `{UNSEEN}`."
    project.report("FS329", span, fixes=fixes, name=span.text, what="kind of face", meant=clause)
    return USUAL, None


def drawn(project: Project, node: Declaration) -> Kind | None:
    """A kind of the script's own, read once; None where it cannot be drawn, which is reported."""
    return project.memo.once(project, ("kind", node.name.text), node, partial(_drawn, project, node))


def _drawn(project: Project, node: Declaration) -> Kind | None:
    with suppress(Refused):
        return kind_of(project, node)
    return None


def _head(kind: str, drawn: Kind | None) -> KindHead:
    """What a face may choose of its kind; nothing of one that is only heard or could not be read."""
    if drawn is not None:
        return drawn.head
    return library_head(kind) if kind in kind_names() else KindHead()


class _Settings:
    """What a face's definition says after its kind, each part read by itself so that one fault spoils one part."""

    def __init__(self, project: Project, node: Declaration) -> None:
        self.project = project
        self.node = node
        self.line = Line(project, "face", (Phrase((), node.span),), FACE, GLOBAL)
        first = node.phrases[0] if node.phrases else None
        phrases = [*node.phrases[1:], *(phrase for row in node.lines for phrase in row)]
        if first is not None and len(first.words) > 1:
            phrases.insert(0, Phrase(first.words[1:], first.words[1].span.to(first.words[-1].span)))
        for phrase in phrases:
            for words in segments(phrase.words):
                try:
                    self.line.take(words)
                except Refused:
                    continue

    def try_voice(self, usual: Voice) -> Voice:
        """The voice; `usual` where none is named."""
        voice = usual
        try:
            if "voice" in self.line.parts:
                voice = voice_named(self.project, self.line.parts["voice"], self.line.spans["voice"])
            return spoken_with(voice, self.line)
        except Refused:
            return voice

    def try_life(self) -> Life:
        words = self.line.parts.get("life")
        try:
            if words is None:
                base = preset(self.project, CALM, self.node.span)
            elif len(words) == 1 and isinstance(words[0], Name):
                base = preset(self.project, words[0].text, words[0].span)
            else:
                span = self.line.spans["life"]
                advice = "it is written `life PRESET, blink 8/min`"
                raise self.project.refuse("FS312", span, text=span.text, advice=advice)
            tuned = dict(base.knobs)
            for name, kind in KNOBS.items():
                amount = self.line.amount(name, kind)
                if amount is not None:
                    tuned[name] = amount
            return Life(base.name, tuple(tuned.items()))
        except Refused:
            return Life(CALM)

    def try_gaze(self) -> Literal["", "eye-mover", "head-mover"]:
        try:
            word = self.line.name("gaze")
        except Refused:
            return ""
        for name in GAZES:
            if word is not None and word.text == name:
                return name
        if word is not None:
            meant = "there are `eye-mover` and `head-mover`."
            self.project.report("FS329", word.span, name=word.text, what="way of moving", meant=meant)
        return ""

    def try_place(self) -> PicturePlace | None:
        words = self.line.parts.get("at")
        if words is None:
            return None
        try:
            return picture_place(self.project, Reader(words, GLOBAL, self.line.spans["at"]))
        except Refused:
            return None

    def try_size(self) -> float:
        try:
            return self.line.factor("size", SHARE, 0.01) or 1.0
        except Refused:
            return 1.0
