"""Signs with which no terminal of the grammar begins, to faults; look-alikes are mended at equal length."""

from __future__ import annotations

import re

from facescript.syntax.faults import Faults

QUOTES = "“”„‟«»‹›‘’‚‛「」『』＂＇'`"
"""Signs that authors take for the quotation mark."""

MEANT = {
    **{chr(code + 0xFEE0): chr(code) for code in range(0x21, 0x7F)},
    **dict.fromkeys("‐‑‒–—―−", "-"),
    **dict.fromkeys("、،", ","),
    **dict.fromkeys("。．", "."),
    **dict.fromkeys("【〔", "("),
    **dict.fromkeys("】〕", ")"),
    **dict.fromkeys("×✕", "*"),
    **dict.fromkeys("÷⁄", "/"),
    **dict.fromkeys("٪", "%"),
    **dict.fromkeys("∶", ":"),
    **dict.fromkeys(
        "\u00a0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f\u3000", " "
    ),
}
"""Look-alikes and the sign of the language that they stand for."""

HIDDEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\ud800-\udfff]")
"""Characters that steer or hide and are never drawn."""

_QUOTES = re.escape(QUOTES)
_ALIKE = re.escape("".join(sign for sign in MEANT if sign not in QUOTES))
PATTERN = "|".join(
    (
        r'(?P<TEXT_OPEN>"(?:\\.|[^"\\])*+\\?)',
        rf'(?P<QUOTED>[{_QUOTES}][^"{_QUOTES}]*+[{_QUOTES}]?)',
        r"(?P<TAB>\t+)",
        rf"(?P<ALIKE>[{_ALIKE}]+)",
        r"(?P<HASH>#.*)",
        r"(?P<NUMBER>-?\.?[0-9][\w.%]*)",
        r"(?P<UNKNOWN>.)",
    )
)
"""What may stand where no terminal of the grammar does; it follows those in one regular expression."""

KINDS = frozenset(("TEXT_OPEN", "QUOTED", "TAB", "ALIKE", "HASH", "NUMBER", "UNKNOWN"))

Odd = tuple[str, int, int]
"""Something found by `PATTERN`: its group, start and end in the line."""


def mend(line: str, begin: int, odd: list[Odd], faults: Faults) -> str | None:
    """Report what is odd in a line that begins at offset `begin`; the line as meant, None where that is not known."""
    mended = line
    for kind, start, end in odd:
        replaced = _REPORTS[kind](line, start, end, begin, faults)
        if replaced is None:
            return None
        mended = mended[:start] + replaced + mended[end:]
    return mended


def strange_letters(line: str, start: int, end: int) -> list[Odd]:
    """What of a name found at start..end is no letter, mark or digit, or a full-width one; quoted words are free."""
    found: list[Odd] = []
    quoted = False
    for at in range(start, end):
        sign = line[at]
        if sign == '"':
            quoted = not quoted
        elif quoted or sign.isascii():
            continue
        elif sign in MEANT:
            found.append(("ALIKE", at, at + 1))
        elif not ("a" + sign).isidentifier():
            found.append(("UNKNOWN", at, at + 1))
    return found


def report_hidden(line: str, begin: int, texts: list[tuple[int, int]], comment: int, faults: Faults) -> bool:
    """Report what is never drawn; True where it stands in the script itself.

    Texts may steer their direction, comments join emoji.

    `texts` are start and end of each text in the line, `comment` is where its comment begins, else its length.
    """
    spoilt = False
    for match in HIDDEN.finditer(line):
        at, sign = match.start(), match.group()
        inside = any(start < at < end for start, end in texts)
        if (inside and "\u200b" <= sign <= "\u2069") or (at > comment and sign in "\u200b\u200c\u200d\u2060"):
            continue
        place = begin + at
        faults.add("FS106", place, place + 1, faults.fix("remove it", (place, place + 1, "")), sign=shown(sign))
        spoilt = spoilt or at < comment
    return spoilt


