"""What a page drags to what it does to the script: acts of a `score` message get their handles, a `drag` its edit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import cast

from facescript.compile import Compiled
from facescript.preview.drag import Drags, Refused
from facescript.preview.dragging.tries import Handle
from facescript.preview.places import Units
from facescript.schedule.score import TimedAct
from facescript.text import Source
from facescript.web.messages import Message, text

HANDLES = ("start", "end", "body", "degree")

CLOSE = 0.001
"""Seconds by which a page's times are rounded, at most."""


class Hands:
    """The acts of one text of a script, `version`, as the page knows them: by their place in `acts`.

    `again` compiles another text, and must leave `compiled` as it is.
    """

    def __init__(
        self,
        version: int,
        compiled: Compiled,
        acts: Sequence[Message],
        units: Units,
        again: Callable[[Source], Compiled],
    ) -> None:
        self._version, self._compiled, self._acts, self._units, self._again = version, compiled, acts, units, again
        self._drags = Drags(compiled)
        self._timed: dict[int, list[TimedAct]] = {}
        for act in compiled.score.acts if compiled.score is not None else ():
            if act.span.source is compiled.source:
                self._timed.setdefault(act.span.start, []).append(act)

    def give_handles(self) -> None:
        """Notes in each act of the message what of it may be dragged."""
        for told in self._acts:
            act = self._act(told)
            told["handles"] = {} if act is None else self._drags.handles(act)

    def answer(self, asked: Message) -> bytes:
        """`dragged`, an edit of the text in UTF-16 units, or `refused`."""
        edit = self._edit(asked)
        if isinstance(edit, bytes):
            return edit
        start, end, new = edit
        return text("dragged", version=self._version, **{"from": start, "to": end, "text": new}, done=asked["done"])

    def _edit(self, asked: Message) -> tuple[int, int, str] | bytes:
        number, handle = cast(int, asked["id"]), asked["handle"]
        act = self._act(self._acts[number]) if 0 <= number < len(self._acts) else None
        if asked["version"] != self._version or act is None or handle not in HANDLES:
            return text("refused", what="", why="the script has changed since, or that is no act of it.")
        by = asked["degree"] if handle == "degree" else asked["by"]
        if not isinstance(by, int | float) or not abs(by) < float("inf"):
            return text("refused", what="", why="it is not said how far it was dragged.")
        release = cast(float, self._acts[number]["release"])
        found = self._drags.drag(act, cast(Handle, handle), float(by), self._made, release)
        if isinstance(found, Refused):
            return text("refused", what=found.what, why=found.why)
        return self._units.at(found.start), self._units.at(found.end), found.text

    def _made(self, changed: str) -> Compiled:
        return self._again(Source(self._compiled.source.name, changed))

    def _act(self, told: Message) -> TimedAct | None:
        """The act that a message tells of; None for one of another file."""
        place, start = told.get("from"), cast(float, told["start"])
        found = self._timed.get(self._units.offset(place), ()) if isinstance(place, int) else ()
        return next((act for act in found if abs(act.start - start) < CLOSE), None)
