"""A page's template and what stands for its placeholders to the page's text.

A template is HTML in which `{{face}}` and others in double braces stand where things are to be. What belongs into
the head (the sheet of styles, the policy that forbids the network) and what belongs at the end is added by itself.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Mapping, Sequence
from hashlib import sha256
from pathlib import PurePosixPath
from urllib.parse import unquote

from facescript.world import WorldFailure

PLACEHOLDER = re.compile(r"\{\{\s*([a-z]+)\s*\}\}")

NEEDED = "face"
"""The placeholder that no template may be without."""

NAMES = ("author", "controls", "face", "language", "script", "text", "title")
"""All placeholders."""

FETCHED = re.compile(
    r"""(?P<tag><(?:img|script|link|audio|video|source|iframe|embed|object|input|track)\b[^>]*?\s"""
    r"""(?:src|href|data|poster)\s*=\s*["']?|@import\s+["']|url\(\s*["']?)(?P<address>[^"'\s>)]+)""",
    re.IGNORECASE,
)
"""What a browser would fetch: its address, and all that stands before it."""

KINDS = {
    ".css": "text/css",
    ".js": "text/javascript",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".jpeg": "image/jpeg",
    ".gif": "image/gif",
    ".webp": "image/webp",
    ".woff2": "font/woff2",
    ".woff": "font/woff",
    ".ttf": "font/ttf",
    ".otf": "font/otf",
}
"""Files that are put into a page, by their suffix."""


class TemplateFault(Exception):
    """A template that cannot be used: the `code` of a diagnostic and the `values` of its sentence."""

    def __init__(self, code: str, **values: str) -> None:
        super().__init__(code)
        self.code, self.values = code, values


def checked(text: str, read: Callable[[str], bytes]) -> str:
    """A template with the files that it refers to put into it; `read` gives a file's bytes by its path beside the
    template, or raises `WorldFailure`. Raises `TemplateFault` for a template without a place for the face, with
    placeholders that there are not, or with addresses that are no file of the project."""
    names = PLACEHOLDER.findall(text)
    for name in names:
        if name not in NAMES:
            known = ", ".join(f"`{{{{{each}}}}}`" for each in NAMES)
            raise TemplateFault("FS942", placeholder=f"{{{{{name}}}}}", known=known)
    if names.count(NEEDED) != 1:
        raise TemplateFault("FS941")
    return FETCHED.sub(lambda found: found["tag"] + _inside(found["address"], read), text)


def _inside(address: str, read: Callable[[str], bytes]) -> str:
    """An address that holds what lies at another. Raises `TemplateFault`."""
    if address.startswith(("data:", "#", "{{")):
        return address
    kind = KINDS.get(PurePosixPath(address).suffix.lower())
    if kind is None or "//" in address:
        raise TemplateFault("FS943", address=address, reason="no network is used")
    try:
        data = read(unquote(address))
    except WorldFailure as fault:
        raise TemplateFault("FS943", address=address, reason=fault.args[0]) from None
    return f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"


def filled(text: str, parts: Mapping[str, str]) -> str:
    """The template with each placeholder's part in its place; parts are HTML already."""
    return PLACEHOLDER.sub(lambda found: parts[found[1]], text)


def with_head(text: str, head: str) -> str:
    """The page with `head` at the beginning of its head, so that what the template says there comes later."""
    found = re.search(r"<head\b[^>]*>", text, re.IGNORECASE)
    found = found or re.search(r"<html\b[^>]*>", text, re.IGNORECASE) or re.search(r"<!doctype\b[^>]*>", text, re.I)
    at = found.end() if found else 0
    return f"{text[:at]}\n{head}{text[at:]}"


def with_end(text: str, end: str) -> str:
    """The page with `end` at the end of its body."""
    at = text.lower().rfind("</body")
    return f"{text[:at]}{end}{text[at:]}" if at >= 0 else f"{text}{end}"


def policy(scripts: Sequence[str], brought: bool, split: bool) -> str:
    """The page's own rule for browsers: nothing from any network. A template that an author brings may have scripts of
    its own; else only ours run."""
    ours = " ".join(f"'sha256-{_digest(script)}'" for script in scripts)
    allowed, styles = ("'unsafe-inline' data:", "'unsafe-inline' data:") if brought else (ours, "'unsafe-inline'")
    beside = " 'self' file:" if split else ""
    return (
        f"default-src 'none'; script-src {allowed}{beside}; style-src {styles}; img-src data:{beside}; font-src data:; "
        f"media-src data:{beside}; base-uri 'none'; form-action 'none'"
    )


def _digest(script: str) -> str:
    return base64.b64encode(sha256(script.encode()).digest()).decode("ascii")