def shown(signs: str) -> str:
    """Signs as a message can show them: what is not drawn by its code point."""
    return "".join(sign if sign.isprintable() and not sign.isspace() else f"U+{ord(sign):04X}" for sign in signs)


def _quoted(line: str, start: int, end: int, begin: int, faults: Faults) -> str | None:
    first, last = begin + start, begin + end
    if end - start < 2 or line[end - 1] not in QUOTES:
        faults.add("FS102", first, first + 1, faults.fix('write `"`', (first, first + 1, '"')), sign=line[start])
        return None
    fix = faults.fix('write `"` on both sides', (first, first + 1, '"'), (last - 1, last, '"'))
    faults.add("FS102", first, last, fix, sign=line[start])
    return f'"{line[start + 1 : end - 1]}"'


def _tab(line: str, start: int, end: int, begin: int, faults: Faults) -> str:
    faults.add("FS101", begin + start, begin + end, faults.fix("write a space", (begin + start, begin + end, " ")))
    return " " * (end - start)


def _alike(line: str, start: int, end: int, begin: int, faults: Faults) -> str:
    written = line[start:end]
    meant = "".join(MEANT[sign] for sign in written)
    fix = faults.fix(f"write `{meant}`", (begin + start, begin + end, meant))
    faults.add(
        "FS103",
        begin + start,
        begin + end,
        fix,
        sign=shown(written),
        meant=f"`{meant}`" if meant.strip() else "a space",
    )
    return meant


def _hash(line: str, start: int, end: int, begin: int, faults: Faults) -> str | None:
    """`#12` in a line is a colour gone wrong, `#note` a comment without its space."""
    place = begin + start
    digits = re.split(r"\W", line[start + 1 : end], maxsplit=1)[0]
    hexadecimal = bool(re.fullmatch("[0-9a-fA-F]+", digits))
    if not line[:start].strip() or not (hexadecimal or re.search("[0-9]", digits)):
        faults.add("FS109", place, place + 1, faults.fix("write a space after `#`", (place + 1, place + 1, " ")))
        return ""
    fix = None
    if hexadecimal and len(digits) in (3, 4):
        doubled = "".join(sign * 2 for sign in digits)
        fix = faults.fix(f"write `#{doubled}`", (place + 1, place + 1 + len(digits), doubled))
    faults.add("FS110", place, place + 1 + len(digits), fix, colour="#" + digits)
    return None


def _text_open(line: str, start: int, end: int, begin: int, faults: Faults) -> None:
    fix = faults.fix('write `"` at the end of the line', (begin + end, begin + end, '"'))
    faults.add("FS104", begin + start, begin + end, fix)


def _number(line: str, start: int, end: int, begin: int, faults: Faults) -> None:
    written = line[start:end]
    parts = re.fullmatch(r"(-?)([0-9_]*)(?:\.([0-9_]*))?([^\W\d_]+|%)?", written)
    fix = None
    if parts:
        sign, whole, part, unit = (piece or "" for piece in parts.groups())
        meant = sign + (whole.replace("_", "") or "0") + (f".{part}".replace("_", "") if part else "") + unit
        fix = faults.fix(f"write `{meant}`", (begin + start, begin + end, meant)) if meant != written else None
    faults.add("FS114", begin + start, begin + end, fix, written=written)


def _unknown(line: str, start: int, end: int, begin: int, faults: Faults) -> None:
    sign, place = line[start], begin + start
    if HIDDEN.match(sign):
        return
    before = line[:start].rstrip()
    if sign == "%" and before[-1:].isdigit():
        fix = faults.fix("write the sign touching its number", (begin + len(before), place, ""))
        faults.add("FS113", begin + len(before) - 1, place + 1, fix, unit="%")
        return
    faults.add("FS105", place, place + 1, faults.fix("remove it", (place, place + 1, "")), sign=shown(sign))


_REPORTS = {
    "TEXT_OPEN": _text_open,
    "QUOTED": _quoted,
    "TAB": _tab,
    "ALIKE": _alike,
    "HASH": _hash,
    "NUMBER": _number,
    "UNKNOWN": _unknown,
}
