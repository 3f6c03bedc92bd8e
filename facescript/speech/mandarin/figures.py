"""Figures in a Mandarin text, with their signs and units, to the Chinese characters that are read for them."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping

from facescript.speech.mandarin.numerals import chinese

UNITS: Mapping[str, str] = {
    "km/h": "公里每小时", "m/s": "米每秒", "km²": "平方公里", "m²": "平方米", "m³": "立方米", "kWh": "千瓦时",
    "km": "公里", "cm": "厘米", "mm": "毫米", "m": "米", "kg": "公斤", "mg": "毫克", "g": "克", "t": "吨",
    "ml": "毫升", "mL": "毫升", "l": "升", "L": "升", "℃": "摄氏度", "°C": "摄氏度", "℉": "华氏度", "°F": "华氏度",
    "°": "度", "ms": "毫秒", "min": "分钟", "s": "秒", "h": "小时", "kHz": "千赫", "Hz": "赫兹", "kW": "千瓦",
    "W": "瓦", "V": "伏", "元": "元",
}  # fmt: skip
"""Units behind a number, where no letter follows."""

MONEY = {"￥": "元", "¥": "元", "$": "美元", "＄": "美元", "€": "欧元", "£": "英镑"}
SIGNS = {"+": "加", "×": "乘", "*": "乘", "÷": "除以", "=": "等于", "-": "减", "−": "减"}

PAIR = "个個只隻本位次天岁歲块塊张張条條件点點倍杯家种種年周双雙把辆輛名层層口座首头頭棵朵碗瓶封句篇份"
"""Measure words before which a lone 2 is 两."""

N = r"\d+(?:,\d{3})*(?:\.\d+)?"
TELEPHONE = r"(?:86[- ]?)?1[3-9]\d(?:[- ]?\d{4}){2}|0\d{2,3}-\d{7,8}|400-?\d{3}-?\d{4}"
AMOUNT = "|".join(map(re.escape, sorted(UNITS, key=len, reverse=True)))


def _telephone(match: re.Match[str]) -> str:
    return _spelt(match[0]).replace("一", "幺")


def _spelt(figures: str) -> str:
    return "".join(chinese(figure) for figure in figures if figure.isdecimal())


def _date(match: re.Match[str]) -> str:
    return f"{_spelt(match['year'])}年{chinese(str(int(match['month'])))}月{chinese(str(int(match['day'])))}日"


def _time(match: re.Match[str]) -> str:
    hour, minute, second = (match[name] for name in ("hour", "minute", "second"))
    read = ("两" if int(hour) == 2 else chinese(str(int(hour)))) + "点"
    if int(minute) or second:
        read += ("零" if 0 < int(minute) < 10 else "") + chinese(str(int(minute))) + "分"
    return read + (chinese(str(int(second))) + "秒" if second else "")


def _fraction(match: re.Match[str]) -> str:
    return f"{chinese(match['below'])}分之{chinese(match['above'])}"


def _ratio(match: re.Match[str]) -> str:
    return f"{chinese(match['first'])}比{chinese(match['other'])}"


def _sum(match: re.Match[str]) -> str:
    parts = re.findall(rf"{N}|[-+×*÷=−]", match[0])
    return "".join(SIGNS.get(part) or chinese(part) for part in parts)


def _money(match: re.Match[str]) -> str:
    return chinese(match["number"]) + (match["large"] or "") + MONEY[match["money"]]


def _version(match: re.Match[str]) -> str:
    return "点".join(chinese(part) for part in match[0].split("."))


def _range(match: re.Match[str]) -> str:
    return f"{chinese(match['from'])}到{_amount(match)}"


def _amount(match: re.Match[str]) -> str:
    """A number with its sign, and the percentage or unit behind it."""
    number, unit = match["number"], match["unit"] or ""
    read = "两" if number == "2" and unit in ("小时", "h", "min", "km", "kg", "m", "t") else chinese(number)
    sign = "负" if match["sign"] else ""
    if unit in ("%", "％", "‰"):
        return f"{sign}{'千' if unit == '‰' else '百'}分之{read}"
    return ("零下" if sign and unit in ("℃", "°C") else sign) + read + UNITS.get(unit, "")


AFTER = rf"(?P<number>{N})(?:\s?(?P<unit>{AMOUNT}|[%％‰])(?![A-Za-z]))?"
FORMS: tuple[tuple[re.Pattern[str], Callable[[re.Match[str]], str]], ...] = tuple(
    (re.compile(form), read)
    for form, read in (
        (rf"(?:{TELEPHONE})(?![\d.])", _telephone),
        (r"(?P<year>[12]\d{3})([-/.])(?P<month>1[0-2]|0?[1-9])\2(?P<day>3[01]|[12]\d|0?[1-9])(?![\d.])", _date),
        (r"(?P<hour>2[0-4]|1\d|0?\d)[:：](?P<minute>[0-5]\d)(?:[:：](?P<second>[0-5]\d))?(?!\d)", _time),
        (r"(?P<year>\d{4})(?=\s?年)", lambda match: _spelt(match[0])),
        (rf"(?P<money>[￥¥$＄€£])\s?(?P<number>{N})(?P<large>[万亿萬億]?)", _money),
        (r"(?P<above>\d+)/(?P<below>\d+)(?![\d/])", _fraction),
        (rf"{N}(?:\s?[-+×*÷−]\s?{N}){{1,20}}\s?=\s?{N}", _sum),
        (rf"{N}(?:\s?[+×*÷]\s?{N}){{1,20}}", _sum),
        (rf"(?P<first>{N})[:：](?P<other>{N})(?![\d:])", _ratio),
        (r"\d+(?:\.\d+){2,}", _version),
        (rf"(?P<from>{N})\s?[-–~～—]\s?(?P<sign>)(?![-–—]){AFTER}", _range),
        (rf"2(?=\s?(?:[{PAIR}]|小时|小時|分钟|分鐘|公|米|[千万亿萬億]))(?!\s?年代)", lambda match: "两"),
        (rf"(?P<sign>[-−－](?=\d))?{AFTER}", _amount),
    )
)
"""Forms of figures and what reads them; the first that fits counts."""


def figures(text: str, at: int) -> tuple[int, str] | None:
    """What is read for the figures that begin at a place of a text, and where they end; None where none begin."""
    sign = text[at]
    if not (sign.isdecimal() or sign in MONEY or sign in "-−－"):
        return _lone(sign, at)
    behind = text[at - 1] if at else ""
    if sign in "-−－" and ((behind.isascii() and behind.isalnum()) or (behind and behind in "-−－")):
        return None
    for form, read in FORMS:
        match = form.match(text, at)
        if match and not (read is _date and behind == "第"):
            if behind in ("第", "初") or text[match.end() : match.end() + 1] in tuple("月日号號"):
                return (match.end(), read(match).replace("两", "二"))
            return match.end(), read(match)
    return None


def _lone(sign: str, at: int) -> tuple[int, str] | None:
    """Figures in one character: ½, ③, Ⅳ."""
    if unicodedata.category(sign) not in ("No", "Nl") or sign == "〇":
        return None
    value = unicodedata.numeric(sign)
    if value == int(value):
        return at + 1, chinese(str(int(value)))
    above, below = value.as_integer_ratio()
    return at + 1, f"{chinese(str(below))}分之{chinese(str(above))}"
