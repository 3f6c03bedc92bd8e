"""Voices: how soon a line is heard in a warm worker, how long speaking takes, and what a kept line costs."""

from __future__ import annotations

import os
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace

from row import Row

from facescript.ir.acts import Say, Voice
from facescript.speech.espeak.client import Espeak
from facescript.speech.espeak.engine import EspeakEngine
from facescript.speech.espeak.voicebox import EspeakVoice
from facescript.speech.flite.engine import FliteEngine
from facescript.speech.flite.program import program
from facescript.speech.model import Spoken
from facescript.speech.voices.kept import KeptVoice

TEXTS = {
    "en-us": "The council has voted, by forty to thirty, to close the old harbour bridge. Nobody was surprised.",
    "cmn": "市议会以四十票对三十票决定关闭旧港口大桥。没有人感到惊讶，因为它已经很旧了。",
    "de": "Der Stadtrat hat mit vierzig zu dreißig Stimmen beschlossen, die alte Hafenbrücke zu schließen.",
}
LONG = 10
"""Times the text, for a line of a minute."""

RUNS = 20


def rows() -> Iterator[Row]:
    voice = EspeakVoice(Espeak())
    for language, text in TEXTS.items():
        said = Say(text, Voice(language))
        voice.speak(said)
        yield first_sound(voice, said, f"first sound, {language}, one sentence or two")
        yield first_sound(voice, replace(said, text=text * LONG), f"first sound, {language}, {LONG} times as long")
        yield speaking(voice.speak, replace(said, text=text * 6), f"speaking, {language}")
    yield speaking(voice.speak, Say(("Zürich " * 2857)[:20_000], Voice("de")), "speaking, 20,000 characters")
    yield from kept()
    if program() is not None:
        said = Say(TEXTS["en-us"], Voice("en-us", "slt", engine="flite"))
        yield speaking(FliteEngine().speak, said, "speaking, flite slt", held=False)


def first_sound(voice: EspeakVoice, said: Say, what: str) -> Row:
    """Milliseconds from the question to the first stretch of sound, each time in another line."""
    found = []
    for run in range(RUNS):
        waited: list[float] = []
        begun = time.perf_counter()
        voice.speak(
            replace(said, text=f"{run}, {said.text}"), lambda pcm, w=waited, b=begun: w.append(time.perf_counter() - b)
        )
        found.append(1000 * waited[0])
    median, most = statistics.median(found), statistics.quantiles(found, n=20)[-1]
    return Row(what, "60 ms", f"median {median:.0f} ms, 19 in 20 within {most:.0f} ms", most <= 60)


def speaking(speak: Callable[[Say], Spoken], said: Say, what: str, held: bool = True) -> Row:
    """Seconds to seconds of sound; most of the work is in another process, so the clock on the wall tells."""
    begun = time.perf_counter()
    length = speak(said).duration
    share = (time.perf_counter() - begun) / length
    bar, met = ("0.02 of the audio", share <= 0.02) if held else ("", None)
    return Row(what, bar, f"{share:.4f} of {length:.0f} s", met)


def kept() -> Iterator[Row]:
    """What a line costs that another program has spoken."""
    before = os.environ.get("XDG_CACHE_HOME")
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_CACHE_HOME"] = folder
        said = Say(TEXTS["en-us"] * 6, Voice())
        KeptVoice(EspeakEngine()).speak(said)
        yield speaking(KeptVoice(EspeakEngine()).speak, said, "a line that is kept")
    if before is None:
        del os.environ["XDG_CACHE_HOME"]
    else:
        os.environ["XDG_CACHE_HOME"] = before
