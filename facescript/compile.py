"""A script to a score: the one way through, for the command line, editors and tests alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Film, Play
from facescript.resolve.memo import Memo
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
        self,
        source: Source,
        script: Script,
        diagnostics: Diagnostics,
        resolved: Callable[[], Play | None],
        voice: VoiceBox,
        settings: Settings,
    ) -> None:
        """`diagnostics` hold what is wrong with the text; `resolved` gives the play and adds what is wrong with it."""
        self.source, self.script = source, script
        self._told, self._resolved, self._voice, self._settings = diagnostics, resolved, voice, settings

    @cached_property
    def play(self) -> Play | None:
        play = self._resolved()
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
    script = with_events(parse(source, diagnostics), settings.events, diagnostics)
    return of_script(script, world, voice, diagnostics, settings).finished()


def of_script(
    script: Script,
    world: World,
    voice: VoiceBox,
    diagnostics: Diagnostics,
    settings: Settings,
    memo: Memo | None = None,
) -> Compiled:
    """A parsed script; `diagnostics` hold what is wrong with its text, `memo` what former states of it came to."""

    def resolved() -> Play | None:
        return resolve(script, world, diagnostics, settings.overrides, memo)

    return Compiled(script.source, script, diagnostics, resolved, voice, settings)


def with_events(script: Script, events: Source | None, diagnostics: Diagnostics) -> Script:
    """A script with the `event` lines of a further file."""
    if events is None:
        return script
    return Script(script.source, script.items + parse(events, diagnostics).items)


def _film(film: Film, changes: Mapping[str, float]) -> Film:
    whole = {name: int(value) for name, value in changes.items() if name in ("width", "height", "seed")}
    return replace(film, **{**changes, **whole})  # type: ignore[arg-type]
