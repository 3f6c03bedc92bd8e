"""A page of the site as text, and the forms that generated pages are written in."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

EXAMPLES = Path(__file__).with_name("examples.md")


@dataclass(frozen=True, slots=True)
class Page:
    """Where a page is in the site, what the navigation calls it, its Markdown, and where that lies in the checkout
    ("" for a page that is made: its links are those of the site)."""

    uri: str
    title: str
    text: str
    home: str = ""


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; a `|` in a cell is written so that it stays one."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |\n" for line in lines)


def anchor(name: str) -> str:
    """`head-yaw` of `head.yaw`."""
    return name.replace(".", "-").replace(" ", "-").lower()


def heading(name: str, level: int = 2) -> str:
    return f"{'#' * level} `{name}` {{#{anchor(name)}}}\n"


def sentence(text: str) -> str:
    """With a capital and a point."""
    return f"{text[:1].upper()}{text[1:].rstrip('.')}."


def block(script: str, word: str = "face") -> str:
    return f"```{word}\n{script.rstrip()}\n```\n"


def shown(script: str, alt: str, wide: int = 200, at: str = "900ms") -> str:
    """A still of a script that is not shown itself."""
    return f'```face-picture {{picture="{at}" wide="{wide}" alt="{alt}"}}\n{script.rstrip()}\n```\n'


def row(cells: Iterable[str]) -> str:
    """Pictures and words beside each other, as many as there is room for: a list, an entry each."""
    items = "\n".join(f'<div markdown="1">\n\n{cell.strip()}\n\n</div>\n' for cell in cells)
    return f'<div class="shown" markdown="1">\n\n{items}\n</div>\n'


PORTRAIT = "film 400x400\nface x = {kind}\n    life still\nview x {near}\n{line}\nwait 2s\n"
"""One face that does one thing, at rest besides."""

NEAR, WHOLE = "150%", "100%"
"""How near a portrait is: the face alone, or head and shoulders."""


def portrait(line: str, alt: str, kind: str = "woman", wide: int = 200, near: str = NEAR) -> str:
    return shown(PORTRAIT.format(kind=kind, line=line, near=near), alt, wide)


@cache
def examples() -> dict[str, str]:
    """What `examples.md` has under each name."""
    parts = re.split(r"^## (.+)\n", EXAMPLES.read_text("utf-8"), flags=re.MULTILINE)
    return {name: text.strip() + "\n" for name, text in zip(parts[1::2], parts[2::2], strict=True)}
