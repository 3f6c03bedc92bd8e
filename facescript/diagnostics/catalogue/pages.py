"""Codes FS940 to FS943, templates of pages; `stage` is "command" and `command` its words."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

HELLO = 'say "Hello."\n'

PAGES: tuple[Entry, ...] = (
    Entry(
        "FS940",
        "template-unreadable",
        Severity.ERROR,
        "The template `{name}` cannot be used: {reason}; write {known}, or an HTML file of the project.",
        HELLO,
        HELLO,
        "A template of your own lies in the project's folder, as the script does.",
        stage="command",
        command=("build", "script.face", "--page", "missing.html", "-o", "page.html"),
    ),
    Entry(
        "FS941",
        "template-faceless",
        Severity.ERROR,
        "The template `{name}` must have one place for the face; write `{{{{face}}}}` once, where it is to be.",
        HELLO,
        HELLO,
        "`{{face}}` is all that a template needs; `docs/speech.md` has the others.",
        files={"mine.html": "<h1>{{title}}</h1>\n"},
        stage="command",
        command=("build", "script.face", "--page", "mine.html", "-o", "page.html"),
    ),
    Entry(
        "FS942",
        "template-placeholder",
        Severity.ERROR,
        "`{placeholder}` in the template `{name}` stands for nothing; there are {known}.",
        HELLO,
        HELLO,
        "What is written in double braces is filled in when the page is made.",
        files={"mine.html": "{{face}} {{heading}}\n"},
        stage="command",
        command=("build", "script.face", "--page", "mine.html", "-o", "page.html"),
    ),
    Entry(
        "FS943",
        "template-outside",
        Severity.ERROR,
        "The template `{name}` shows `{address}`, which cannot come into the page: {reason}.",
        HELLO,
        HELLO,
        "A page needs no network. Pictures, fonts, style sheets and scripts that lie beside the template are put into "
        "the page; download what is elsewhere.",
        files={"mine.html": '{{face}} <img src="https://example.org/logo.png">\n'},
        stage="command",
        command=("build", "script.face", "--page", "mine.html", "-o", "page.html"),
    ),
)
