"""Praat's TextGrid, long or short, to times and back."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from facescript.speech.model import PhoneTime
from facescript.speech.timing.alphabets import is_silence, is_unspoken, looks_like_phones, to_ipa
from facescript.speech.timing.times import MOST, TimedMark, TimedWord, Times, moment, stretch, times_of, unusable

WORDS, PHONES, MARKS, CONFIDENCE = "words", "phones", "marks", "confidence"
"""The names of the tiers that are written."""

_WORD_NAMES = re.compile(r"\b(words?|wrd|ort(ho(graphy)?)?|tokens?|transcription|ort-mau)\b", re.I)
_PHONE_NAMES = re.compile(r"\b(phone[ms]?e?s?|phons?|phn|segments?|seg|sounds?|mau|sampa|ipa)\b", re.I)
_TOKEN = re.compile(r'!.*|"(?P<text>(?:[^"]|"")*)"|<(?P<flag>[^>\s]*)>|(?P<open>")|(?P<other>[^\s"<]\S*|<)')
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?%?")

LEAST = 1e-4
"""Seconds of the shortest interval that is written: Praat refuses those of none."""


@dataclass(frozen=True, slots=True)
class Tier:
    """A tier: `entries` are (start, end, label); in a tier of points both are the moment."""

    name: str
    points: bool
    entries: tuple[tuple[float, float, str], ...]

    @property
    def labels(self) -> list[str]:
        return [label for _, _, label in self.entries]


class _Values:
    """The free-standing values of a TextGrid: numbers, texts in quotes and flags; all else is there for people."""

    def __init__(self, text: str) -> None:
        self._ends = [found.start() for found in re.finditer("\n", text)]
        self._found = self._values(text)
        self.line = 1

    def _values(self, text: str) -> Iterator[str | float | None]:
        for found in _TOKEN.finditer(text):
            self.line = bisect_right(self._ends, found.start()) + 1
            if found["open"] is not None:
                raise unusable("a text has no closing quote", self.line)
            if found["text"] is not None:
                yield found["text"].replace('""', '"')
            elif found["flag"] is not None:
                yield None
            elif found["other"] is not None and _NUMBER.fullmatch(found["other"]):
                yield float(found["other"].rstrip("%"))

    def text(self) -> str:
        value = next(self._found, 0.0)
        if not isinstance(value, str):
            raise unusable("the TextGrid is broken off, or a text is missing", self.line)
        return value

    def number(self) -> float:
        value = next(self._found, "")
        if not isinstance(value, float):
            raise unusable("the TextGrid is broken off, or a number is missing", self.line)
        return value

    def count(self) -> int:
        value = self.number()
        if not 0 <= value <= MOST or value != int(value):
            raise unusable(f"a count of {value:g} cannot be", self.line)
        return int(value)

    def flag(self) -> None:
        if next(self._found, "") is not None:
            raise unusable("`<exists>` is missing", self.line)


def is_textgrid(text: str) -> bool:
    head = text[:400]
    return "ooTextFile" in head and "TextGrid" in head


def read_textgrid(text: str) -> Times:
    """The words, phones and marks of the tiers that look like them. Raises `VoiceFailure`."""
    tiers, duration = _tiers(text)
    words, phones = _chosen(tiers)
    marks = [tier for tier in tiers if tier.points]
    return times_of(
        _words(words, next((tier for tier in tiers if tier.name == CONFIDENCE), None)),
        _phones(phones),
        [TimedMark(label, time) for tier in marks for time, _, label in tier.entries if label.strip()],
        duration,
    )


def _tiers(text: str) -> tuple[list[Tier], float]:
    values = _Values(text)
    if values.text() not in ("ooTextFile", "ooTextFile short") or values.text() != "TextGrid":
        raise unusable("it is no TextGrid", 1)
    first, last = values.number(), values.number()
    values.flag()
    tiers = [_tier(values, first) for _ in range(values.count())]
    return tiers, moment(last - first)


def _tier(values: _Values, origin: float) -> Tier:
    kind = values.text()
    if kind not in ("IntervalTier", "TextTier"):
        raise unusable(f"`{kind[:40]}` is no kind of tier", values.line)
    name = values.text()
    values.number(), values.number()
    points = kind == "TextTier"
    entries = []
    for _ in range(values.count()):
        start = values.number() - origin
        end = start if points else values.number() - origin
        entries.append((*stretch(start, end, values.line), values.text()))
    return Tier(name, points, tuple(entries))


def _chosen(tiers: Sequence[Tier]) -> tuple[Tier | None, Tier | None]:
    """The tiers of words and of phones: by their names, else by what is in them."""
    spoken = [
        tier for tier in tiers if not tier.points and tier.name != CONFIDENCE and any(map(str.strip, tier.labels))
    ]
    phones = next((tier for tier in spoken if _PHONE_NAMES.search(tier.name)), None)
    words = next((tier for tier in spoken if tier is not phones and _WORD_NAMES.search(tier.name)), None)
    rest = [tier for tier in spoken if tier not in (words, phones)]
    if phones is None:
        phones = next((tier for tier in rest if looks_like_phones(tier.labels)), None)
    if words is None:
        rest = [tier for tier in rest if tier is not phones and not looks_like_phones(tier.labels)]
        words = _finest(rest, phones)
    return words, phones


def _finest(tiers: Sequence[Tier], phones: Tier | None) -> Tier | None:
    """The tier of most labels, but not of more than there are phones."""
    fewer = [tier for tier in tiers if phones is None or _sounding(tier) <= _sounding(phones)]
    return max(fewer, key=_sounding, default=None)


def _sounding(tier: Tier) -> int:
    return sum(not is_silence(label) for label in tier.labels)


def _words(tier: Tier | None, confidence: Tier | None) -> Iterator[TimedWord]:
    sure = {round(start, 4): label for start, _, label in confidence.entries} if confidence else {}
    for start, end, label in tier.entries if tier else ():
        if not is_unspoken(label):
            yield TimedWord(" ".join(label.split()), start, end, _share(sure.get(round(start, 4), "1")))


def _share(text: str) -> float:
    try:
        return min(max(float(text), 0.0), 1.0)
    except ValueError:
        return 1.0


def _phones(tier: Tier | None) -> Iterator[PhoneTime]:
    if tier:
        for (start, end, _), (symbol, stress) in zip(tier.entries, to_ipa(tier.labels), strict=True):
            yield PhoneTime(symbol, start, end, stress)


def write_textgrid(times: Times) -> str:
    """A long TextGrid: tiers of words and phones, of confidence where any is below 1, of marks where there are."""
    tiers = [_intervals(WORDS, [(word.start, word.end, word.text) for word in times.words], times.duration)]
    if times.phones:
        labels = [(p.start, p.end, f"ˈ{p.symbol}" if p.stress else p.symbol) for p in times.phones if p.symbol]
        tiers.append(_intervals(PHONES, labels, times.duration))
    if any(word.confidence < 1 for word in times.words):
        sure = [(word.start, word.end, f"{word.confidence:.3f}") for word in times.words]
        tiers.append(_intervals(CONFIDENCE, sure, times.duration))
    if times.marks:
        tiers.append(Tier(MARKS, True, tuple((mark.time, mark.time, mark.name) for mark in times.marks)))
    last = max([times.duration, *(tier.entries[-1][1] for tier in tiers if tier.entries)])
    head = ['File type = "ooTextFile"', 'Object class = "TextGrid"', "", "xmin = 0", f"xmax = {_seconds(last)}"]
    body = [line for number, tier in enumerate(tiers, 1) for line in _tier_lines(number, tier, last)]
    return "\n".join([*head, "tiers? <exists>", f"size = {len(tiers)}", "item []:", *body, ""])


def _intervals(name: str, entries: Iterable[tuple[float, float, str]], duration: float) -> Tier:
    """A tier without gaps, every interval of some length."""
    found: list[tuple[float, float, str]] = []
    at = 0.0
    for start, end, label in entries:
        first = max(start, at)
        if first - at > LEAST:
            found.append((at, first, ""))
        else:
            first = at
        at = max(end, first + LEAST)
        found.append((first, at, label))
    if duration - at > LEAST or not found:
        found.append((at, max(duration, at + LEAST), ""))
    return Tier(name, False, tuple(found))


def _tier_lines(number: int, tier: Tier, last: float) -> Iterator[str]:
    kind, entry = ("TextTier", "points") if tier.points else ("IntervalTier", "intervals")
    yield f"    item [{number}]:"
    yield from (f'        class = "{kind}"', f"        name = {_quoted(tier.name)}", "        xmin = 0")
    yield from (f"        xmax = {_seconds(last)}", f"        {entry}: size = {len(tier.entries)}")
    for index, (start, end, label) in enumerate(tier.entries, 1):
        yield f"        {entry} [{index}]:"
        if tier.points:
            yield from (f"            number = {_seconds(start)}", f"            mark = {_quoted(label)}")
        else:
            end = last if index == len(tier.entries) else end
            yield from (f"            xmin = {_seconds(start)}", f"            xmax = {_seconds(end)}")
            yield f"            text = {_quoted(label)}"


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"'


def _seconds(seconds: float) -> str:
    return f"{seconds:.6f}".rstrip("0").rstrip(".")
