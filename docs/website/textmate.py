"""A script to the scopes that the TextMate grammar gives its stretches, read as editors read it.

Line by line, with a stack of open rules; the earliest match counts, of several the end of what is open, then the first.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

GRAMMAR = Path(__file__).parents[2] / "editors" / "vscode" / "syntaxes" / "face.tmLanguage.json"

Rule = dict[str, Any]
Scoped = tuple[int, int, str]
"""Start and end of a stretch, and its innermost scope; "" for none."""


@dataclass(frozen=True)
class Open:
    """A rule whose end has not come, what may stand inside, and the scope of all that does."""

    rule: Rule
    end: re.Pattern[str] | None
    inside: tuple[Rule, ...]
    scope: str


def scopes(script: str) -> Iterator[tuple[str, list[Scoped]]]:
    """Each line of a script, with its stretches from left to right."""
    stack = [Open({}, None, flat(grammar()["patterns"]), "")]
    for number, line in enumerate(script.split("\n")):
        read = _read(stack, line, 0, number == 0)
        yield line, [(start, end, scope.rpartition(" ")[2]) for start, end, scope in read if start < end]


@cache
def grammar() -> Rule:
    read: Rule = json.loads(GRAMMAR.read_text("utf-8"))
    return read


def _read(stack: list[Open], line: str, place: int, first: bool) -> Iterator[Scoped]:
    """The stretches of a line from a place on; the stack is left as it is at the line's end."""
    found: dict[int, re.Match[str] | None] = {}
    stuck: set[tuple[int, int]] = set()
    while (taken := _next(stack[-1], line, place, first, found)) is not None:
        rule, match = taken
        yield place, match.start(), stack[-1].scope
        yield from _captured(stack, rule, match)
        _turn(stack, rule)
        step = match.start() == match.end() and (match.end(), len(stack)) in stuck
        stuck.add((match.end(), len(stack)))
        if step:
            yield match.end(), match.end() + 1, stack[-1].scope
        place = match.end() + step
        if place > len(line):
            return
    yield place, len(line), stack[-1].scope


def _next(
    top: Open, line: str, place: int, first: bool, found: dict[int, re.Match[str] | None]
) -> tuple[Rule | None, re.Match[str]] | None:
    """The rule that matches first, None for the end of what is open; `found` keeps what is known of the line."""
    ended = top.end.search(line, place) if top.end else None
    best: tuple[Rule | None, re.Match[str]] | None = (None, ended) if ended else None
    for rule in top.inside:
        source = rule.get("match") or rule["begin"]
        if source.startswith(r"\A") and not first:
            continue
        match = found.get(id(rule))
        if id(rule) not in found or (match is not None and match.start() < place):
            match = found[id(rule)] = compiled(source).search(line, place)
        if match is not None and (best is None or match.start() < best[1].start()):
            best = (rule, match)
    return best


def _captured(stack: list[Open], rule: Rule | None, match: re.Match[str]) -> Iterator[Scoped]:
    """The stretches of a match: its groups, and what lies between them."""
    owner = stack[-1].rule if rule is None else rule
    groups = owner.get("endCaptures" if rule is None else "beginCaptures" if "begin" in owner else "captures", {})
    scope, place = owner.get("name", stack[-1].scope), match.start()
    for number, group in groups.items():
        start, end = match.span(int(number)) if int(number) <= match.re.groups else (-1, -1)
        if place <= start < end:
            yield place, start, scope
            if "patterns" in group:
                inner = Open({}, None, flat(group["patterns"]), scope)
                yield from _read([inner], match.string[:end], start, False)
            else:
                yield start, end, group["name"]
            place = end
    yield place, match.end(), scope


def _turn(stack: list[Open], rule: Rule | None) -> None:
    """Close what is open, or open a rule that has an end."""
    if rule is None:
        stack.pop()
    elif "begin" in rule:
        scope = rule.get("contentName") or rule.get("name") or ""
        stack.append(Open(rule, compiled(rule["end"]), _inside(rule), scope))


_KNOWN: dict[int, tuple[Rule, ...]] = {}


def _inside(rule: Rule) -> tuple[Rule, ...]:
    if id(rule) not in _KNOWN:
        _KNOWN[id(rule)] = flat(rule.get("patterns", []))
    return _KNOWN[id(rule)]


def flat(patterns: list[Rule]) -> tuple[Rule, ...]:
    """Rules that match, for those that only include others."""
    rules: list[Rule] = []
    for rule in patterns:
        if "include" in rule:
            rules += flat([grammar()["repository"][rule["include"].removeprefix("#")]])
        elif "match" in rule or "begin" in rule:
            rules.append(rule)
        else:
            rules += flat(rule["patterns"])
    return tuple(rules)


@cache
def compiled(source: str) -> re.Pattern[str]:
    return re.compile(source)
