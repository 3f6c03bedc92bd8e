"""Codes FS5xx, texts, voices and words; each tells the `reason` of a `VoiceFailure`."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

SPEECH: tuple[Entry, ...] = (
    Entry(
        "FS501",
        "voice-failed",
        Severity.ERROR,
        "The voice cannot speak this line: {reason}.",
        'face ada = woman, voice en-uk\n\nsay "Hello."\n',
        'face ada = woman, voice en-gb\n\nsay "Hello."\n',
        "The voice does not exist, cannot run on this machine, or cannot speak as fast, slow, high or low as told. "
        "`facescript list voices` shows the voices there are.",
        stage="build",
    ),
    Entry(
        "FS502",
        "reading-unspeakable",
        Severity.ERROR,
        "This reading cannot be spoken: {reason}.",
        'face mei = woman, voice cmn\n\nsay "他[read zhang]长[/]大了。"\n',
        'face mei = woman, voice cmn\n\nsay "他[read zhang3]长[/]大了。"\n',
        "A reading is pinyin with tone numbers, a syllable a character, for Mandarin; kana for Japanese; `/IPA/` in "
        "the sounds of the voice's language, or another spelling, for every other language.",
    ),
    Entry(
        "FS503",
        "nothing-to-say",
        Severity.ERROR,
        "There is nothing to say in this line: {reason}.",
        'say "..."\n',
        'say "Hello."\n',
        "A line needs a letter or a number. A pause without words is `wait`.",
    ),
    Entry(
        "FS504",
        "recording-unusable",
        Severity.ERROR,
        "The recording cannot be used: {reason}.",
        'say "Hello." from "take.wav"\n',
        'say "Hello."\n',
        "A recording is a WAV, FLAC, OGG or MP3 file of the project.",
        files={"take.wav": "not sound"},
        stage="build",
    ),
    Entry(
        "FS506",
        "recording-changed",
        Severity.ERROR,
        "A recording is heard as it was spoken; `{name}` is for a voice.",
        'say "Hello." from "take.wav", rate 90%\n',
        'say "Hello.", rate 90%\n',
        "`volume` is for both.",
        files={"take.wav": "not sound"},
    ),
    Entry(
        "FS520",
        "words-unknown",
        Severity.ERROR,
        "This line has a recording and no text, so where “{word}” is in it cannot be found.",
        'say from "take.wav"\n    on "cup": nod\n',
        'say "Take the cup." from "take.wav"\n    on "cup": nod\n',
        "Write what is said before `from`, or give the moment in seconds: `at take + 1.2s:` for a line named with "
        "`as take`.",
        files={"take.wav": "not sound"},
    ),
)
