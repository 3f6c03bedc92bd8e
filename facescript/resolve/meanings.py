"""What the things that a script names mean, in a few words: kinds of faces, muscles, what comments say."""

from __future__ import annotations

from itertools import takewhile

from facescript.text import Span

FACES = {
    "woman": "a cartoon woman",
    "man": "a cartoon man",
    "dog": "a dog with ears that hang",
    "rodent": "a squirrel",
    "gorilla": "a gorilla",
    "unseen": "nobody to see: a voice alone",
}

MUSCLES_DO = {
    "brow.inner": "raises the brow's inner end",
    "brow.outer": "raises the brow's outer end",
    "forehead": "raises the whole brow and creases the forehead",
    "brow.lower": "lowers the brow and draws it together",
    "cheek.upper": "raises the cheek",
    "cheek.lower": "draws the lip's corner up and out",
    "nose.upper": "wrinkles the nose",
    "lip.upper": "raises the upper lip",
    "lip.corner": "draws the lip's corner down",
    "lip.lower": "draws the lower lip down",
    "lip.stretch": "draws the lip's corner straight out",
    "lip.press": "presses the lips together",
    "lip.pucker": "pushes the lips forward and draws them together",
    "chin": "pushes the chin's boss up",
}


def comment_of(span: Span) -> str:
    """What is said of the definition at a span: the comment behind its first line, else the one above; "" for none."""
    number, column = span.source.position(span.start)
    _, sign, beside = span.source.line(number)[column - 1 :].partition("  # ")
    return beside.strip() if sign else _above(span, number)


def _above(span: Span, number: int) -> str:
    lines = (span.source.line(above) for above in range(number - 1, 0, -1))
    comment = takewhile(lambda line: line.startswith("# "), lines)
    return " ".join(line[2:].strip() for line in reversed(list(comment)))


def first_sentence(text: str) -> str:
    return text.partition(". ")[0].rstrip(".")
