"""Lines that sound in a run to what its pages are told of them: the sound, and its captions with their times."""

from __future__ import annotations

from facescript.backends.captions.cues import LINGER, WIDEST, captions, joined
from facescript.backends.captions.said import timed, tokens
from facescript.backends.page.document import called
from facescript.backends.page.words import html_language
from facescript.ir.play import Play
from facescript.live.model import Utterance
from facescript.web.messages import numbers, text

MOST = 64
"""Lines that are remembered for pages which come while they sound."""

Caption = tuple[float, float, str]
"""From when to when, s from the line's start, and its text."""


class Lines:
    """The lines that sound now or soon, for the pages of a play; `language` is that of its first face."""

    def __init__(self, play: Play) -> None:
        several = len(play.faces) > 1
        self._names = {face.name: called(face.name) if several else "" for face in play.faces}
        self._languages = {face.name: html_language(face.voice.language) for face in play.faces}
        self.language = next(iter(self._languages.values()), "en")
        self._sounding: dict[int, Utterance] = {}

    def take(self, line: Utterance) -> bytes:
        """What pages are told of a line: all, or where they know it already where it breaks off."""
        known = self._sounding.pop(line.number, None)
        while len(self._sounding) >= MOST:
            del self._sounding[next(iter(self._sounding))]
        self._sounding[line.number] = line
        same = known is not None and (known.start, known.spoken) == (line.start, line.spoken)
        return text("cut", number=line.number, cut=line.cut) if same else self._told(line)

    def sounding(self, time: float) -> list[bytes]:
        """The lines that are not over at a time of the run."""
        self._sounding = {number: line for number, line in self._sounding.items() if _end(line) > time}
        return [self._told(line) for line in self._sounding.values()]

    def _told(self, line: Utterance) -> bytes:
        pcm = line.spoken.pcm
        about = {"number": line.number, "start": line.start, "cut": line.cut, "volume": line.volume}
        sound = {"rate": line.spoken.rate, "samples": len(pcm) // 2, "duration": line.spoken.duration}
        shown = {"captions": captions_of(line), "name": self._names[line.face], "language": self._languages[line.face]}
        return numbers("line", [pcm, bytes(-len(pcm) % 4)], **about, **sound, **shown)


def captions_of(line: Utterance) -> list[Caption]:
    """The captions of a line; each stays a little longer than its words, but not into the next."""
    parts = captions(tokens(line.text, timed(line.text, line.spoken)), WIDEST)
    nexts = [part[0].start for part in parts[1:]] + [float("inf")]
    return [
        (round(part[0].start, 3), round(min(part[-1].end + LINGER, following), 3), joined(part))
        for part, following in zip(parts, nexts, strict=True)
    ]


def _end(line: Utterance) -> float:
    return line.start + line.spoken.duration if line.cut is None else line.cut
