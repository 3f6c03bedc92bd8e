"""Codes FS940 to FS945, pages and their templates; `stage` is "command" and `command` its words."""

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
    Entry(
        "FS945",
        "beside-left-out",
        Severity.WARNING,
        "`{path}` shows the faces alone; the pictures and links beside them are in `.epub` and with `--page book`.",
        'link "https://example.org" "More"\nnod\n',
        HELLO,
        "`picture` and `link` are for books. What is to be seen in a film stands behind the faces: `background`.",
        stage="command",
        command=("build", "script.face", "--to", "100ms", "-o", "film.gif"),
    ),
)
