"""A line whose tokens do not fit the grammar to one fault, and where the meaning is plain to the tokens as meant."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from difflib import get_close_matches

from facescript.syntax.faults import Faults
from facescript.syntax.spacing import BEGINS, ENDS, Token

OUTSIDE = frozenset(("EXPRESSION", "ACTION", "LET", "FACE", "TARGET", "FILM", "EVENT", "USE", "SCENE", "WHEN"))
"""Keywords of what stands outside of all blocks."""

HEADERS = {
    "scene": "SCENE",
    "when": "WHEN",
    "action": "ACTION",
    "repeat": "REPEAT",
    "at": "AT",
    "on": "ON",
    "together": "TOGETHER",
    "choose": "CHOOSE",
}
"""Words that open a line with a colon."""

LONGEST_HEADER = 40
"""Signs of a header that a message repeats."""

Mended = list[Token]


@dataclass(frozen=True, slots=True)
class Place:
    """The token at `index` of a line cannot stand there; `accepts` says which kinds could."""

    tokens: list[Token]
    index: int
    accepts: Callable[[str], bool]
    faults: Faults

    @property
    def token(self) -> Token:
        return self.tokens[self.index]

    @property
    def kind(self) -> str:
        return self.tokens[self.index][0]

    @property
    def before(self) -> Token | None:
        return self.tokens[self.index - 1] if self.index else None

    @property
    def opener(self) -> Token:
        """The first token of the statement: of the line, or after its last colon before the fault."""
        for index in range(self.index - 1, 0, -1):
            if self.tokens[index - 1][0] == "COLON":
                return self.tokens[index]
        return self.tokens[0]

    @property
    def first(self) -> bool:
        return self.index == 0 or self.tokens[self.index - 1][0] == "COLON"

    def with_(self, *tokens: Token, instead: int = 0) -> Mended:
        """The line with tokens put in at the fault, in place of `instead` of its own."""
        return [*self.tokens[: self.index], *tokens, *self.tokens[self.index + instead :]]


def mend(tokens: list[Token], index: int, accepts: Callable[[str], bool], faults: Faults) -> Mended | None:
    """Report the fault at the token `index`; the tokens as meant, or None where that is not known."""
    place = Place(tokens, index, accepts, faults)
    for rule in RULES:
        if rule.fits(place):
            return rule.report(place)
    _report_unexpected(place)
    return None


@dataclass(frozen=True, slots=True)
class Rule:
    """A kind of fault: when it is one, and how it is told and mended."""

    fits: Callable[[Place], bool]
    report: Callable[[Place], Mended | None]


def _report_unexpected(place: Place) -> None:
    """Report what no rule knows."""
    _, text, start, end = place.token
    if start == end and place.before:
        place.faults.add("FS125", *place.before[2:], where=f"after `{place.before[1]}`")
    else:
        place.faults.add("FS135", start, end, word=text)


# --------------------------------------------------------------------------------------- what stands in the wrong place


def _is_outside(place: Place) -> bool:
    return place.first and place.kind in OUTSIDE


def _report_outside(place: Place) -> None:
    _, text, start, end = place.token
    place.faults.add("FS132", start, end, word=text)


def _is_on(place: Place) -> bool:
    return place.first and place.kind == "ON"


def _report_on(place: Place) -> None:
    place.faults.add("FS133", *place.token[2:])


def _is_under(place: Place) -> bool:
    return place.index == 0 and place.accepts("ON") and not place.accepts("NAME")


def _report_under(place: Place) -> None:
    place.faults.add("FS134", place.token[2], place.tokens[-1][3])


def _is_behind(place: Place) -> bool:
    return place.index == 1 and place.tokens[0][0] == "STRING" and place.kind != "_NL"


def _report_behind(place: Place) -> None:
    start, end = place.token[2], place.tokens[-1][2]
    words = " ".join(token[1] for token in place.tokens[place.index : -1]).replace(" ,", ",").lstrip(", ")
    place.faults.add("FS136", start, end, words=words if len(words) <= LONGEST_HEADER else place.token[1])


def _is_joined(place: Place) -> bool:
    return place.kind in ("COLON", "EQUAL") and _break(place) is not None


def _report_joined(place: Place) -> None:
    comma = _break(place)
    assert comma is not None
    start, end = comma[2:]
    place.faults.add("FS127", start, end, place.faults.fix("remove the comma", (start, end, "")))


def _break(place: Place) -> Token | None:
    """The last comma before the fault at which the line goes on in the next."""
    for index in range(place.index - 1, 0, -1):
        comma, after = place.tokens[index - 1], place.tokens[index]
        if comma[0] == "COMMA" and "\n" in place.faults.text(comma[3], after[2]):
            return comma
    return None


# ---------------------------------------------------------------------------------------- what is missing


def _lacks_colon(place: Place) -> bool:
    after = place.kind == "_NL" or place.kind == "NAME" or place.kind in HEADERS.values()
    return after and place.opener[0] in HEADERS.values() and place.accepts("COLON")


def _report_colon(place: Place) -> Mended:
    assert place.before is not None
    end = place.before[3]
    report_no_colon(place.opener, place.before, place.faults)
    return place.with_(("COLON", ":", end, end))


def report_no_colon(opener: Token, last: Token, faults: Faults) -> None:
    """Report that `:` is missing after a header from `opener` to `last`; the place is the last word."""
    start, end = last[2:]
    header = " ".join(faults.text(opener[2], end).split())
    header = header if len(header) <= LONGEST_HEADER else opener[1]
    faults.add("FS120", start, end, faults.fix("write `:`", (end, end, ":")), header=header)


def _lacks_equals(place: Place) -> bool:
    named = place.opener[0] in ("LET", "FACE", "EXPRESSION", "LIFE")
    return named and place.accepts("EQUAL") and not _unclosed(place) and place.kind != "RPAR"


def _report_equals(place: Place) -> Mended | None:
    kind, _, start, end = place.token
    before = place.before or place.token
    if kind in ("COLON", "OPERATOR"):
        fix = place.faults.fix("write ` =`", (before[3], end, " ="))
        place.faults.add("FS124", start, end, fix, before=before[1])
        return place.with_(("EQUAL", "=", start, end), instead=1)
    if kind == "_NL":
        place.faults.add("FS124", place.opener[2], before[3], before=before[1])
        return None
    fix = place.faults.fix("write ` =`", (before[3], before[3], " ="))
    place.faults.add("FS124", before[2], end, fix, before=before[1])
    return place.with_(("EQUAL", "=", start, start))


def _lacks_bracket(place: Place) -> bool:
    return place.kind in ("_NL", "COLON", "EQUAL") and place.accepts("RPAR") and _unclosed(place) is not None


def _report_bracket(place: Place) -> Mended:
    opened = _unclosed(place)
    assert opened is not None
    assert place.before is not None
    end = place.before[3]
    place.faults.add("FS128", *opened[2:], place.faults.fix("write `)`", (end, end, ")")))
    return place.with_(("RPAR", ")", end, end))


def _unclosed(place: Place) -> Token | None:
    """The innermost bracket that is open at the fault."""
    opened: list[Token] = []
    for token in place.tokens[: place.index]:
        if token[0] in ("LPAR", "_OPEN"):
            opened.append(token)
        elif token[0] == "RPAR" and opened:
            opened.pop()
    return opened[-1] if opened else None


def _is_unopened(place: Place) -> bool:
    return place.kind == "RPAR" and _unclosed(place) is None


def _report_unopened(place: Place) -> Mended:
    start, end = place.token[2:]
    place.faults.add("FS129", start, end, place.faults.fix("remove it", (start, end, "")))
    return place.with_(instead=1)


def _lacks_quotes(place: Place) -> bool:
    return place.kind in ("NAME", "DOTTED") and place.accepts("STRING") and not place.accepts("NAME")


def _report_quotes(place: Place) -> Mended:
    """`use studio.face` means all that follows, `on cup:` the word."""
    size = len(place.tokens) - place.index - 1 if place.opener[0] == "USE" else 1
    start, end = place.token[2], place.tokens[place.index + size - 1][3]
    text = f'"{place.faults.text(start, end)}"'
    place.faults.add("FS130", start, end, place.faults.fix(f"write `{text}`", (start, end, text)), text=text)
    return place.with_(("STRING", text, start, end), instead=size)


def _lacks_name(place: Place) -> bool:
    return place.accepts("NAME") and not place.accepts("STRING")


def _report_name(place: Place) -> Mended | None:
    kind, text, start, end = place.token
    before = place.before[1] if place.before else ""
    inner = text.strip('"')
    if kind != "STRING" or not inner.replace("-", "_").isidentifier():
        missing = place.before if start == end and place.before else place.token
        place.faults.add("FS131", *missing[2:], before=before)
        return None
    place.faults.add("FS131", start, end, place.faults.fix(f"write `{inner}`", (start, end, inner)), before=before)
    return place.with_(("NAME", inner, start, end), instead=1)


def _lacks_value(place: Place) -> bool:
    complete = place.before is not None and (place.before[0] in ENDS or place.before[0] == place.kind == "COLON")
    return not complete and place.kind not in BEGINS and place.accepts("NAME") and place.accepts("STRING")


def _report_value(place: Place) -> None:
    if place.before is None:
        where = f"before `{place.token[1]}`" if place.token[1] else "here"
        place.faults.add("FS125", *place.token[2:], where=where)
    else:
        place.faults.add("FS125", *place.before[2:], where=f"after `{place.before[1]}`")


# ---------------------------------------------------------------------------------------- what is too many


def _is_colon(place: Place) -> bool:
    return place.kind == "COLON"


def _report_extra_colon(place: Place) -> Mended | None:
    """A colon where none can be; after a word like `secne` the fault is that word."""
    start, end = place.token[2:]
    opener = place.opener
    close = get_close_matches(opener[1], HEADERS, 1, 0.7) if opener[0] == "NAME" else []
    if close:
        fix = place.faults.fix(f"did you mean `{close[0]}`?", (*opener[2:], close[0]))
        place.faults.add("FS121", *opener[2:], fix, before=opener[1])
        at = place.tokens.index(opener)
        return [*place.tokens[:at], (HEADERS[close[0]], close[0], *opener[2:]), *place.tokens[at + 1 :]]
    before = place.before[1] if place.before else ""
    place.faults.add("FS121", start, end, place.faults.fix("remove it", (start, end, "")), before=before)
    return None


RULES = (
    Rule(_is_outside, _report_outside),
    Rule(_is_on, _report_on),
    Rule(_is_under, _report_under),
    Rule(_is_behind, _report_behind),
    Rule(_is_joined, _report_joined),
    Rule(_lacks_equals, _report_equals),
    Rule(_lacks_bracket, _report_bracket),
    Rule(_is_unopened, _report_unopened),
    Rule(_lacks_colon, _report_colon),
    Rule(_lacks_quotes, _report_quotes),
    Rule(_lacks_name, _report_name),
    Rule(_lacks_value, _report_value),
    Rule(_is_colon, _report_extra_colon),
)
"""The kinds of faults; the first that fits tells."""
