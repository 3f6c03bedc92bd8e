"""Places that a play in JSON notes to spans, and objects without a place to where they stand in the JSON."""

from __future__ import annotations

import dataclasses
import json
import json.scanner
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from functools import cache
from itertools import accumulate
from json.decoder import JSONObject  # type: ignore[attr-defined]
from typing import Any

from facescript.text import Source, Span

MARK = "@"
"""The key under which an object notes where it begins and ends in the JSON."""

MOST_BLANKS = 4 * 1024 * 1024
"""Characters that the sources of blanks have together: as many as a script has at most."""

Find = Callable[[str], Source | None]
"""A source by the name that places give it; None where it is not to be had."""


class Unfit(ValueError):
    """Places that no script has; `args[0]` says why."""


class Places:
    """The spans of a play: `form` is its JSON, `whole` the source of that."""

    def __init__(self, form: Any, whole: Source, find: Find) -> None:
        self.whole = whole
        widths: dict[str, list[int]] = {}
        _measure(form, widths)
        self._sources = {name: _fitting(find(name), lines) or _blank(name, lines) for name, lines in widths.items()}

    def span(self, place: Mapping[str, Any]) -> Span:
        """The span of a place that the play notes. Raises `Unfit` for one that ends before it begins."""
        source, starts = self._sources[place["file"]]
        start = starts[place["line"] - 1] + place["column"] - 1
        end = starts[place["end_line"] - 1] + place["end_column"] - 1
        if end < start:
            raise Unfit(f"a place in {place['file']} ends before it begins, in line {place['line']}")
        return Span(source, start, end)

    def here(self, marked: Mapping[str, Any]) -> Span:
        """Where an object stands in the JSON."""
        return Span(self.whole, *marked[MARK])


@cache
def places_itself(found: type) -> bool:
    """Whether the objects of a class have a place."""
    return any(field.name == "span" for field in dataclasses.fields(found))


def lacking(form: Any, classes: Mapping[str, type]) -> bool:
    """Whether an object that should have a place has none."""
    if isinstance(form, list | tuple):
        return any(lacking(item, classes) for item in form)
    if not isinstance(form, dict) or "file" in form:
        return False
    if "span" not in form and places_itself(classes[form["type"]]):
        return True
    return any(lacking(item, classes) for item in form.values())


# ------------------------------------------------------------------------------------------------ where objects stand


def mark(form: Any, whole: Source) -> None:
    """Notes in every object of a play's form where it stands in the JSON. Raises `Unfit` for one too deep for that."""
    try:
        _graft(form, _located(whole.text)["play"])
    except RecursionError:
        raise Unfit("it is nested too deep to tell places in it") from None


def place_of(whole: Source, path: Iterable[str | int]) -> Span:
    """The innermost object on a path into the JSON; its beginning where it cannot be read at all."""
    try:
        found = _located(whole.text)
    except (ValueError, RecursionError):
        return Span(whole, 0, 0)
    span = Span(whole, 0, 0)
    for part in path:
        span = _marked(whole, found) or span
        with suppress(KeyError, IndexError, TypeError):  # a name of a class, which is no part of the JSON
            found = found[part]
    return _marked(whole, found) or span


def _marked(whole: Source, found: Any) -> Span | None:
    return Span(whole, *found[MARK]) if isinstance(found, dict) else None


class _Locating(json.JSONDecoder):
    """Reads JSON, and notes in each object where it begins and ends."""

    def __init__(self) -> None:
        super().__init__()
        self.parse_object = self._object
        self.scan_once = json.scanner.py_make_scanner(self)  # type: ignore[attr-defined]

    def _object(self, state: tuple[str, int], strict: bool, scan: Any, hook: Any, pairs: Any, memo: Any) -> Any:
        found, end = JSONObject(state, strict, scan, None, None, memo)
        found[MARK] = (state[1] - 1, end)
        return found, end


def _located(text: str) -> Any:
    return _Locating().decode(text)


def _graft(form: Any, located: Any) -> None:
    if isinstance(form, list | tuple):
        for item, other in zip(form, located, strict=True):
            _graft(item, other)
    elif isinstance(form, dict) and "file" not in form:
        for name, item in form.items():
            _graft(item, located[name])
        form[MARK] = located[MARK]


# ------------------------------------------------------------------------------------------------ sources


def _fitting(source: Source | None, lines: list[int]) -> tuple[Source, list[int]] | None:
    """A source that has all the places, and where its lines start."""
    if source is None:
        return None
    texts = source.text.split("\n")
    if len(texts) < len(lines) or any(width > len(text) for width, text in zip(lines, texts, strict=False)):
        return None
    return source, [0, *accumulate(len(text) + 1 for text in texts)]


def _blank(name: str, lines: list[int]) -> tuple[Source, list[int]]:
    """A source of blank lines long enough for every place in it. Raises `Unfit` where no script is so long."""
    if sum(lines) + len(lines) > MOST_BLANKS:
        raise Unfit(f"its places in {name} are beyond what a script can hold")
    starts = [0, *accumulate(width + 1 for width in lines)]
    return Source(name, "\n".join(" " * width for width in lines)), starts


def _measure(value: Any, widths: dict[str, list[int]]) -> None:
    """Gathers how long each line of each file is at least. Raises `Unfit` where that is more than scripts have."""
    if isinstance(value, list | tuple):
        for item in value:
            _measure(item, widths)
    elif isinstance(value, dict) and "file" in value:
        lines = widths.setdefault(value["file"], [])
        for line, column in ((value["line"], value["column"]), (value["end_line"], value["end_column"])):
            if line > len(lines) and line + sum(map(len, widths.values())) > MOST_BLANKS:
                raise Unfit(f"its places in {value['file']} are beyond what a script can hold")
            lines.extend([0] * (line - len(lines)))
            lines[line - 1] = max(lines[line - 1], column - 1)
    elif isinstance(value, dict):
        for item in value.values():
            _measure(item, widths)
