"""Layouts, frames, marks and utterances to messages in JSON, and frames to packed bytes."""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.live.model import Frame, Layout, Mark, Utterance

VERSION = 1
"""Of the messages: another number where a reader of this one would go wrong."""

DECIMALS = 4
"""Of values in JSON: a ten-thousandth of a degree."""

HEAD = struct.Struct("<dII")
"""What a packed frame begins with: its time, its number, how many values follow. Sixteen bytes, so that the float32
behind them lie where a browser's `Float32Array` wants them."""


def layout_text(layout: Layout) -> str:
    """What comes first: the channels in the order of a frame's values."""
    channels = [
        {"name": name, "unit": channel.unit, "rest": channel.rest}
        for name, channel in zip(layout.names, layout.channels, strict=True)
    ]
    about = {"title": layout.title, "fps": layout.fps, "seed": layout.seed, "faces": list(layout.faces)}
    return _text({"type": "layout", "version": VERSION, **about, "channels": channels})


def frame_text(frame: Frame) -> str:
    """A frame with its values listed."""
    head = f'{{"type":"frame","number":{frame.number},"time":{frame.time:.6f},"values":'
    return f"{head}{_text(rounded(frame.values))}}}"


def frame_bytes(frame: Frame) -> bytes:
    """A frame packed, little-endian: `HEAD`, then float32."""
    return HEAD.pack(frame.time, frame.number, len(frame.values)) + frame.values.astype("<f4").tobytes()


class Named:
    """Frames whose values bear their names."""

    def __init__(self, names: Sequence[str]) -> None:
        self._keys = [f"{json.dumps(name, ensure_ascii=False)}:" for name in names]

    def text(self, frame: Frame) -> str:
        """A frame as one message."""
        return self._message(frame, self._pairs(frame))

    def texts(self, frame: Frame, largest: int) -> list[str]:
        """A frame as messages of at most `largest` bytes, each with some of the values."""
        texts: list[str] = []
        held: list[str] = []
        empty = room = largest - len(self._message(frame, []))
        for pair in self._pairs(frame):
            size = len(pair.encode()) + 1
            if held and size > room:
                texts.append(self._message(frame, held))
                held, room = [], empty
            held.append(pair)
            room -= size
        return [*texts, self._message(frame, held)]

    def _pairs(self, frame: Frame) -> list[str]:
        return [f"{key}{value}" for key, value in zip(self._keys, rounded(frame.values), strict=True)]

    def _message(self, frame: Frame, pairs: list[str]) -> str:
        head = f'{{"type":"frame","number":{frame.number},"time":{frame.time:.6f},"values":{{'
        return f"{head}{','.join(pairs)}}}}}"


def mark_text(mark: Mark) -> str:
    about = {"kind": mark.kind, "time": round(mark.time, 6), "text": mark.text, "face": mark.face, "label": mark.label}
    return _text({"type": "mark", **about, "late": round(mark.late, 6)})


def utterance_text(utterance: Utterance) -> str:
    """A line with the times of its words, s of the run."""
    start, spoken = utterance.start, utterance.spoken
    words = [
        {"text": word.text, "start": round(start + word.start, 6), "end": round(start + word.end, 6)}
        for word in spoken.words
    ]
    about = {"number": utterance.number, "face": utterance.face, "text": utterance.text, "start": round(start, 6)}
    times = {"duration": round(spoken.duration, 6), "volume": utterance.volume, "cut": utterance.cut}
    return _text({"type": "utterance", **about, **times, "words": words})


def rounded(values: NDArray[np.float64]) -> list[float]:
    """As they stand in JSON; what is no number there is at rest."""
    found: list[float] = (np.round(np.nan_to_num(values), DECIMALS) + 0.0).tolist()
    return found


def _text(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))
