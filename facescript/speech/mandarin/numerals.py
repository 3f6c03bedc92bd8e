"""Figures to the Chinese characters that are read for them."""

from __future__ import annotations

DIGITS = "零一二三四五六七八九"
SMALL = ("", "十", "百", "千")
LARGE = ("", "万", "亿", "万亿", "亿亿")
LONGEST = 16
"""Longer numbers are read figure by figure."""


def chinese(figures: str, year: bool = False) -> str:
    """`2021` as 二千零二十一, with `year` as 二零二一; `1,000.5` as 一千点五. Takes decimal figures, `,` and `.`."""
    whole, _, decimals = figures.replace(",", "").replace("，", "").partition(".")
    spelt = year or len(whole) > LONGEST or (len(whole) > 1 and whole[0] == "0")
    read = _spelt(whole) if spelt else _counted(int(whole or "0"))
    return f"{read}点{_spelt(decimals)}" if decimals else read


def _spelt(figures: str) -> str:
    return "".join(DIGITS[int(figure)] for figure in figures)


def _counted(number: int) -> str:
    groups: list[int] = []
    while number or not groups:
        number, group = divmod(number, 10_000)
        groups.append(group)
    read, zero = "", False
    for place in reversed(range(len(groups))):
        group = groups[place]
        if group:
            read += (DIGITS[0] if read and (zero or group < 1000) else "") + _group(group) + LARGE[place]
        zero = group == 0
    return read.removeprefix("一") if read.startswith("一十") else read or DIGITS[0]


def _group(group: int) -> str:
    """1 to 9999."""
    read, zero = "", False
    for place in (3, 2, 1, 0):
        digit = group // 10**place % 10
        if digit:
            read += (DIGITS[0] if zero and read else "") + DIGITS[digit] + SMALL[place]
        zero = digit == 0
    return read
