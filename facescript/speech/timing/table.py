"""Tables of words, `word,start,end,confidence`, to times and back."""

from __future__ import annotations

import csv
import io

from facescript.speech.timing.times import TimedWord, Times, moment, stretch, times_of, unusable

COLUMNS = ("word", "start", "end", "confidence")
_NAMES = {"text": "word", "label": "word", "begin": "start", "from": "start", "to": "end", "score": "confidence"}
"""Other names of the columns."""


def is_table(text: str) -> bool:
    return {"word", "start", "end"} <= set(_columns(text.split("\n", 1)[0]))


def _columns(line: str) -> list[str]:
    names = [name.strip().strip('"').lower() for name in line.split(_separator(line))]
    return [_NAMES.get(name, name) for name in names]


def _separator(line: str) -> str:
    return max("\t;,", key=line.count)


def read_table(text: str) -> Times:
    """A row a word; the first line names the columns. Raises `VoiceFailure`."""
    head = text.split("\n", 1)[0]
    columns = _columns(head)
    for name in COLUMNS[:3]:
        if name not in columns:
            raise unusable(f"the first line of the table names no column `{name}`", 1)
    reader = csv.reader(io.StringIO(text), delimiter=_separator(head))
    found = []
    try:
        for row in reader:
            if reader.line_num > 1 and any(map(str.strip, row)):
                found.append(_word(dict(zip(columns, row, strict=False)), reader.line_num))
    except csv.Error as fault:
        raise unusable(f"it is no table ({fault})", reader.line_num) from None
    return times_of(found)


def _word(row: dict[str, str], line: int) -> TimedWord:
    start, end = stretch(row.get("start"), row.get("end"), line)
    sure = row.get("confidence", "").strip()
    return TimedWord(row["word"].strip(), start, end, min(moment(sure, line), 1.0) if sure else 1.0)


def write_table(times: Times) -> str:
    """Milliseconds are kept."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    for word in times.words:
        writer.writerow((word.text, f"{word.start:.3f}", f"{word.end:.3f}", f"{word.confidence:.3f}"))
    return out.getvalue()
