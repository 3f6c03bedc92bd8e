"""The catalogue of diagnostics to a page a code, and an index of them in the place of `docs/diagnostics.md`."""

from __future__ import annotations

import re
from collections.abc import Iterator

import make_diagnostics
from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.catalogue.model import Entry
from website.page import Page, table

CODE = re.compile(r"FS\d{3}")


def pages() -> Iterator[Page]:
    entries = [entry for _, entry in sorted(CATALOGUE.items())]
    yield Page("diagnostics.md", "All codes", "\n".join([INDEX, *(_family(*each, entries) for each in families())]))
    for entry in entries:
        yield Page(f"diagnostics/{entry.code}.md", f"{entry.code} {entry.name}", _text(entry))


INDEX = """\
# Diagnostics

What `facescript` tells an author: a code, a sentence, the exact place, and a fix where one is known. An **error** stands in the
way of a build. A **warning** does not: something comes out, and perhaps not what was meant. A **hint** is shown by `check` alone.
Each code has a page, with a script that brings it about and one that does it well.
"""


def families() -> list[tuple[str, str]]:
    """The first digits of the codes, and what they are about."""
    return list(make_diagnostics.FAMILIES.items())


def of_family(digit: str) -> list[Entry]:
    return [entry for code, entry in sorted(CATALOGUE.items()) if code[2] == digit]


def _family(digit: str, title: str, entries: list[Entry]) -> str:
    rows = (
        (f"[{entry.code}](diagnostics/{entry.code}.md)", entry.name.replace("-", " "), str(entry.severity))
        for entry in entries
        if entry.code[2] == digit
    )
    return f"## FS{digit}xx: {title}\n\n{table(('code', 'is', 'severity'), rows)}"


def _text(entry: Entry) -> str:
    said = f"**{str(entry.severity).capitalize()}.** {make_diagnostics.sentence(entry)}\n"
    parts = [f"# {entry.code} {entry.name}\n", said, f"{entry.why}\n" if entry.why else "", *_scripts(entry)]
    related = ", ".join(f"[{each.code} {each.name}]({each.code}.md)" for each in related_to(entry))
    return "\n".join([*filter(None, parts), f"## Related\n\n{related}.\n" if related else ""])


def _scripts(entry: Entry) -> Iterator[str]:
    """What brings the code about, and what does it well."""
    if entry.stage == "command":
        command = make_diagnostics.block("console", f"$ facescript {' '.join(entry.command)}")
        yield f"## This brings it about\n\n{command}"
    elif entry.stage == "unforced":
        yield "No script brings it about: it tells of a fault of the machine.\n"
    else:
        yield f"## This brings it about\n\n{make_diagnostics.block('face-bad', entry.bad)}"
        yield f"## This does it well\n\n{make_diagnostics.block('face', entry.good)}"
        yield from make_diagnostics.files(entry)


def related_to(entry: Entry) -> list[Entry]:
    """Codes that its texts name or that name it, then those of its family that share a word of its name."""
    words = set(entry.name.split("-"))
    others = [each for each in CATALOGUE.values() if each.code != entry.code]
    named = [each for each in others if each.code in _named(entry) or entry.code in _named(each)]
    alike = [each for each in others if each.code[2] == entry.code[2] and words & set(each.name.split("-"))]
    return list({each.code: each for each in (*named, *alike)}.values())[:8]


def _named(entry: Entry) -> set[str]:
    return set(CODE.findall(f"{entry.sentence} {entry.why} {entry.good}"))
