"""A play to what its page offers: a button for each thing that can be touched, and the keys that are waited for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from facescript.ir.play import EventPattern, Play
from facescript.live.model import Happening
from facescript.schedule.events import heeds


@dataclass(frozen=True, slots=True)
class Offer:
    """The texts of `when touched "..."` in the order written, and the keys of `when key "..."`."""

    touched: tuple[str, ...]
    keys: tuple[str, ...]

    def happening(self, kind: str, text: str) -> Happening | None:
        """What a page tells of, as an event of now; None for what it does not offer."""
        if text not in (self.touched if kind == "touched" else self.keys):
            return None
        return Happening(kind, 0.0, text)


def offer(play: Play) -> Offer:
    """What the page of a play offers; the same thing once, however often it is waited for."""
    return Offer(tuple(_texts(play, "touched")), tuple(_texts(play, "key")))


def _texts(play: Play, kind: str) -> Iterator[str]:
    found: list[EventPattern] = []
    for event in (reaction.event for reaction in play.reactions if reaction.event.kind == kind):
        if not any(heeds(other, Happening(kind, 0.0, event.text)) for other in found):
            found.append(event)
            yield event.text
