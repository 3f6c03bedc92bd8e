"""Diagnostics FS961 to FS969: plays in JSON, fixes made by the command line, the preview."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

HELLO = 'say "Hello."\n'

PLAY = """{{"version": 1, "play": {{"type": "Play",
 "film": {{"type": "Film"}},
 "faces": [{{"type": "Face", "name": "ada", "kind": "woman", "voice": {{"type": "Voice"}},
  "life": {{"type": "Life", "name": "still", "knobs": [{knobs}]}}}}],
 "targets": [],
 "scenes": [{{"type": "Scene", "name": "main", "faces": ["ada"], "body": {{"type": "Sequence", "clock": true, "items": [
  {{"type": "Do", "face": {face}, "label": {label}, "verb": {verb}}}]}}}}]}}}}
"""

STILL = ", ".join(f'["{name}", 0.0]' for name in ("blink", "brows", "sway", "nods", "saccades", "avert"))


def play(verb: str, face: str = "null", label: str = "null", knobs: str = STILL) -> str:
    """A play that does one thing."""
    return PLAY.format(verb=verb, face=face, label=label, knobs=knobs)


WAIT = '{"type": "Wait", "duration": 1.0}'

PROGRAMS = (
    Entry(
        "FS961",
        "no-play",
        Severity.ERROR,
        "{name} is no play in JSON: {reason}; `facescript list schema` has the form.",
        HELLO,
        HELLO,
        "A play holds what its schema says and nothing else.",
        stage="command",
        files={"play.json": play('{"type": "Weight"}'), "good.json": play(WAIT)},
        command=("check", "play.json"),
    ),
    Entry(
        "FS962",
        "play-unsayable",
        Severity.ERROR,
        "At `{path}` this play has {value}, which no script says; here a script has {other}.",
        HELLO,
        HELLO,
        "A play is checked by the script that it is. What the script does not say again is in no script.",
        stage="command",
        files={"play.json": play(WAIT, knobs='["blink", 5.0]')},
        command=("check", "play.json"),
    ),
    Entry(
        "FS963",
        "play-renamed",
        Severity.WARNING,
        "Statements bear another name in the script than in the play: {names}; markers in outputs bear it too.",
        HELLO,
        HELLO,
        "A name such as `trials.7.cued` comes of a repeat or an action, which a play no longer has.",
        stage="command",
        files={"play.json": play(WAIT, label='"trials.7.cued"')},
        command=("fmt", "play.json", "-o", "again.face"),
    ),
    Entry(
        "FS964",
        "fmt-output",
        Severity.ERROR,
        "`fmt` cannot do this: {reason}.",
        HELLO,
        HELLO,
        "A script is put into the layout in its place, and a play is never written over.",
        stage="command",
        files={"play.json": play(WAIT)},
        command=("fmt", "play.json"),
    ),
    Entry(
        "FS965",
        "fix-json",
        Severity.ERROR,
        "`--fix` and `--json` both want standard output where standard input is checked; leave one of them out.",
        HELLO,
        HELLO,
        "The script that was mended goes to standard output, and so does the list of what is left.",
        stage="command",
        command=("check", "--fix", "--json", "-"),
    ),
    Entry(
        "FS967",
        "port-taken",
        Severity.ERROR,
        "The page cannot be at port {port}: {reason}; leave `--port` out, and a free one is found.",
        HELLO,
        HELLO,
        "Another program is there, perhaps an earlier preview, or the system keeps it for itself.",
        stage="unforced",
    ),
)
