"""Mandarin read and spoken, sound files read, and the soundtrack mixed: how quickly, in how much memory, how clean."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
import wave
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from row import Row

from facescript.speech.lines import Piece
from facescript.speech.mandarin.units import units
from facescript.speech.model import Spoken
from facescript.speech.sound.mix import Soundtrack, soundtrack
from facescript.speech.sound.resample import resampled

TEXT = "小明在长城脚下长大，他的奶奶常常说：“你一定要走到山的那一边。”2021年3月5日10:30，他用Python写了25行。"
LONG = 20_000

READ = """
import json, resource, sys, time
from pathlib import Path
from facescript.speech.sound.recording import read_recording
begun = time.process_time()
sound = read_recording(Path(sys.argv[1]))
own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
used = time.process_time() - begun + others.ru_utime + others.ru_stime
print(json.dumps([sound.duration, used, own.ru_maxrss / 1024, sound.samples.nbytes / 2**20]))
"""
"""Reads a recording; prints its seconds, the processor's, the peak resident MB and those of the sound itself."""


@dataclass(frozen=True)
class Line:
    start: float
    spoken: Spoken
    volume: float = 1.0
    cut: float | None = None


@dataclass(frozen=True)
class Lines:
    lines: tuple[Line, ...]
    duration: float


def rows() -> Iterator[Row]:
    yield _characters()
    yield from _hour()
    yield from _three_hours()
    yield _clean()


def _characters() -> Row:
    text = (TEXT * (LONG // len(TEXT) + 1))[:LONG]
    units(Piece(TEXT, 0, len(TEXT), ()), TEXT)  # the dictionary is loaded once
    begun = time.process_time()
    found = units(Piece(text, 0, len(text), ()), text)
    used = time.process_time() - begun
    count = sum(len(unit.syllables) for unit in found)
    return Row(f"{LONG} characters of Mandarin to syllables", "1 s", f"{used:.2f} s, {count} syllables", used <= 1.0)


def _hour() -> Iterator[Row]:
    """An hour of noise and tone at 44,100 Hz in two channels."""
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        path = Path(folder) / "hour.wav"
        minute = np.random.default_rng(1).normal(0.0, 3_000.0, (60 * 44_100, 2)).astype("<i2").tobytes()
        with wave.open(str(path), "wb") as out:
            out.setparams((2, 2, 44_100, 0, "NONE", ""))
            for _ in range(60):
                out.writeframesraw(minute)
        done = subprocess.run([sys.executable, "-c", READ, str(path)], capture_output=True, text=True, check=True)
    length, used, memory, size = json.loads(done.stdout)
    yield Row(
        "an hour of WAV, stereo, 44.1 kHz: time of its length", "0.01", f"{used / length:.4f}", used <= 0.01 * length
    )
    held = f"{memory:.0f} MB, {size:.0f} of them its sound"
    yield Row("the same: memory", "450 MB", held, memory <= 450.0)


def _three_hours() -> Iterator[Row]:
    for rate, name in ((22_050, "the voice's"), (48_000, "48 kHz")):
        line = Spoken(
            np.random.default_rng(2).integers(-9_000, 9_000, 22_050 * 60).astype("<i2").tobytes(), 22_050, 60.0, (), ()
        )
        track = soundtrack(Lines(tuple(Line(60.0 * minute, line) for minute in range(180)), 10_800.0))
        track = Soundtrack(track.lines, rate, 0, 10_800 * rate)
        begun = time.process_time()
        count = sum(len(block) for block in track.blocks())
        used = time.process_time() - begun
        assert count == len(track)
        yield Row(
            f"three hours mixed at {name} rate: time of its length", "0.01", f"{used / 10_800:.4f}", used <= 108.0
        )


def _clean() -> Row:
    """The worst of five tones at six ratios: everything that is not the tone, below it."""
    worst = 200.0
    for rate, wanted in ((16_000, 22_050), (22_050, 48_000), (22_050, 44_100), (44_100, 48_000), (8_000, 22_050)):
        for share in (0.05, 0.2, 0.43, 0.65, 0.83):
            tones = [30_000.0 * np.sin(np.pi * share * min(rate, wanted) * np.arange(at) / at) for at in (rate, wanted)]
            found = resampled(np.rint(tones[0]).astype(np.int16), rate, wanted, 0, wanted)
            inner = slice(wanted // 5, -wanted // 5)
            noise = np.square((found - tones[1])[inner]).mean() - 1.0 / 12.0 * min(1.0, rate / wanted)
            worst = min(worst, float(10.0 * np.log10(np.square(tones[1][inner]).mean() / max(noise, 1e-9))))
    return Row("resampled tones: noise, images and aliases below", "80 dB", f"{worst:.0f} dB", worst >= 80.0)
