"""Texts to sound and events by the espeak-ng worker."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from facescript.speech.model import VoiceFailure
from facescript.speech.voices.process import Answer, Worker

WORKER = Path(__file__).with_name("worker.py")
SECONDS = 25.0
"""A part of an answer that takes longer ends the worker; what it leaves behind ends by its own watchdog, later."""

LONGEST_TEXT = 200_000
"""Characters of one utterance, tags included."""


@dataclass(frozen=True, slots=True)
class Utterance:
    """What the worker speaks at once: `rate` in words a minute (80..450), `pitch` and `range` 0..100 (50: as usual).

    `ssml` texts carry tags, `phonemes` texts carry `[[...]]` in the voice's own phoneme names.
    """

    text: str
    voice: str
    rate: int = 175
    pitch: int = 50
    ssml: bool = False
    phonemes: bool = False
    range: int = 50


@dataclass(frozen=True, slots=True)
class Heard:
    """A word or phone begins: `sample` of the sound, `place` in the text (characters, from 0), `symbol` IPA or ""."""

    kind: str
    sample: int
    place: int
    symbol: str


@dataclass(frozen=True, slots=True)
class Sound:
    """An utterance as sound: 16-bit little-endian mono, and what begins where."""

    pcm: bytes
    rate: int
    events: tuple[Heard, ...]


class Espeak:
    """The worker, started when first asked. Every method raises `VoiceFailure` where it cannot answer."""

    def __init__(self, worker: Path = WORKER, seconds: float = SECONDS) -> None:
        self._worker = Worker(worker, seconds)

    def speak(self, utterance: Utterance, take: Callable[[Sound], None] = lambda stretch: None) -> Sound:
        """The sound of a text, the same bytes every time; `take` gets it in stretches, as it is made."""
        if len(utterance.text) > LONGEST_TEXT:
            raise VoiceFailure(f"it takes at most {LONGEST_TEXT} characters at a time")
        stretches: list[Sound] = []

        def heard(part: Answer) -> None:
            stretches.append(Sound(part[1], int(part[0]["rate"]), tuple(Heard(*event) for event in part[0]["events"])))
            take(stretches[-1])

        self._worker.ask({"do": "speak", **asdict(utterance)}, heard)
        events = tuple(event for stretch in stretches for event in stretch.events)
        return Sound(b"".join(stretch.pcm for stretch in stretches), stretches[0].rate, events)

    def voices(self) -> dict[str, Any]:
        """`voices` (name, identifier, languages with priority) and `variants` (name, identifier, gender)."""
        answers: list[Answer] = []
        self._worker.ask({"do": "voices"}, answers.append)
        return answers[0][0]

    def close(self) -> None:
        """End the worker; the next question starts another."""
        self._worker.close()
