"""`face` definitions to faces: kind, voice, life, place, size, looks."""

from __future__ import annotations

from typing import Literal

from facescript.ir.acts import Life, Voice
from facescript.ir.play import Face
from facescript.ir.values import PicturePlace
from facescript.resolve.lines import Line, segments
from facescript.resolve.lives import KINDS as KNOBS
from facescript.resolve.lives import USUAL, preset
from facescript.resolve.names import Definition
from facescript.resolve.places import picture_place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader
from facescript.resolve.scope import GLOBAL
from facescript.resolve.speech import spoken_with, voice_named
from facescript.resolve.suggest import nearest, replace
from facescript.resolve.units import SHARE
from facescript.resolve.words import FACE, KINDS, LATER_KINDS, LOOKS
from facescript.syntax.tree import Colour, Declaration, Name, Phrase, Word
from facescript.text import Span

ONLY = "somebody"
"""The name of the face of a script that declares none: `view somebody 180%`. Outputs with one face carry no name."""

GAZES: tuple[Literal["eye-mover", "head-mover"], ...] = ("eye-mover", "head-mover")


def default_face(project: Project, span: Span) -> Face:
    """The woman of a script that declares no face, known by the name `ONLY` where nothing else is."""
    node = Declaration("face", Name(ONLY, span), (), (), span)
    project.names.written.setdefault(ONLY, Definition("face", ONLY, node, span, own=False))
    try:
        life = preset(project, USUAL, span)
    except Refused:
        life = Life(USUAL)
    return Face(ONLY, "woman", Voice(), life, span)


def face(project: Project, node: Declaration) -> Face:
    """The face of a definition. A fault in one of its lines is reported and the line left out."""
    kind = _kind(project, node)
    line = _Settings(project, node)
    voice = line.try_voice()
    return Face(
        node.name.text,
        kind,
        voice,
        line.try_life(),
        node.span,
        line.try_gaze(),
        line.try_place(),
        line.try_size(),
        line.looks(),
        line.hair(),
    )


def _kind(project: Project, node: Declaration) -> str:
    """`woman`, `man` or `unseen`; what only later work draws, and slips, are reported and a woman stands in."""
    words = node.phrases[0].words if node.phrases else ()
    word = words[0] if words else None
    if isinstance(word, Name) and word.text in KINDS:
        return word.text
    span = word.span if word is not None else node.name.span
    if isinstance(word, Name) and word.text in LATER_KINDS:
        project.report("FS805", span, kind=word.text)
    else:
        text = word.span.text if word is not None else ""
        candidate = nearest(text, (*KINDS, *LATER_KINDS))
        fixes = (replace(span, candidate),) if candidate else ()
        clause = f"did you mean `{candidate}`?" if candidate else "there are `woman`, `man` and `unseen`."
        project.report("FS329", span, fixes=fixes, name=text or node.name.text, what="kind of face", meant=clause)
    return KINDS[0]


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

    def try_voice(self) -> Voice:
        voice = Voice()
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
                base = preset(self.project, USUAL, self.node.span)
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
            return Life(USUAL)

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

    def looks(self) -> tuple[tuple[str, str], ...]:
        found = []
        for name in LOOKS:
            words = self.line.parts.get(name)
            if name == "hair" and words is not None:
                words = tuple(word for word in words if not _is_still(word)) or None
            if words is None:
                continue
            if len(words) == 1 and isinstance(words[0], Colour):
                found.append((name, words[0].text.lower()))
            else:
                span = self.line.spans[name]
                self.project.report("FS314", span, text=span.text, advice="such as `#5b3a22`")
        return tuple(found)

    def hair(self) -> Literal["", "still"]:
        """Whether the hair is `still`: the word stands by itself or beside its colour."""
        return "still" if any(map(_is_still, self.line.parts.get("hair", ()))) else ""


def _is_still(word: Word) -> bool:
    return isinstance(word, Name) and word.text == "still"
