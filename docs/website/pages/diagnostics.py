"""The sections of `docs/diagnostics.md` to a page a code, and an index of them in its place."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from make_diagnostics import FAMILIES

from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.catalogue.model import Entry
from website.page import Page, table

SOURCE = Path(__file__).parents[2] / "diagnostics.md"

CODE = re.compile(r"FS\d{3}")

SECTION = re.compile(r"^### (FS\d{3}) .*\n", re.MULTILINE)


def pages() -> Iterator[Page]:
    entries, told = [entry for _, entry in sorted(CATALOGUE.items())], _told()
    yield Page("diagnostics.md", "All codes", "\n".join([INDEX, *(_family(*each, entries) for each in families())]))
    for entry in entries:
        yield Page(f"diagnostics/{entry.code}.md", f"{entry.code} {entry.name}", _text(entry, told[entry.code]))


INDEX = """\
# Diagnostics

What `facescript` tells an author: a code, a sentence, the exact place, and a fix where one is known. An **error**
stands in the way of a build. A **warning** does not: something comes out, and perhaps not what was meant. A
**hint** is shown by `check` alone. Each code has a page, with a script that brings it about and one that does it
well.
"""


def families() -> list[tuple[str, str]]:
    """The first digits of the codes, and what they are about."""
    return list(FAMILIES.items())


def of_family(digit: str) -> list[Entry]:
    return [entry for code, entry in sorted(CATALOGUE.items()) if code[2] == digit]


def _family(digit: str, title: str, entries: list[Entry]) -> str:
    rows = (
        (f"[{entry.code}](diagnostics/{entry.code}.md)", entry.name.replace("-", " "), str(entry.severity))
        for entry in entries
        if entry.code[2] == digit
    )
    return f"## FS{digit}xx: {title}\n\n{table(('code', 'is', 'severity'), rows)}"


def _told() -> dict[str, str]:
    """What the one page says under each code."""
    text = re.sub(r"^## .*\n", "", SOURCE.read_text("utf-8"), flags=re.MULTILINE)
    _, *parts = SECTION.split(text)
    return dict(zip(parts[::2], parts[1::2], strict=True))


def _text(entry: Entry, told: str) -> str:
    related = ", ".join(f"[{each.code} {each.name}]({each.code}.md)" for each in related_to(entry))
    parts = [
        f"# {entry.code} {entry.name}\n",
        _titled(told.strip()) + "\n",
        f"## Related\n\n{related}.\n" if related else "",
    ]
    return "\n".join(filter(None, parts))


def _titled(told: str) -> str:
    """With a heading before what brings the code about, and one before what does it well."""
    found = re.search(r"^```(?:face-bad)?$", told, re.MULTILINE)
    if found is None:
        return told
    said, shown = told[: found.start()], told[found.start() :].replace("\n```face\n", f"\n{WELL}\n\n```face\n", 1)
    return f"{said}{BADLY}\n\n{shown}"


BADLY, WELL = "## This brings it about", "## This does it well"


def related_to(entry: Entry) -> list[Entry]:
    """Codes that its texts name or that name it, then those of its family that share a word of its name."""
    words = set(entry.name.split("-"))
    others = [each for each in CATALOGUE.values() if each.code != entry.code]
    named = [each for each in others if each.code in _named(entry) or entry.code in _named(each)]
    alike = [each for each in others if each.code[2] == entry.code[2] and words & set(each.name.split("-"))]
    return list({each.code: each for each in (*named, *alike)}.values())[:8]


def _named(entry: Entry) -> set[str]:
    return set(CODE.findall(f"{entry.sentence} {entry.why} {entry.good}"))
