"""Codes FS510 to FS512 and FS950 to FS952, recordings with their words."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.catalogue.speech import SILENCE
from facescript.diagnostics.model import Severity

_HELLO = 'say "Hello."\n'

RECORDINGS: tuple[Entry, ...] = (
    Entry(
        "FS510",
        "recording-differs",
        Severity.WARNING,
        "The recording does not seem to say this text: {reason}.",
        'say "Hello." from "take.wav"\n',
        _HELLO,
        "The words are put where they fit best, or spread over the speech that there is. `take.wav` is silent here.",
        files={"take.wav": SILENCE},
        stage="build",
    ),
    Entry(
        "FS511",
        "recording-lacks",
        Severity.WARNING,
        "Not all of this text is in the recording: {reason}.",
        'say "Hello. The rest was cut off." from "take.wav"\n',
        'say "Hello." from "take.wav"\n',
        "What is not heard has no time of its own.",
        stage="unforced",
    ),
    Entry(
        "FS512",
        "recording-unclear",
        Severity.WARNING,
        "Two ways of finding the words do not agree: {reason}.",
        'say "Hello." from "take.wav"\n',
        _HELLO,
        "English is aligned twice where PocketSphinx is installed; look whether the words there are at their place.",
        stage="unforced",
    ),
    Entry(
        "FS950",
        "align-failed",
        Severity.ERROR,
        "`{name}` cannot be aligned: {reason}.",
        _HELLO,
        _HELLO,
        "A recording is a WAV, FLAC, OGG or MP3 file; `--language` is one of `facescript list voices`.",
        stage="command",
        command=("align", "script.face", "script.face"),
    ),
    Entry(
        "FS951",
        "align-pause",
        Severity.ERROR,
        "`--pause` cannot be taken: {reason}.",
        _HELLO,
        _HELLO,
        "Choose the pause after the first sentence, `--pause 1.2s 1.65s`, or `--pause first`.",
        stage="command",
        command=("align", "take.wav", "script.face", "--pause", "2s", "1s"),
    ),
    Entry(
        "FS952",
        "align-extra",
        Severity.ERROR,
        "PocketSphinx is not installed: `pip install 'facescript[english]'`; without `--by` the voice aligns.",
        _HELLO,
        _HELLO,
        "It finds the phones of English recordings somewhat nearer, and takes four times as long.",
        stage="unforced",
    ),
)
