"""A script to a score: the one way through, for the command line, editors and tests alike."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

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


class Compiled:
    """How far a script came, and everything there is to say about it.

    The tree is there at once. `play`, `score` and `diagnostics` are worked out when they are first asked for: an editor
    asks for the tree at every key, and for times only between them. `score` is None where an error stands in the way.
    """

    def __init__(
        self, script: Script, world: World, voice: VoiceBox, diagnostics: Diagnostics, settings: Settings
    ) -> None:
        """`diagnostics` hold what is wrong with the text of the script."""
        self.script = script
        self._world, self._voice, self._told, self._settings = world, voice, diagnostics, settings

    @property
    def source(self) -> Source:
        return self.script.source

    @cached_property
    def play(self) -> Play | None:
        play = resolve(self.script, self._world, self._told, self._settings.overrides)
        if play is None or self._told.failed:
            return None
        return replace(play, film=_film(play.film, self._settings.film))

    @cached_property
    def score(self) -> Score | None:
        score = schedule(self.play, self._voice, self._told) if self.play is not None else None
        if score is not None:
            reach(score, self._told)
            haste(score, self._told)
        return None if self._told.failed else score

    @property
    def diagnostics(self) -> Diagnostics:
        return self.finished()._told

    def finished(self) -> Compiled:
        """Itself, with all worked out."""
        _ = self.score
        return self


def compile_source(source: Source, world: World, voice: VoiceBox, settings: Settings | None = None) -> Compiled:
    """The script as far as the score; `score` is None where an error stands in the way, `diagnostics` says which."""
    settings = settings or Settings()
    diagnostics = Diagnostics()
    script = _with_events(parse(source, diagnostics), settings.events, diagnostics)
    return Compiled(script, world, voice, diagnostics, settings).finished()


def _with_events(script: Script, events: Source | None, diagnostics: Diagnostics) -> Script:
    if events is None:
        return script
    return Script(script.source, script.items + parse(events, diagnostics).items)


def _film(film: Film, changes: Mapping[str, float]) -> Film:
    whole = {name: int(value) for name, value in changes.items() if name in ("width", "height", "seed")}
    return replace(film, **{**changes, **whole})  # type: ignore[arg-type]
