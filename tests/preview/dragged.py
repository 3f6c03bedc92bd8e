"""A script, an act in it by its words, and a drag, to the script after it or to why it was refused."""

from __future__ import annotations

from pathlib import Path

from facescript.compile import Compiled, compile_source
from facescript.preview.drag import Drags, Refused
from facescript.preview.dragging.amounts import Change
from facescript.preview.dragging.tries import Handle
from facescript.recompile import Recompiler
from facescript.schedule.score import TimedAct
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.formatter import format_source
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[2] / "examples"
WORLD = World(ROOT)


class Desk:
    """A script with its acts, and what it would be with another text."""

    def __init__(self, text: str, name: str = "main.face") -> None:
        self.text, self.name = text, name
        self.voice = EstimatedVoice(WORLD)
        self.compiled = compile_source(Source(name, text), WORLD, self.voice)
        assert self.compiled.score is not None, [item.message for item in self.compiled.diagnostics]
        self.score = self.compiled.score
        self.drags = Drags(self.compiled)
        self._again = Recompiler()

    def again(self, text: str) -> Compiled:
        return self._again.compile(Source(self.name, text), WORLD, self.voice)

    def act(self, words: str) -> TimedAct:
        return next(act for act in self.score.acts if act.span.text.startswith(words))

    def drag(self, act: TimedAct, handle: Handle, by: float) -> Change | Refused:
        scene = self.score.scenes[act.scene]
        return self.drags.drag(act, handle, by, self.again, min(act.released, scene.end))

    def after(self, words: str, handle: Handle, by: float) -> str:
        """The text after a drag, which has the layout that it had before; of one that is refused, why."""
        change = self.drag(self.act(words), handle, by)
        if isinstance(change, Refused):
            return change.why
        text = self.text[: change.start] + change.text + self.text[change.end :]
        if laid_out(self.text) == self.text:
            assert laid_out(text) == text
        return text


def laid_out(text: str) -> str:
    return format_source(Source("", text))
