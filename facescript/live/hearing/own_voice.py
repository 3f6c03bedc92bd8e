"""The lines of a run to when the face itself is heard: what a microphone takes up then is no answer."""

from __future__ import annotations

from facescript.live.model import Frame, Layout, Mark, Utterance

AFTER = 0.3
"""Seconds behind a line's last sound until the room and the loudspeaker's delay are quiet."""

KEPT = 64


class OwnVoice:
    """A sink that keeps when lines sound."""

    def __init__(self) -> None:
        self._spans: dict[int, tuple[float, float]] = {}

    def sounds(self, time: float) -> bool:
        """Whether a line is heard at a time of the run, s."""
        return any(start <= time < end + AFTER for start, end in self._spans.values())

    def utter(self, utterance: Utterance) -> None:
        end = utterance.start + utterance.spoken.duration if utterance.cut is None else utterance.cut
        self._spans.pop(utterance.number, None)
        self._spans[utterance.number] = (utterance.start, end if utterance.volume > 0.0 else utterance.start - AFTER)
        while len(self._spans) > KEPT:
            del self._spans[next(iter(self._spans))]

    async def open(self, layout: Layout) -> None: ...

    def frame(self, frame: Frame) -> None: ...

    def mark(self, mark: Mark) -> None: ...

    async def close(self) -> None: ...

    def counts(self) -> dict[str, int]:
        return {}
