"""The lines of a score to one sound file for the page, and to how loud it is, a block at a time."""

from __future__ import annotations

import os
import wave
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from facescript.schedule.score import Score
from facescript.speech.sound.mix import soundtrack
from facescript.web.messages import text

PEAKS = 100
"""Peaks a second."""

LOUDEST = 32_768 / 255


class Sound:
    """The sound of one script after another, in files of `folder`; the last two are there."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._number = 0
        self._heard: object = None

    def mix(self, score: Score, version: int) -> Iterator[bytes | None]:
        """Mixes the sound, a block a step; what the page is told of it comes at the end, and nothing where the sound is
        the same as before."""
        track = soundtrack(score)
        heard = track.rate, len(track), [(line.start, line.cut, line.volume, line.spoken) for line in score.lines]
        if heard == self._heard:
            return
        name, first = self._name(self._number + 1), 0
        peaks = np.zeros(-(-len(track) * PEAKS // track.rate), np.int32)
        with wave.open(str(self._folder / name), "wb") as file:
            file.setparams((1, 2, track.rate, 0, "NONE", ""))
            for block in track.blocks():
                file.writeframes(block.astype("<i2").tobytes())
                places = (first + np.arange(len(block))) * PEAKS // track.rate
                np.maximum.at(peaks, places, np.abs(block.astype(np.int32)))
                first += len(block)
                yield None
        self._heard = heard
        self._number += 1
        (self._folder / self._name(self._number - 2)).unlink(missing_ok=True)
        url = f"sound/{name}" if peaks.any() else None
        levels = np.minimum(np.rint(peaks / LOUDEST), 255).astype(int).tolist()
        yield text("sound", version=version, url=url, rate=PEAKS, peaks=levels)

    def _name(self, number: int) -> str:
        """The name of a file; another process has others."""
        return f"{os.getpid()}-{number}.wav"
