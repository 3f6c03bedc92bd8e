"""The grammar to the parse table that the machine runs: Lark computes it, plain lists and numbers hold it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

from facescript.resources import folder

STARTS = ("start", "cue")
"""What can be parsed: a top-level block of a script, and the phrases of a cue in a text."""


@dataclass(frozen=True, slots=True)
class Table:
    """An LALR(1) table.

    `states[n]` maps a terminal or a rule's name to the state that follows it, or a terminal to `~r`: reduce by rule r.
    `rules[r]` is (rule's name, number of its symbols, what to build, which symbols have a value, which are chains):
    what to build is a method of `builder.py`, "" for the one value as it is, "+" for a chain, Lark's way to repeat.
    `starts` and `ends` are the first and the accepting state of each start rule, `keywords` the words in quotes with
    their terminals, `pattern` one regular expression with a group for every other terminal.
    """

    states: list[dict[str, int]]
    rules: list[tuple[str, int, str, list[int], list[int]]]
    starts: dict[str, int]
    ends: dict[str, int]
    keywords: dict[str, str]
    pattern: str


@cache
def table() -> Table:
    """The table of `grammar/face.lark`, from the user's cache where it holds it."""
    from facescript.syntax import cache as store

    grammar = (folder("grammar") / "face.lark").read_text("utf-8")
    key = store.key_of(grammar)
    kept = store.load(key)
    if kept is not None:
        return Table(**kept)
    made = build(grammar)
    store.save(key, asdict(made))
    return made


def build(grammar: str) -> Table:
    """Have Lark compute the table; about 100 ms with the import of Lark."""
    from lark import Lark

    lark = Lark(grammar, parser="lalr", lexer="contextual", maybe_placeholders=False, start=list(STARTS))
    found = lark.parser.parser.parser.parse_table
    order = {rule: number for number, rule in enumerate(lark.rules)}
    states: list[dict[str, int]] = [{} for _ in found.states]
    for state, actions in found.states.items():
        for symbol, (_, target) in actions.items():
            states[state][symbol] = target if isinstance(target, int) else ~order[target]
    keywords = {
        t.pattern.value: t.name for t in lark.terminals if t.pattern.type == "str" and t.pattern.value.isalpha()
    }
    rules = [_rule(rule) for rule in lark.rules]
    return Table(
        states, rules, dict(found.start_states), dict(found.end_states), keywords, _pattern(lark.terminals, keywords)
    )


def _rule(rule: Any) -> tuple[str, int, str, list[int], list[int]]:
    symbols = rule.expansion
    kept = [index for index, symbol in enumerate(symbols) if not (symbol.is_term and symbol.filter_out)]
    chains = [index for index in kept if symbols[index].name.startswith("__")]
    name = rule.origin.name
    if name.startswith("__"):
        make = "+"
    elif rule.alias:
        make = rule.alias
    else:
        make = "" if rule.options.expand1 and len(kept) == 1 else name
    return str(name), len(symbols), str(make), kept, chains


def _pattern(terminals: Any, keywords: dict[str, str]) -> str:
    """All terminals but the keywords, tried in the order of their priorities; the first that matches wins."""
    others = [terminal for terminal in terminals if terminal.name not in keywords.values()]
    others.sort(key=lambda terminal: -terminal.priority)
    return "|".join(f"(?P<{terminal.name}>{terminal.pattern.to_regexp()})" for terminal in others)
