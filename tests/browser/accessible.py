"""A page to what axe-core finds wrong with it for people who use it without eyes, or without a mouse."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from chromium import Page

WEB = Path(__file__).parents[2] / "editors" / "web"

ASK = """
axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) => violations.flatMap(({ id, help, nodes }) =>
  nodes.map(({ target, any }) => [id, help, target.join(" "), any[0]?.message ?? ""].join(" | "))))
"""


def faults(page: Page) -> list[str]:
    """A line each: the rule, what it asks for, the element, and what it says of it."""
    page.run(f"{_axe()};0")
    return list(page.run(ASK))


@cache
def _axe() -> str:
    """The newest that is here: of npm, which the editor is built with, or else the older one of its Python package."""
    newest = WEB / "node_modules" / "axe-core" / "axe.min.js"
    if newest.is_file():
        return newest.read_text("utf-8")
    import axe_core_python

    return (Path(axe_core_python.__file__).parent / "axe.min.js").read_text("utf-8")
