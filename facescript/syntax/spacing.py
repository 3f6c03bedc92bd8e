"""Tokens with a space too few or too many, to faults: minus signs, units, decimal commas, words that touch."""

from __future__ import annotations

from facescript.syntax.faults import Faults

Token = tuple[str, str, int, int]
"""A terminal of the grammar, its text, and its start and end in the source."""

ENDS = frozenset(("NAME", "DOTTED", "STRING", "QUANTITY", "INTEGER", "SIZE", "COLOUR", "RPAR", "NTH"))
BEGINS = frozenset(("NAME", "DOTTED", "STRING", "QUANTITY", "INTEGER", "SIZE", "COLOUR", "LPAR"))
NUMBERS = frozenset(("QUANTITY", "INTEGER", "SIZE", "NTH"))
TIMES = frozenset(("DOTTED", "QUANTITY", "RPAR"))
"""What a time may end in: a negative time after it is meant as a difference, for no time is negative."""

UNITS = frozenset(("ms", "s", "deg", "cm", "m", "fps"))

LONGEST_NUMBER = 16
"""Characters of a number with its unit; longer ones are slips, and no double holds their digits."""


def suspect(tokens: list[Token], token: Token) -> bool:
    """Whether `settle` must look at a line, asked for each token with those before it; cheap, and not always right."""
    kind, text, start, end = token
    if kind in NUMBERS and end - start > LONGEST_NUMBER:
        return True
    if not tokens:
        return False
    before = tokens[-1]
    if text[0] == "-" and kind == "QUANTITY" and before[0] in TIMES:
        return True
    if before[3] == start and kind in BEGINS:
        return before[0] in ENDS or before[0] == "COMMA" or before[1] == "-"
    return text == "-" or (kind == "NAME" and text in UNITS and before[0] in NUMBERS)


def settle(tokens: list[Token], faults: Faults) -> list[Token]:
    """The tokens as meant, with a fault for each that is wrongly spaced."""
    meant: list[Token] = []
    for index, token in enumerate(tokens):
        after = tokens[index + 1][2] if index + 1 < len(tokens) else -1
        if token[0] in NUMBERS and token[3] - token[2] > LONGEST_NUMBER:
            faults.add("FS115", token[2], token[3], longest=LONGEST_NUMBER)
            meant.append(
                (token[0], "1" if token[0] == "INTEGER" else "1x1" if token[0] == "SIZE" else ".1", *token[2:])
            )
        elif token[1] == "-":
            _minus(meant, token, after, faults)
        elif meant:
            _word(meant, token, faults)
        else:
            meant.append(token)
    return meant


def _minus(meant: list[Token], token: Token, after: int, faults: Faults) -> None:
    start, end = token[2:]
    touches = bool(meant) and meant[-1][3] == start
    if touches or after == end:
        spaced = (" " if touches else "") + "-" + (" " if after == end else "")
        faults.add("FS111", start, end, faults.fix("write a space on both sides", (start, end, spaced)))
    meant.append(token)


def _word(meant: list[Token], token: Token, faults: Faults) -> None:
    """Add a token that is not the first and no minus sign."""
    kind, text, start, end = token
    before = meant[-1]
    touches = before[3] == start
    if kind == "NAME" and text in UNITS and before[0] in NUMBERS and before[1][-1].isdigit():
        fix = faults.fix(f"write `{before[1]}{text}`", (before[3], start, ""))
        faults.add("FS113", before[2], end, fix, unit=text)
        meant[-1] = ("QUANTITY", before[1] + text, before[2], end)
    elif text[0] == "-" and ((touches and before[0] in ENDS) or (before[0] in TIMES and text.endswith("s"))):
        spaced = " - " if touches else "- "
        faults.add("FS111", start, start + 1, faults.fix("write a space on both sides", (start, start + 1, spaced)))
        meant += [("OPERATOR", "-", start, start + 1), (kind, text[1:], start + 1, end)]
    elif touches and before[0] == "COMMA" and kind in NUMBERS and _decimal(meant):
        whole = meant[-2]
        fix = faults.fix(f"write `{whole[1]}.{text}`", (before[2], before[3], "."))
        faults.add("FS114", whole[2], end, fix, written=f"{whole[1]},{text}")
        meant[-2:] = [("QUANTITY", f"{whole[1]}.{text}", whole[2], end)]
    else:
        if touches and kind in BEGINS and before[0] in ENDS:
            fix = faults.fix("write a space between them", (start, start, " "))
            faults.add("FS112", before[2], end, fix, first=before[1], second=text)
        meant.append(token)


def _decimal(meant: list[Token]) -> bool:
    """Whether the tokens end in a bare number and a comma that touches it."""
    return len(meant) > 1 and meant[-2][0] == "INTEGER" and meant[-2][3] == meant[-1][2]
