"""A script, or a play in JSON, to what a live run performs, which of its events anything waits for, and its hash."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

from facescript.compile import Settings, of_script
from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Play
from facescript.live.model import Happening
from facescript.project import is_play
from facescript.schedule.events import heeds
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import ReadWorld, World, WorldFailure


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


def waits(play: Play) -> Callable[[Happening], bool]:
    """Whether anything waits for an event: a reaction, or for who comes and goes the crowd `people`."""
    patterns = [reaction.event for reaction in play.reactions]

    def known(happening: Happening) -> bool:
        return happening.person is not None or any(heeds(pattern, happening) for pattern in patterns)

    return known


def fingerprint(source: Source, world: ReadWorld) -> str:
    """The SHA-256 of a script and the files that it was seen to use, hexadecimal."""
    whole = hashlib.sha256(source.text.encode())
    for name in sorted(world.names - {source.name}):
        with suppress(WorldFailure):
            content = hashlib.sha256(World.read(world, name)).hexdigest()
            whole.update(f"\0{name}\0{content}".encode())
    return whole.hexdigest()
