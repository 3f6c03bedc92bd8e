"""A line with a recording or a file of times to speech: where its words are, and how its mouth moves; what is found in
a recording is kept for the next build."""

from __future__ import annotations

import hashlib
from dataclasses import replace

from facescript.ir.acts import Say
from facescript.speech.align.aligned import aligned
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.listen.alone import alone
from facescript.speech.listen.loop import installed
from facescript.speech.model import Spoken, VoiceBox, VoiceFailure
from facescript.speech.sound.recording import UNUSABLE, Recording, read_recording
from facescript.speech.timing.line import timed
from facescript.speech.voices import store
from facescript.world import World, WorldFailure


def recorded(line: Say, world: World, voice: VoiceBox) -> Spoken:
    """The line as its files have it. Raises `VoiceFailure` (FS504, FS515) for files that cannot be used."""
    if line.times is not None:
        return timed(line, world, voice, _sound(_read(world, line.recording)) if line.recording else None)
    assert line.recording is not None
    sound = _read(world, line.recording)
    key = store.key_of(line, _identity(sound))
    found = store.load(key)
    if found is None:
        found = replace(_heard(sound, line), sound=b"")
        store.save(key, found)
    return replace(found, sound=sound.pcm)


def _identity(sound: Recording) -> str:
    """What stands for a recording and for what finds words in it."""
    digest, faults = hashlib.sha256(sound.samples.data).hexdigest(), [doubt.code for doubt in sound.doubts]
    return f"recording {digest} {sound.rate} {faults} {installed()}"


def _heard(sound: Recording, line: Say) -> Spoken:
    """The recording with its words where they are said, or with the sounds that are heard in it; the synthesiser helps
    to find words, whatever the voice is."""
    if not line.text:
        return alone(sound, line.voice.language)
    found = aligned(sound, line, process_voice())
    return replace(_sound(sound), words=found.words, phones=found.phones, doubts=(*sound.doubts, *found.doubts))


def _sound(sound: Recording) -> Spoken:
    return Spoken(sound.pcm, sound.rate, sound.duration, (), (), doubts=sound.doubts)


def _read(world: World, name: str) -> Recording:
    try:
        return read_recording(world.path(name))
    except WorldFailure as failure:
        raise VoiceFailure(failure.args[0], UNUSABLE) from None
