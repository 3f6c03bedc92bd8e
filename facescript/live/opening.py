"""A script, or a play in JSON, to what a live run performs, which of its events anything waits for, and its hash."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

from facescript.compile import Settings, of_script
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Do, Say
from facescript.ir.play import Play
from facescript.live.model import Happening
from facescript.project import is_play
from facescript.resolve.told import HUSHED, TOLD, Prompter
from facescript.schedule.events import heeds
from facescript.schedule.kept import Kept
from facescript.schedule.labels import nodes
from facescript.schedule.scheduler import timed_by
from facescript.schedule.voices import spoken_by
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import VoiceBox, VoiceFailure
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import ReadWorld, World, WorldFailure

LOOKED_AT = 60.0
"""Seconds of a play without an end that are looked at for faults."""

UNPLAYED = ("FS413", "FS414")
"""A scene that no build comes to: in a run a reaction may end the one before."""


def open_play(source: Source, world: World, settings: Settings) -> tuple[Play | None, Diagnostics]:
    """The play without times: what happens is not known yet. None where it has errors; what is wrong with it."""
    told = Diagnostics()
    if is_play(source):
        from facescript.plays import script_of  # pydantic: only plays pay it

        found = script_of(source, world, source.name, told, settings)
        play = None if found is None else found.play
    else:
        play = of_script(parse(source, told), world, EstimatedVoice(), told, settings).play
    if play is None or "seed" not in settings.film:
        return play, told
    return replace(play, film=replace(play.film, seed=int(settings.film["seed"]))), told


def prompter_of(source: Source, world: World, settings: Settings) -> Prompter:
    """Who resolves what is told to a script, or a play in JSON, that has no errors."""
    told = Diagnostics()
    if is_play(source):
        from facescript.plays import script_of

        found = script_of(source, world, source.name, told, settings)
        assert found is not None
        return Prompter(found.script, world, told)
    return Prompter(parse(source, told), world, told, settings.overrides)


def check(play: Play, voice: VoiceBox, told: Diagnostics) -> None:
    """Tells what is wrong with the times of the scenes, as far as a build of a minute shows it, and which lines of
    reactions cannot be spoken: once it runs, nobody may be there to be told."""
    film, found = replace(play.film, long=play.film.long or LOOKED_AT), Diagnostics()
    timed_by(replace(play, film=film, events=()), voice, found, Kept())
    for item in found:
        if item.code not in UNPLAYED:
            told.add(item)
    for reaction in play.reactions:
        for node, _ in nodes(reaction.body):
            if isinstance(node, Do) and isinstance(node.verb, Say):
                spoken = spoken_by(voice, node.verb)
                if isinstance(spoken, VoiceFailure):
                    told.add(diagnose(spoken.code, node.span, reason=spoken.args[0]))


def waits(play: Play) -> Callable[[Happening], bool]:
    """Whether anything waits for an event: a reaction, or for who comes and goes the crowd `people`."""
    patterns = [reaction.event for reaction in play.reactions]

    def known(happening: Happening) -> bool:
        if happening.person is not None or happening.kind in (TOLD, HUSHED):
            return True
        return any(heeds(pattern, happening) for pattern in patterns)

    return known


def fingerprint(source: Source, world: ReadWorld) -> str:
    """The SHA-256 of a script and the files that it was seen to use, hexadecimal."""
    whole = hashlib.sha256(source.text.encode())
    for name in sorted(world.names - {source.name}):
        with suppress(WorldFailure):
            content = hashlib.sha256(World.read(world, name)).hexdigest()
            whole.update(f"\0{name}\0{content}".encode())
    return whole.hexdigest()
