"""A tree to a text that is read in a diff, or to tuples without places that are compared; where the scripts lie."""

from __future__ import annotations

import os
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from facescript.diagnostics.model import Diagnostics
from facescript.syntax import tree
from facescript.syntax.parser import parse
from facescript.text import Source, Span

HERE = Path(__file__).parent
SCRIPTS = sorted((HERE / "scripts").glob("*.face"))


def read(text: str) -> tuple[tree.Script, Diagnostics]:
    diagnostics = Diagnostics()
    return parse(Source("script.face", text), diagnostics), diagnostics


def codes(text: str) -> list[str]:
    return [item.code for item in read(text)[1]]


def clean(text: str) -> tree.Script:
    script, diagnostics = read(text)
    assert [f"{item.code} {item.message}" for item in diagnostics] == []
    return script


def golden(path: Path, text: str) -> None:
    """Compare with a kept text; FACESCRIPT_UPDATE=1 writes it anew."""
    if os.environ.get("FACESCRIPT_UPDATE"):
        path.write_text(text, "utf-8")
    assert text == path.read_text("utf-8")


def bare(node: Any) -> Any:
    """A node as nested tuples, without spans: equal where two trees say the same."""
    if isinstance(node, tuple):
        return tuple(bare(part) for part in node)
    if not is_dataclass(node):
        return node
    parts = ((item.name, getattr(node, item.name)) for item in fields(node))
    return (type(node).__name__, *(bare(part) for name, part in parts if name not in ("span", "source")))


def outline(script: tree.Script) -> str:
    """One line a statement, blocks indented, each word with its kind."""
    return "".join(f"{row}\n" for item in script.items for row in _rows(item))


def _rows(node: Any, depth: int = 0) -> list[str]:
    """A row of the node's own words, then the rows of what stands in it."""
    own: list[str] = []
    below: list[str] = []
    for item in fields(node):
        value = getattr(node, item.name)
        if isinstance(value, Span) or value in ((), None):
            continue
        if item.name in ("body", "ons"):
            below += [row for part in value for row in _rows(part, depth + 1)]
        elif item.name in ("lines", "more"):
            below += ["  " * (depth + 1) + _words(part) for part in value]
        else:
            own.append(_words(value))
    return ["  " * depth + " ".join([type(node).__name__, *own]), *below]


def _words(value: Any) -> str:
    match value:
        case tuple():
            return " | ".join(_words(part) for part in value)
        case tree.Phrase(words):
            return " ".join(_words(word) for word in words)
        case tree.Name(text) | tree.Operator(text) | tree.Colour(text):
            return text
        case tree.Dotted(parts, quoted):
            return "/".join(f'"{part}"' if quote else str(part) for part, quote in zip(parts, quoted, strict=True))
        case tree.String(text):
            return f'"{text}"'
        case tree.Quantity(number, unit):
            return f"<{number:g} {unit}>"
        case tree.Integer(number):
            return f"<{number}>"
        case tree.Size(width, height):
            return f"<{width} by {height}>"
        case tree.Call(name, arguments):
            return f"{name.text}({_words(arguments)})"
        case tree.Argument(None, given) | tree.Parameter(given, None):
            return _words(given)
        case tree.Argument(name, given) | tree.Parameter(name, given):
            return f"{_words(name)} = {_words(given)}"
        case tree.Bracket(inner):
            return f"({_words(inner)})"
        case tree.Point(coordinates):
            return f"[{' '.join(_words(word) for word in coordinates)}]"
    return str(value)
