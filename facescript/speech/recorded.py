"""A line with a recording or a file of times to speech: where its words are, and how its mouth moves."""

from __future__ import annotations

from dataclasses import replace

from facescript.ir.acts import Say
from facescript.speech.align.aligned import aligned
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.listen.alone import alone
from facescript.speech.model import Spoken, VoiceBox, VoiceFailure
from facescript.speech.sound.recording import UNUSABLE, Recording, read_recording
from facescript.speech.timing.line import timed
from facescript.world import World, WorldFailure


def recorded(line: Say, world: World, voice: VoiceBox) -> Spoken:
    """The line as its files have it. Raises `VoiceFailure` (FS504, FS515) for files that cannot be used."""
    if line.times is not None:
        return timed(line, world, voice, _sound(_read(world, line.recording)) if line.recording else None)
    assert line.recording is not None
    sound = _read(world, line.recording)
    return _with_words(sound, line) if line.text else alone(sound, line.voice.language)


def _with_words(sound: Recording, line: Say) -> Spoken:
    """The recording with its words where they are said; the synthesiser helps to find them, whatever the voice is."""
    found = aligned(sound, line, process_voice())
    return replace(_sound(sound), words=found.words, phones=found.phones, doubts=(*sound.doubts, *found.doubts))


def _sound(sound: Recording) -> Spoken:
    return Spoken(sound.pcm, sound.rate, sound.duration, (), (), doubts=sound.doubts)


def _read(world: World, name: str) -> Recording:
    try:
        return read_recording(world.path(name))
    except WorldFailure as failure:
        raise VoiceFailure(failure.args[0], UNUSABLE) from None
