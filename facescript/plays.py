"""Plays in JSON to scores, as scripts are: what is wrong with one is told at the places that it notes.

A play is written as a script and that is compiled, so that whatever a script may not say, no play may either.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace

from facescript.compile import Compiled, Settings, with_events
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic, Diagnostics, Severity
from facescript.ir.json_form import NotAPlay, load
from facescript.ir.play import Play
from facescript.resolve.resolver import resolve
from facescript.speech.model import VoiceBox
from facescript.syntax.parser import parse
from facescript.syntax.tree import Script
from facescript.text import Source, Span
from facescript.world import World, WorldFailure
from facescript.writing.same import Difference, difference
from facescript.writing.script import Written, write

LONGEST = 160
"""Characters of a value that are shown."""

SHOWN = 3
"""Names that are shown."""


@dataclass(frozen=True, slots=True)
class Scripted:
    """A play, the script that was written of it, and what that compiles to."""

    play: Play
    written: Written
    script: Script
    resolved: Play


def compile_play(source: Source, world: World, voice: VoiceBox, settings: Settings) -> Compiled:
    """A play as far as its score, as `compile_source` does it for a script."""
    diagnostics = Diagnostics()
    found = script_of(source, world, source.name, diagnostics, settings)
    if found is None:
        return Compiled(source, Script(source, ()), diagnostics, lambda: None, voice, settings)
    play = replace(found.play, events=found.resolved.events) if settings.events else found.play
    return Compiled(source, found.script, diagnostics, lambda: play, voice, settings).finished()


def script_of(
    source: Source, world: World, name: str, diagnostics: Diagnostics, settings: Settings | None = None
) -> Scripted | None:
    """The script `name` of a play. None where it is no play, or one that no script says; `diagnostics` says why."""
    settings = settings or Settings()
    try:
        play = load(source.text, source.name, _Files(world).find)
    except NotAPlay as fault:
        diagnostics.add(diagnose("FS961", fault.span, name=source.name, reason=_short(fault.args[0])))
        return None
    written = write(play, world, name)
    told = Diagnostics()
    script = with_events(parse(Source(name, written.text), told), settings, told)
    resolved = resolve(script, world, told, settings.overrides)
    for item in told:
        if item.severity is not Severity.HINT:
            diagnostics.add(_at_home(item, script.source, written, source))
    if resolved is None or diagnostics.failed:
        return None
    scripted = Scripted(play, written, script, resolved)
    differing = _difference(scripted, settings)
    if differing is not None:
        span = differing.span or Span(source, 0, 0)
        value, other = _shown(differing.value), _shown(differing.other)
        diagnostics.add(diagnose("FS962", span, path=differing.path, value=value, other=other))
        return None
    return scripted


def renaming(written: Written) -> Diagnostic | None:
    """What is to be said of statements that bear another name in a script than in its play."""
    pairs = [f"`{old}` is `{new}`" for old, (new, _) in written.renamed.items()]
    if not pairs:
        return None
    more = f" and {len(pairs) - SHOWN} more" if len(pairs) > SHOWN else ""
    span = next(iter(written.renamed.values()))[1]
    return diagnose("FS963", span, names=", ".join(pairs[:SHOWN]) + more)


def _difference(scripted: Scripted, settings: Settings) -> Difference | None:
    names = {old: new for old, (new, _) in scripted.written.renamed.items()}
    events = scripted.play.events if settings.events else scripted.resolved.events
    return difference(scripted.play, replace(scripted.resolved, events=events), names)


class _Files:
    """The project's scripts and the library's, for places that a play notes in them."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.library = {source.name: source for source in world.library()}

    def find(self, name: str) -> Source | None:
        try:
            return self.library.get(name) or self.world.source(name)
        except WorldFailure:
            return None


def _at_home(item: Diagnostic, script: Source, written: Written, source: Source) -> Diagnostic:
    """What was said of a written script, at the place of the row in the play."""
    related = tuple(replace(each, span=_home(each.span, script, written, source)) for each in item.related)
    span = None if item.span is None else _home(item.span, script, written, source)
    return replace(item, span=span, related=related, fixes=())


def _home(span: Span, script: Source, written: Written, source: Source) -> Span:
    if span.source is not script:
        return span
    line = script.position(span.start)[0]
    found = written.rows[line - 1].span if line <= len(written.rows) else None
    return found if found is not None and found.source.name else Span(source, 0, 0)


def _shown(value: object) -> str:
    return _short(json.dumps(value, ensure_ascii=False, default=repr))


def _short(text: str) -> str:
    return text if len(text) <= LONGEST else text[:LONGEST] + "..."
