"""What is wished of a page beyond the film: its template, and whether it comes in several files."""

from __future__ import annotations

from dataclasses import dataclass

TEMPLATES = ("plain", "announcer", "book", "script")
"""Those that come with the program, each a file of its name in this folder."""


@dataclass(frozen=True, slots=True)
class PageWish:
    """`template` is one of TEMPLATES or, where `brought` is a template's text, its name; `split` asks for sound and
    motion in files of their own. `script` is the script's text, for templates that show it."""

    template: str = "plain"
    brought: str | None = None
    split: bool = False
    script: str = ""
