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
        "FS523",
        "viseme-unreadable",
        Severity.ERROR,
        "The viseme of `{sound}` cannot be read: {reason}.",
        'viseme "θ" = smile\n\nsay "Thanks."\n',
        'viseme "θ" = "s" 80%\n\nsay "Thanks."\n',
        "A viseme says how the mouth is at a sound: as at another one, at a degree, or with a shape of its own, made "
        "of the mouth's channels (`mouth.upper 10% + mouth.lower 20% + mouth.tongue 100%`).",
    ),
    Entry(
        "FS524",
        "viseme-twice",
        Severity.ERROR,
        "The sound `{sound}` has a viseme already.",
        'viseme "θ" = "s"\nviseme "θ" = "f"\n\nsay "Thanks."\n',
        'viseme "θ" = "s"\nviseme "ð" = "z"\n\nsay "Thanks."\n',
        "A sound has one shape in a whole film, whichever file says so.",
    ),
    Entry(
        "FS525",
        "sound-unknown",
        Severity.HINT,
        "No mouth shape is known for the sound `{sound}`; the mouth takes a middle one.",
        'say "Oh."\n',
        'viseme "ꙮ" = "o"\n\nsay "Oh."\n',
        "A voice that an author brings, or a file of times, has a sound that the table of visemes does not: a "
        'definition such as `viseme "ꙮ" = "o"` says what the mouth does. All voices of espeak-ng are in the table.',
        stage="unforced",
    ),
)
