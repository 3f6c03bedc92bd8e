"""What a sink is told of the run besides its address."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, field

from facescript.live.ports import Ports


def _aloud(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


@dataclass(frozen=True, slots=True)
class Setting:
    """`token` is what those must know who come from other machines. `patient`: the run's time is not real, so that a
    file that takes its time is waited for. `tell` gets a sentence for who runs it. `ports` are the servers that parts
    of the run share; who opens the sinks opens them."""

    token: str = ""
    patient: bool = False
    tell: Callable[[str], None] = _aloud
    ports: Ports = field(default_factory=Ports)
