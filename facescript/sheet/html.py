"""A sheet to an `.html`: a page with the sheet's SVG in it, which needs nothing else."""

from __future__ import annotations

from html import escape
from pathlib import Path

from lxml import etree

from facescript.sheet.page import Page
from facescript.sheet.svg import sheet

HEAD = """\
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{title}</title>
<style>
body {{ margin: 0; background: #fff }}
body > svg {{ display: block; margin: auto; max-width: 100%; height: auto }}
</style>
<body>
"""


def write_html(page: Page, path: Path) -> None:
    """One self-contained file, the same bytes each time."""
    svg = etree.tostring(sheet(page), encoding="unicode")
    path.write_text(f"{HEAD.format(title=escape(page.drawing.title))}{svg}\n</body>\n</html>\n", "utf-8", newline="\n")
