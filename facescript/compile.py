"""A script to a score: the one way through, for the command line, editors and tests alike."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Film, Play
from facescript.resolve.resolver import resolve
from facescript.schedule.scheduler import schedule
from facescript.schedule.score import Score
from facescript.space.haste import haste
from facescript.space.reach import reach
from facescript.speech.model import VoiceBox
from facescript.syntax.parser import parse
from facescript.syntax.tree import Script
from facescript.text import Source
from facescript.world import World


@dataclass(frozen=True, slots=True)
class Settings:
    """What the command line may say over the script's head: `--set`, `--seed`, `--size`, `--fps`, `--events`."""

    overrides: Mapping[str, str] = field(default_factory=dict)
    film: Mapping[str, float] = field(default_factory=dict)
    events: Source | None = None


@dataclass(slots=True)
class Compiled:
    """How far a script came, and everything there is to say about it."""

    source: Source
    diagnostics: Diagnostics
    script: Script
    play: Play | None = None
    score: Score | None = None


def compile_source(source: Source, world: World, voice: VoiceBox, settings: Settings | None = None) -> Compiled:
    """The script as far as the score; `score` is None where an error stands in the way, `diagnostics` says which."""
    diagnostics = Diagnostics()
    return compile_script(parse(source, diagnostics), world, voice, diagnostics, settings or Settings())


def compile_script(
    script: Script, world: World, voice: VoiceBox, diagnostics: Diagnostics, settings: Settings
) -> Compiled:
    """As `compile_source`, of a script that is parsed; `diagnostics` hold what was wrong with its text."""
    script = _with_events(script, settings.events, diagnostics)
    compiled = Compiled(script.source, diagnostics, script)
    play = resolve(script, world, diagnostics, settings.overrides)
    if play is None or diagnostics.failed:
        return compiled
    compiled.play = replace(play, film=_film(play.film, settings.film))
    score = schedule(compiled.play, voice, diagnostics)
    if score is None:
        return compiled
    reach(score, diagnostics)
    haste(score, diagnostics)
    if not diagnostics.failed:
        compiled.score = score
    return compiled


def _with_events(script: Script, events: Source | None, diagnostics: Diagnostics) -> Script:
    if events is None:
        return script
    return Script(script.source, script.items + parse(events, diagnostics).items)


def _film(film: Film, changes: Mapping[str, float]) -> Film:
    whole = {name: int(value) for name, value in changes.items() if name in ("width", "height", "seed")}
    return replace(film, **{**changes, **whole})  # type: ignore[arg-type]
