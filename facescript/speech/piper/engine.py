"""Lines to speech by a piper voice that the author brings, with the times of their words and phones."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from facescript.ir.acts import Say, Voice
from facescript.speech.espeak.manner import MANDARIN
from facescript.speech.espeak.parts import Part, joined, spoken, trimmed
from facescript.speech.lines import Piece, pieces, words
from facescript.speech.model import Spoken, VoiceFailure
from facescript.speech.piper.phones import phones, symbols
from facescript.speech.readings import check_readings, ipa_of
from facescript.speech.voices.engine import stamp, stamp_of_package
from facescript.speech.voices.manner import doubts, with_bursts
from facescript.speech.voices.process import Answer, Worker
from facescript.speech.voices.wording import begun_words, word_times
from facescript.world import World, WorldFailure

WORKER = Path(__file__).with_name("worker.py")
SECONDS = 120.0
"""A sentence that takes longer ends the worker."""

SLOWEST, FASTEST = 0.25, 4.0
BREATH = 0.25
"""Seconds of silence between sentences."""


class PiperEngine:
    """piper, with the voices of a project."""

    def __init__(self, world: World) -> None:
        self._world = world

    def speak(self, line: Say) -> Spoken:
        model = self._model(line.voice)
        _check(line)
        found = pieces(line)
        told = [part for part in found if isinstance(part, Piece)]
        request = {"voice": str(model), "pieces": [_told(piece) for piece in told], "slow": 1 / line.voice.rate}
        answers: list[Answer] = []
        _worker().ask(request, answers.append)
        last, _ = answers.pop()
        _check_language(line.voice, last["language"])
        parts = [
            _part(piece, [answer for answer in answers if answer[0]["piece"] == number], last["words"][number])
            for number, piece in enumerate(told)
        ]
        rest = iter(parts)
        whole = joined([part if isinstance(part, float) else next(rest) for part in found], parts[0].rate)
        return replace(spoken(whole), doubts=doubts(line, ("pitch", "range", "stress")))

    def identity(self, voice: Voice) -> str:
        try:
            model = self._world.path(voice.variant)
            files = stamp(model, model.with_name(f"{model.name}.json"))
        except (OSError, WorldFailure):
            return ""
        packages = [stamp_of_package(name) for name in ("piper", "onnxruntime")]
        return " ".join([files, *packages]) if all(packages) else ""

    def voices(self) -> Iterable[tuple[str, str]]:
        _check_installed()
        yield 'en-us piper "FILE.onnx"', "a voice file of yours"

    def _model(self, voice: Voice) -> Path:
        """The voice's file. Raises `VoiceFailure`."""
        _check_installed()
        try:
            model = self._world.path(voice.variant)
        except WorldFailure as failure:
            raise VoiceFailure(f"`{voice.variant}`: {failure.args[0]}") from None
        if not model.is_file():
            raise VoiceFailure(f"there is no file `{voice.variant}`")
        if not model.with_name(f"{model.name}.json").is_file():
            raise VoiceFailure(f"beside `{voice.variant}` there is no `{model.name}.json`, which tells how it speaks")
        return model


@cache
def _worker() -> Worker:
    return Worker(WORKER, SECONDS)


def _check_installed() -> None:
    if find_spec("piper") is None:
        raise VoiceFailure("piper is not installed: `pip install 'piper-tts[alignment]'`", "FS507")


def _check(line: Say) -> None:
    """Raises `VoiceFailure` for what piper cannot be asked."""
    check_readings(line)
    if not SLOWEST <= line.voice.rate <= FASTEST:
        limits = f"{SLOWEST:.0%} to {FASTEST:.0%}"
        raise VoiceFailure(f"a rate of {line.voice.rate:.0%} lies outside what piper speaks, {limits}")
    for mark in line.stretches:
        if mark.kind == "reading" and line.voice.language.lower() in MANDARIN:
            raise VoiceFailure(f"piper takes no pinyin such as `{mark.value}`", "FS502")


def _check_language(voice: Voice, code: str) -> None:
    """Raises `VoiceFailure` where the voice's file is of another language than the script says."""
    told, wanted = (("cmn" if one in MANDARIN else one) for one in (_base(code), _base(voice.language)))
    if told != wanted:
        raise VoiceFailure(f"the voice in `{voice.variant}` speaks `{code}`, not `{voice.language}`")


def _base(code: str) -> str:
    return code.lower().replace("_", "-").split("-")[0]


def _told(piece: Piece) -> tuple[str, list[str]]:
    """The piece and its words as piper takes them."""
    return _said(piece, 0, len(piece.text)), [_said(piece, word.first, word.last) for word in words(piece.text)]


def _said(piece: Piece, first: int, last: int) -> str:
    """A stretch of a piece with its readings: `[[` begins phonemes, a control character would end the text."""
    readings = piece.readings()
    text = ""
    for at in range(first, last):
        reading = readings.get(piece.first + at)
        if reading is None:
            sign = piece.text[at]
            text += " " if unicodedata.category(sign) == "Cc" else {"[": "(", "]": ")"}.get(sign, sign)
        elif reading.start == piece.first + at:
            ipa = ipa_of(reading)
            text += reading.value if ipa is None else f"[[{unicodedata.normalize('NFD', ipa)}]]"
    return text


def _part(piece: Piece, answers: Sequence[Answer], apart: Sequence[Sequence[str]]) -> Part:
    """The sentences that piper made of a piece, put together."""
    sentences: list[Part | float] = []
    for head, pcm in answers:
        heard = tuple(with_bursts(phones(head["sounds"], head["rate"])))
        if any(phone.symbol for phone in heard):
            sentences += [BREATH] if sentences else []
            sentences.append(Part(pcm, (), heard, head["rate"]))
    if not sentences:
        raise VoiceFailure(f"this voice has no sound for `{piece.text.strip()}`", "FS503")
    whole = joined(sentences, answers[0][0]["rate"])
    begun = begun_words(whole.phones, [symbols(word) for word in apart])
    whole = replace(whole, words=word_times(piece, begun, whole.phones))
    sounding = [phone for phone in whole.phones if phone.symbol]
    return trimmed(whole, (sounding[0].start, sounding[-1].end))


def open_piper(world: World) -> PiperEngine:
    """The engine, with the voices of a project."""
    return PiperEngine(world)
