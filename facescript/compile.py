"""A script to a score: the one way through, for the command line, editors and tests alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Film, Play
from facescript.resolve.memo import Memo
from facescript.resolve.resolver import resolve
from facescript.schedule.film import Timed
from facescript.schedule.kept import Kept
from facescript.schedule.scheduler import timed_by
from facescript.schedule.score import Score
from facescript.space.haste import haste
from facescript.space.reach import reach
from facescript.speech.model import VoiceBox
from facescript.syntax.parser import parse
from facescript.syntax.tree import Item, Script, Setting
from facescript.text import Source
from facescript.world import World


@dataclass(frozen=True, slots=True)
class Settings:
    """What the command line may say over the script's head: `--set`, `--seed`, `--size`, `--fps`, `--events`. With
    `instead` the events are not added to the script's own, but take their place."""

    overrides: Mapping[str, str] = field(default_factory=dict)
    film: Mapping[str, float] = field(default_factory=dict)
    events: Source | None = None
    instead: bool = False


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
        kept: Kept | None = None,
    ) -> None:
        """`diagnostics` hold what is wrong with the text; `resolved` gives the play and adds what is wrong with it.
        `kept` has what was solved of the state before."""
        self.source, self.script, self._kept = source, script, kept or Kept()
        self._told, self._resolved, self._voice, self._settings = diagnostics, resolved, voice, settings

    @cached_property
    def play(self) -> Play | None:
        play = self._resolved()
        if play is None or self._told.failed:
            return None
        return replace(play, film=_film(play.film, self._settings.film))

    @cached_property
    def _timed(self) -> Timed | None:
        timed = timed_by(self.play, self._voice, self._told, self._kept) if self.play is not None else None
        if timed is not None:
            astray = timed.astray()
            reach(astray, self._told)
            haste(astray, self._told)
        return None if self._told.failed else timed

    @cached_property
    def score(self) -> Score | None:
        return self._timed.score() if self._timed is not None else None

    @property
    def diagnostics(self) -> Diagnostics:
        _ = self._timed
        return self._told

    def finished(self) -> Compiled:
        """Itself, with all worked out."""
        _ = self.score
        return self


def compile_source(source: Source, world: World, voice: VoiceBox, settings: Settings | None = None) -> Compiled:
    """The script as far as the score; `score` is None where an error stands in the way, `diagnostics` says which."""
    settings = settings or Settings()
    diagnostics = Diagnostics()
    script = with_events(parse(source, diagnostics), settings, diagnostics)
    return of_script(script, world, voice, diagnostics, settings).finished()


def of_script(
    script: Script,
    world: World,
    voice: VoiceBox,
    diagnostics: Diagnostics,
    settings: Settings,
    memo: Memo | None = None,
    kept: Kept | None = None,
) -> Compiled:
    """A parsed script; `diagnostics` hold what is wrong with its text, `memo` what its parts came to in the state
    before, `kept` what was solved of them."""

    def resolved() -> Play | None:
        return resolve(script, world, diagnostics, settings.overrides, memo)

    return Compiled(script.source, script, diagnostics, resolved, voice, settings, kept)


def with_events(script: Script, settings: Settings, diagnostics: Diagnostics) -> Script:
    """A script with the `event` lines of a further file."""
    if settings.events is None:
        return script
    own = tuple(item for item in script.items if not (settings.instead and _is_event(item)))
    return Script(script.source, own + parse(settings.events, diagnostics).items)


def _is_event(item: Item) -> bool:
    return isinstance(item, Setting) and item.kind == "event"


def _film(film: Film, changes: Mapping[str, float]) -> Film:
    whole = {name: int(value) for name, value in changes.items() if name in ("width", "height", "seed")}
    return replace(film, **{**changes, **whole})  # type: ignore[arg-type]
