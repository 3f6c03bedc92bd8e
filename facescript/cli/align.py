"""`facescript align`: a recording and a text to when its words are said, as files of times or a table to read."""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path

from facescript.backends.output import outputs
from facescript.cli.arguments import SPHINX, VOICE
from facescript.cli.outputs import no_kind, put, suffix_of
from facescript.cli.report import OptionFault, refuse
from facescript.cli.settings import seconds
from facescript.ir.acts import Say, Voice
from facescript.project import open_script
from facescript.speech.align.activity import Stretch
from facescript.speech.align.aligned import aligned
from facescript.speech.align.alignment import Alignment
from facescript.speech.align.chosen import FIRST, chosen_pauses
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.listen.loop import installed
from facescript.speech.model import VoiceFailure
from facescript.speech.sound.recording import read_recording
from facescript.speech.timing.files import WRITERS, write_times
from facescript.world import WorldFailure


def run(options: argparse.Namespace) -> int:
    """0 done (with warnings, perhaps), 1 faults. Raises `OptionFault`."""
    outs = [(target, suffix_of(target, options.kind)) for target in options.output]
    for target, suffix in outs:
        if suffix.lower() not in WRITERS:
            raise no_kind(target, suffix, WRITERS)
    pause = _pause(options.pause)
    if options.by == SPHINX and not installed():
        raise OptionFault("FS952")
    try:
        source, _ = open_script(options.text)
    except WorldFailure as fault:
        return refuse("FS901", name=options.text, reason=fault.args[0])
    try:
        found = _aligned(options, source.text, pause)
    except VoiceFailure as fault:
        return refuse("FS950", name=options.recording, reason=fault.args[0])
    for doubt in found.doubts:
        refuse(doubt.code, reason=doubt.reason)
    return _write(found, outs) if outs else _print(found)


def _aligned(options: argparse.Namespace, text: str, pause: Stretch | str | None) -> Alignment:
    """The text in the recording. Raises `VoiceFailure`, `OptionFault`."""
    recording = read_recording(Path(options.recording))
    if isinstance(pause, Stretch) and pause.end > recording.duration:
        raise OptionFault("FS951", reason=f"the recording ends at {recording.duration:.2f} s")
    pauses = None if pause is None else chosen_pauses(recording, pause)
    line = Say(text, Voice(options.language))
    return aligned(recording, line, process_voice(), pauses, options.by == VOICE)


def _pause(words: list[str] | None) -> Stretch | str | None:
    """What `--pause` chooses: a stretch, or the first clear one. Raises `OptionFault`."""
    if words is None:
        return None
    if words == [FIRST]:
        return FIRST
    if len(words) != 2:
        raise OptionFault("FS951", reason="it takes where the pause begins and where it ends, or `first`")
    start, end = (seconds("--pause", word) or 0.0 for word in words)
    if end <= start:
        raise OptionFault("FS951", reason=f"`{words[1]}` is not after `{words[0]}`")
    return Stretch(start, end)


def _print(found: Alignment) -> int:
    """A line a word: when it begins and ends, how sure that is, the word."""
    for word, sure in zip(found.words, found.confidences, strict=True):
        print(f"{word.start:9.3f} {word.end:9.3f} {sure:5.0%}  {word.text}")
    return 0


def _write(found: Alignment, outs: list[tuple[str, str]]) -> int:
    target = ""
    try:
        with outputs() as batch:
            for target, suffix in outs:
                put(target, suffix, batch, partial(_write_one, found, suffix))
    except OSError as fault:
        return refuse("FS903", path=target, reason=fault.strerror or "it cannot be written")
    return 0


def _write_one(found: Alignment, suffix: str, path: Path) -> None:
    path.write_bytes(write_times(found.times(), suffix))
