"""Codes FS990 to FS999, what is told to a running script, and what it hears."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

HELLO = 'say "Hello."\n'

TALK: tuple[Entry, ...] = (
    Entry(
        "FS990",
        "told-file",
        Severity.ERROR,
        "What is told to a running script names no file but those that the script names itself, and `{path}` is none.",
        HELLO,
        HELLO,
        "Who may tell a face what to say reads nothing of this machine with it. Put it into an action of the script, "
        "and tell that.",
        stage="unforced",
    ),
    Entry(
        "FS991",
        "told-definition",
        Severity.ERROR,
        "Only statements can be told to a running script; this belongs into the script itself.",
        HELLO,
        HELLO,
        "Faces, targets, expressions, actions and reactions are there from the beginning.",
        stage="unforced",
    ),
    Entry(
        "FS992",
        "told-long",
        Severity.ERROR,
        "What is told at once has at most {longest} characters; tell it in parts.",
        HELLO,
        HELLO,
        "A long answer is spoken sentence by sentence.",
        stage="unforced",
    ),
    Entry(
        "FS993",
        "told-many",
        Severity.ERROR,
        "{most} statements wait already for their turn to be spoken; tell this one later, or interrupt.",
        HELLO,
        HELLO,
        "What speaks waits until its face has done speaking.",
        stage="unforced",
    ),
    Entry(
        "FS994",
        "hears-nothing",
        Severity.ERROR,
        "There is nothing to listen for: {reason}; the recogniser knows English, and `text:FILE` takes words of any "
        "language.",
        "nod\n",
        'nod\nwhen heard "no":\n    nod\n',
        "What is heard is one of the texts of `when heard`.",
        stage="unforced",
    ),
    Entry(
        "FS995",
        "told-often",
        Severity.ERROR,
        "The run takes this statement no more: {reason}; tell it again later.",
        HELLO,
        HELLO,
        "A statement is taken ten times a second, and all that a run is told sixty times.",
        stage="unforced",
    ),
)
