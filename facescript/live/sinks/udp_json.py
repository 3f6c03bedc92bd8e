"""A run to datagrams of JSON: the channels of a frame by their names, marks and lines."""

from __future__ import annotations

from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.sinks.bundles import LARGEST
from facescript.live.sinks.datagrams import DatagramSink
from facescript.live.sinks.messages import Named, mark_text, utterance_text

LARGEST_LINE = 60_000
"""Bytes of a line with its words; a longer one does not go into a datagram."""


class UdpJsonSink(DatagramSink):
    """A frame is one message or some, each with a part of the channels: whoever takes the values as they come has the
    face, without having seen the beginning."""

    def begin(self, layout: Layout) -> None:
        self._named = Named(layout.names)

    def packets(self, frame: Frame) -> list[bytes]:
        return [text.encode() for text in self._named.texts(frame, LARGEST)]

    def mark(self, mark: Mark) -> None:
        self._tell(mark_text(mark))

    def utter(self, utterance: Utterance) -> None:
        self._tell(utterance_text(utterance))

    def _tell(self, text: str) -> None:
        packet = text.encode()
        if len(packet) > LARGEST_LINE:
            self._counts["dropped"] += 1
        else:
            self.send([packet])
