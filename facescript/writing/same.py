"""Two plays to the first thing in which they differ, but for places, names of statements and what moves nothing."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from math import isclose
from typing import Any

from facescript.ir.acts import Cue, Do, Drop, Say
from facescript.ir.play import Face, Play
from facescript.ir.values import Mark, Term
from facescript.text import Span
from facescript.writing.sums import shape

NEAR = 1e-9
"""How far numbers may lie apart that decimals say, as a part of them."""

Names = Mapping[str, str]


@dataclasses.dataclass(frozen=True, slots=True)
class Difference:
    """Where the first play says what the second does not: a path of fields, what each has there, and its place."""

    path: str
    value: object
    other: object
    span: Span | None


def difference(first: Play, second: Play, names: Names) -> Difference | None:
    """None where they are the same; `names` are statements of the first that bear another name in the second."""
    return _differing(first, second, names, "play", None)


def _differing(first: Any, second: Any, names: Names, path: str, span: Span | None) -> Difference | None:
    if isinstance(first, Span) and isinstance(second, Span):
        return None
    if dataclasses.is_dataclass(first) and type(first) is type(second):
        here = getattr(first, "span", None) or span
        one, other = _fields(first, names), _fields(second, {})
        return next(
            filter(None, (_differing(one[name], other[name], names, f"{path}.{name}", here) for name in one)), None
        )
    if isinstance(first, tuple) and isinstance(second, tuple):
        if len(first) == len(second):
            pairs = enumerate(zip(first, second, strict=True))
            found = (_differing(one, other, names, f"{path}[{place}]", span) for place, (one, other) in pairs)
            return next(filter(None, found), None)
    elif _is_number(first) and _is_number(second):
        if isclose(first, second, rel_tol=NEAR, abs_tol=NEAR):
            return None
    elif first == second:
        return None
    return Difference(path, first, second, span)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _fields(value: Any, names: Names) -> dict[str, Any]:
    """The fields of an object as they are compared."""
    found = {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}
    if isinstance(value, Face):
        found |= {name: tuple(sorted(found[name])) for name in ("looks", "choices", "amounts")}
    elif isinstance(value, Term):
        found["drivers"] = tuple(sorted(shape(value.drivers)))
    elif isinstance(value, Say):
        found["stretches"] = tuple(sorted(map(dataclasses.astuple, value.stretches)))
        found["cues"] = tuple(_placed(cue, value.text) for cue in value.cues)
    elif isinstance(value, Drop):
        found["name"] = names.get(value.name, value.name)
    elif isinstance(value, Do | Mark) or "label" in found:
        found["label"] = names.get(value.label, value.label)
    return found


def _placed(cue: Cue, text: str) -> Cue:
    """A cue from its first word to the end of its last one."""
    at = None if cue.at is None else len(text) - len(text[cue.at :].lstrip())
    until = None if cue.until is None else len(text[: cue.until].rstrip())
    return dataclasses.replace(cue, at=at, until=until)
