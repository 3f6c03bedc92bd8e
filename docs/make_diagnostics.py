"""The catalogue of diagnostics to `docs/diagnostics.md`: what each code says of its bad example, and a good one.

Run `python docs/make_diagnostics.py` after a change of the catalogue; a test holds the page to it.
"""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterator
from contextlib import chdir, redirect_stderr
from io import StringIO
from pathlib import Path

from facescript.cli.main import main
from facescript.compile import compile_source
from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.catalogue.model import Entry
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

PAGE = Path(__file__).with_name("diagnostics.md")
VOICES = {"check": EstimatedVoice, "build": open_studio}
WIDEST, LONGEST = 116, 24
"""Signs of a line and lines of a file that the page shows; the rest is `…`."""

HIDDEN = re.compile("[\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]")

SPOKEN = re.compile(r"\d+\.\d{2,} s")
"""Seconds that a voice decides; machines need not agree on them."""

FAMILIES = {
    "1": "What cannot be read",
    "2": "Names",
    "3": "Units, ranges and modifiers",
    "4": "Times",
    "5": "Texts and voices",
    "6": "Gaze",
    "7": "Files",
    "8": "Live runs alone, or not in this version",
    "9": "The command line",
}

HEAD = """\
# Diagnostics

What `facescript` tells an author: a code, a sentence, the exact place, and a fix where one is known. An **error**
stands in the way of a build. A **warning** does not: something comes out, and perhaps not what was meant. A **hint**
is shown by `check` alone. Each code stands here with its sentence for one bad example, and with a script that does it
well.

This page is made by `docs/make_diagnostics.py` from the catalogue in `facescript/diagnostics/catalogue/`.
"""


def page() -> str:
    """The whole page, codes in order under a heading a family."""
    parts = [HEAD]
    for family, title in FAMILIES.items():
        parts.append(f"\n## FS{family}xx: {title}\n")
        parts += [_entry(entry) for code, entry in sorted(CATALOGUE.items()) if code[2] == family]
    return "".join(parts)


def _entry(entry: Entry) -> str:
    rows = [f"\n### {entry.code} {entry.name}\n", f"**{str(entry.severity).capitalize()}.** {_sentence(entry)}\n"]
    if entry.why:
        rows.append(f"{entry.why}\n")
    if entry.stage == "command":
        rows.append(_block("", f"facescript {' '.join(entry.command)}"))
    elif entry.stage != "unforced":
        rows += [_block("face-bad", entry.bad), _block("face", entry.good)]
        rows += [f"`{name}`:\n\n{_block('', text)}" for name, text in entry.files.items() if "\0" not in text]
    return "\n".join(rows)


def _sentence(entry: Entry) -> str:
    """What is said of the bad example; the bare pattern where no example brings the code about."""
    if entry.stage == "unforced":
        return re.sub(r"\{[^}]*\}", "…", entry.sentence)
    with tempfile.TemporaryDirectory() as name:
        for path, text in {**entry.files, "script.face": entry.bad}.items():
            (Path(name) / path).write_text(text, "utf-8")
        said = next(_commanded(entry, name) if entry.stage == "command" else _compiled(entry, name))
    return _short(SPOKEN.sub("… s", said) if entry.stage != "check" else said)


def _compiled(entry: Entry, folder: str) -> Iterator[str]:
    world = World(Path(folder))
    found = compile_source(Source("script.face", entry.bad), world, VOICES[entry.stage](world)).diagnostics
    return (item.message for item in found if item.code == entry.code)


def _commanded(entry: Entry, folder: str) -> Iterator[str]:
    told = StringIO()
    with chdir(folder), redirect_stderr(told):
        main(list(entry.command))
    return iter(re.findall(rf"{entry.code}: (.*)", told.getvalue()))


def _block(kind: str, text: str) -> str:
    lines = HIDDEN.sub(lambda found: f"<U+{ord(found[0]):04X}>", text).splitlines()
    shown = [_short(line) for line in lines[:LONGEST]] + ["…"] * (len(lines) > LONGEST)
    return f"```{kind}\n" + "\n".join(shown) + "\n```\n"


def _short(text: str) -> str:
    return text if len(text) <= WIDEST * 4 else f"{text[:WIDEST]}…"


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8", newline="\n")
    print(f"wrote {os.path.relpath(PAGE)}")
