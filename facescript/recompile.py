"""A script that is edited again and again to its score: what an edit leaves as it was is not worked out again."""

from __future__ import annotations

from facescript.compile import Compiled, Settings, of_script
from facescript.diagnostics.model import Diagnostics
from facescript.resolve.memory import Memory
from facescript.schedule.kept import Kept
from facescript.speech.model import VoiceBox
from facescript.syntax.pieces import Pieces
from facescript.text import Source
from facescript.world import World


class Recompiler:
    """Compiles the states of one script, one after another.

    What `compile` gave before is not to be used any more once it is called again: places in it move with the text.
    """

    def __init__(self) -> None:
        self._pieces, self._memory, self._kept = Pieces(), Memory(), Kept()

    def compile(self, source: Source, world: World, voice: VoiceBox) -> Compiled:
        """The same as `compile_source`: tree, diagnostics, play and score; all but the tree when it is asked for."""
        diagnostics = Diagnostics()
        script = self._pieces.parse(source, diagnostics)
        return of_script(script, world, voice, diagnostics, Settings(), self._memory, self._kept)
