"""What a source is told of the run besides its address."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from facescript.ir.play import Play
from facescript.live.clock import Clock
from facescript.live.hearing.own_voice import OwnVoice
from facescript.live.ports import Ports
from facescript.live.talk.conversation import Conversation
from facescript.world import World


@dataclass(frozen=True, slots=True)
class Setting:
    """`play` is what is run, `world` its project; `clock` is the run's, for who knows when something was. `ports` are
    the servers that parts of a run share, `token` is what those must know who come from other machines. `tell` gets a
    sentence for who runs it; `status` says how the run goes, for who asks. `talk` is what
    programs tell faces, `own` when these are heard."""

    play: Play
    world: World
    clock: Clock
    ports: Ports
    token: str
    tell: Callable[[str], None]
    status: Callable[[], dict[str, object]]
    talk: Conversation | None = None
    own: OwnVoice = field(default_factory=OwnVoice)

    def phrases(self) -> tuple[str, ...]:
        """What the script waits to hear, in the order written, each once."""
        heard = (one.event.text for one in self.play.reactions if one.event.kind == "heard")
        return tuple(dict.fromkeys(heard))
