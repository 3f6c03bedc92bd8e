"""Links of a page in the checkout to links of the site, where what is not in `docs/` has a page or a file too."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).parents[2]

LINK = re.compile(r"(?<=\]\()(?P<path>[^)#\s:]*)(?P<anchor>#[^)\s]*)?(?=\))")
"""Behind `](`: a place in the checkout; addresses have a colon and are left alone."""

CODE = re.compile(r"^(?P<fence> *```).*?^ *```$|`[^`\n]+`|\[[^\]\n]*\]\([^)\n]*\)|^#[^\n]*$", re.MULTILINE | re.DOTALL)
"""What no code of a diagnostic is linked in: code, links, headings."""

DIAGNOSTIC = re.compile(r"\bFS\d{3}\b")

MOVED = {
    "README.md": "index.md",
    "ARCHITECTURE.md": "contributing/architecture.md",
    "CHANGELOG.md": "contributing/changes.md",
    "NOTICE": "contributing/licence.md",
    "LICENSE": "contributing/licence.md",
    "examples": "examples/index.md",
    "editors": "editors.md",
    "docs/howto": "howto/announcer.md",
}
"""Files and folders of the checkout, and the pages that they are in the site."""


class LinkFault(ValueError):
    """A link that leads to nothing of the site; `args[0]` says which."""


def uri(path: str) -> str:
    """Where something of the checkout is in the site. Raises `LinkFault`."""
    if path in MOVED:
        return MOVED[path]
    folder, _, name = path.rpartition("/")
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    if folder == "examples":
        return f"examples/{name.removesuffix('.face')}.md" if name.endswith(".face") else path
    if folder == "tests/sheet/golden":
        return f"pictures/sheets/{name}"
    raise LinkFault(f"nothing in the site is `{path}`")


def sited(text: str, home: str, page: str) -> str:
    """The text of a page that lies at `home` in the checkout, with links that hold at `page` in the site."""

    def turned(found: re.Match[str]) -> str:
        if not found["path"]:
            return found[0]
        target = posixpath.normpath(posixpath.join(posixpath.dirname(home), found["path"]))
        return relative(uri(target), page) + (found["anchor"] or "")

    return outside_blocks(text, lambda prose: LINK.sub(turned, prose))


def relative(target: str, page: str) -> str:
    """A place in the site, from a page of it."""
    return posixpath.relpath(target, posixpath.dirname(page) or ".")


def coded(text: str, page: str) -> str:
    """The page with each code of a diagnostic that stands in its prose as a link to its page."""
    made, last = [], 0
    for found in CODE.finditer(text):
        made += [_coded(text[last : found.start()], page), found[0]]
        last = found.end()
    return "".join([*made, _coded(text[last:], page)])


def _coded(prose: str, page: str) -> str:
    return DIAGNOSTIC.sub(lambda code: f"[{code[0]}]({relative(f'diagnostics/{code[0]}.md', page)})", prose)


BLOCKS = re.compile(r"^ *```.*?^ *```$", re.MULTILINE | re.DOTALL)


def outside_blocks(text: str, change: Callable[[str], str]) -> str:
    """The text with its prose changed; what stands between fences stays."""
    made, last = [], 0
    for found in BLOCKS.finditer(text):
        made += [change(text[last : found.start()]), found[0]]
        last = found.end()
    return "".join([*made, change(text[last:])])
