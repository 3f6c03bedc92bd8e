"""All pages of the site, from `docs/`, from elsewhere in the checkout and from tables; and where each stands."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from facescript.diagnostics.catalogue.model import Entry
from facescript.resolve.words import VERBS
from website.page import Page
from website.pages import (
    channels,
    diagnostics,
    examples,
    expressions,
    index,
    kinds,
    lives,
    muscles,
    outputs,
    settings,
    shapes,
    statements,
    values,
    words,
)

ROOT = Path(__file__).parents[2]

TABLES = (
    index,
    statements,
    words,
    settings,
    values,
    expressions,
    muscles,
    channels,
    shapes,
    lives,
    kinds,
    outputs,
    diagnostics,
    examples,
)
"""What makes pages from tables."""

BORROWED = {
    "index.md": ("Home", "README.md"),
    "contributing/architecture.md": ("How it is built", "ARCHITECTURE.md"),
    "contributing/changes.md": ("Changes", "CHANGELOG.md"),
}
"""Pages that lie elsewhere in the checkout."""

LICENCE = "contributing/licence.md"

Nav = list[Any]


@cache
def made() -> tuple[Page, ...]:
    """Every page that does not lie in `docs/`."""
    borrowed = (Page(uri, title, (ROOT / home).read_text("utf-8"), home) for uri, (title, home) in BORROWED.items())
    notice = (ROOT / "NOTICE").read_text("utf-8")
    licence = Page(LICENCE, "Licence", f"# Licence\n\n```text\n{notice}```\n")
    return (*borrowed, licence, *(page for table in TABLES for page in table.pages()))


@cache
def written() -> tuple[Page, ...]:
    """Every page that lies in `docs/`, but for those that made ones replace."""
    docs = ROOT / "docs"
    replaced = {page.uri for page in made()}
    found = (path.relative_to(docs).as_posix() for path in sorted(docs.rglob("*.md")) if "website" not in path.parts)
    return tuple(Page(uri, "", (docs / uri).read_text("utf-8"), f"docs/{uri}") for uri in found if uri not in replaced)


HOWTO = "announcer audio-book kiosk stimuli avatar-data two-faces own-face programs notebook".split()
DESK = "editors writing preview playground trouble faq".split()
REFERENCE = (
    *"blocks definitions modifiers film face values targets expressions units".split(),
    *"muscles channels shapes lives actions".split(),
)


def nav() -> Nav:
    """The navigation; a page of `docs/` that is not written yet is left out."""
    there = {page.uri: page.title for page in (*made(), *written())}
    return [
        {"Home": "index.md"},
        *_section(there, "Tutorial", ["tutorial.md"]),
        *_section(there, "How-tos", [*(f"howto/{name}.md" for name in HOWTO), *(f"{name}.md" for name in DESK)]),
        *_section(there, "Live", ["live.md"]),
        *_section(there, "Language", ["language.md", "speech.md", "faces.md", "gallery.md"]),
        {"Reference": _reference(there)},
        {"Diagnostics": _diagnostics()},
        *_section(there, "How it moves", ["how-it-moves.md", "motion.md"]),
        *_section(there, "For programs", ["summary.md", "python.md", "backends.md"]),
        *_section(there, "Contributing", [*list(BORROWED)[1:], LICENCE]),
    ]


def _section(there: dict[str, str], title: str, uris: list[str]) -> Iterator[dict[str, Any]]:
    found = [uri for uri in uris if uri in there]
    if found:
        yield {title: found[0] if len(uris) == 1 else [_titled(there, uri) for uri in found]}


def _titled(there: dict[str, str], uri: str) -> Any:
    """A page under its own title, one of `docs/` under its first heading."""
    return {there[uri]: uri} if there[uri] else uri


def _reference(there: dict[str, str]) -> Nav:
    pages = [f"reference/{name}.md" for name in (*REFERENCE, "kinds", "voices", "outputs")]
    shown = [page.uri for page in examples.pages()]
    return [
        "reference/index.md",
        {"Statements": [f"{statements.FOLDER}/index.md", *(f"{statements.FOLDER}/{verb}.md" for verb in VERBS)]},
        *(_titled(there, uri) for uri in pages),
        {"Examples": [_titled(there, uri) for uri in shown]},
    ]


def _diagnostics() -> Nav:
    families = (
        {f"FS{digit}xx {title}": [_code(entry) for entry in diagnostics.of_family(digit)]}
        for digit, title in diagnostics.families()
    )
    return ["diagnostics.md", *families]


def _code(entry: Entry) -> dict[str, str]:
    return {f"{entry.code} {entry.name}": f"diagnostics/{entry.code}.md"}
