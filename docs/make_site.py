"""The manual to a site: what MkDocs calls while it builds (`hooks` of `website/mkdocs.yml`), for `make site`."""

from __future__ import annotations

import sys
from html import escape
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))

from PIL import Image
from website import fences, pictures, site
from website.draw import calm
from website.lexer import register
from website.links import coded, relative, sited
from website.page import Page

ROOT = Path(__file__).parents[1]
MADE = "pictures/made"
"""Where the pictures of the build are in the site."""

Config, Files = Any, Any
"""MkDocs's own; its types are not here where the checks run."""


def on_config(config: Config) -> Config:
    """Colours for scripts, and the navigation."""
    register()
    config["nav"] = site.nav()
    return config


def on_files(files: Files, config: Config) -> Files:
    """Add the pages that are made, and the pictures that pages ask for."""
    from mkdocs.structure.files import File

    def add(uri: str, **source: Any) -> None:
        if (there := files.get_file_from_path(uri)) is not None:
            files.remove(there)
        files.append(File.generated(config, uri, **source))

    for page in site.made():
        add(page.uri, content=page.text)
    shown = [picture for page in (*site.made(), *site.written()) for picture in fences.pictures(page.text)]
    drawn = pictures.make(shown)
    print(f"{drawn} of {len(shown)} pictures drawn, the others were there")
    for path in {path for picture in shown for path in pictures.files(picture)}:
        add(f"{MADE}/{path.name}", abs_src_path=str(path))
    for path in (ROOT / "tests" / "sheet" / "golden").glob("*.png"):
        add(f"pictures/sheets/{path.name}", abs_src_path=str(path))
    for path in (ROOT / "examples").iterdir():
        if path.is_file() and path.suffix != ".face":
            add(f"examples/{path.name}", abs_src_path=str(path))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Links of the checkout to links of the site, codes to their pages, blocks to pictures."""
    uri = page.file.src_uri
    known: Page = HOMES[uri]
    text = sited(markdown, known.home, uri) if known.home else markdown
    return fences.plain(coded(text, uri), lambda picture: image(picture, uri))


HOMES = {page.uri: page for page in (*site.made(), *site.written())}


def image(picture: fences.Picture, page: str) -> str:
    """The picture in HTML, with its size, so that nothing jumps when it comes; a film has its still for the calm."""
    path = pictures.place(picture)
    address = relative(f"{MADE}/{path.name}", page)
    size = f' width="{picture.wide}"'
    if path.suffix == ".webp":
        with Image.open(path) as opened:
            size += f' height="{round(picture.wide * opened.height / opened.width)}"'
    shown = f'<img src="{address}" alt="{escape(picture.alt)}"{size} loading="lazy">'
    if picture.kind != "film":
        return f'<p class="made">{shown}</p>'
    still = relative(f"{MADE}/{calm(path).name}", page)
    less = f'<source media="(prefers-reduced-motion: reduce)" srcset="{still}">'
    return f'<p class="made"><picture>{less}{shown}</picture></p>'
