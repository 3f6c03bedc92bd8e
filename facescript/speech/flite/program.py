"""English sentences to sound and phones by the program flite, one call a sentence."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import wave
from dataclasses import dataclass
from pathlib import Path

from facescript.speech.model import PhoneTime, VoiceFailure
from facescript.speech.timing.alphabets import ARPABET

SECONDS = 60.0
"""A call that takes longer is ended."""

SILENCES = ("pau", "ssil", "brth")

PHONE = re.compile(r"(\w+):([\d.]+)")


@dataclass(frozen=True, slots=True)
class Sentence:
    """A sentence as sound: 16-bit little-endian mono at `rate` Hz, and its phones, plosives with their closures."""

    pcm: bytes
    rate: int
    phones: tuple[PhoneTime, ...]


@dataclass(frozen=True, slots=True)
class Manner:
    """A voice's name, and how many times the usual it is slow and high."""

    voice: str
    stretch: float
    shift: float

    def words(self) -> list[str]:
        """The options of the program."""
        return [
            *("-voice", self.voice),
            *("--setf", f"duration_stretch={self.stretch:.4g}", "--setf", f"f0_shift={self.shift:.4g}"),
        ]


def program() -> Path | None:
    """Where flite is; None where it is not installed."""
    found = shutil.which("flite")
    return None if found is None else Path(found)


def voice_names() -> tuple[str, ...]:
    """The names of its voices. Raises `VoiceFailure`."""
    return tuple(_run(["-lv"]).partition(":")[2].split())


def speak(text: str, manner: Manner) -> Sentence:
    """One sentence in ASCII. Raises `VoiceFailure`."""
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "sentence.wav"
        said = _run([*manner.words(), "-psdur", "-t", text, "-o", str(path)])
        try:
            with wave.open(str(path)) as sound:
                pcm, rate = sound.readframes(sound.getnframes()), sound.getframerate()
        except (OSError, EOFError, wave.Error):
            raise VoiceFailure("flite made no sound") from None
    return Sentence(pcm, rate, _phones(said, len(pcm) / 2 / rate))


def words_apart(words: list[str], manner: Manner) -> list[tuple[str, ...]]:
    """The phones of words in ASCII, each spoken by itself. Raises `VoiceFailure`."""
    with tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        path = Path(folder) / "words.txt"
        path.write_text("".join(f"{word}.\n\n" for word in words), "ascii")
        lines = _run([*manner.words(), "-ps", "-f", str(path), "-o", "none"]).strip().splitlines()
    found = [tuple(symbol for name in line.split() if (symbol := _ipa(name))) for line in lines]
    return found if len(found) == len(words) else []


def _phones(said: str, total: float) -> tuple[PhoneTime, ...]:
    phones: list[PhoneTime] = []
    start = 0.0
    for name, end in PHONE.findall(said):
        if min(float(end), total) > start:
            phones.append(PhoneTime(_ipa(name), start, min(float(end), total)))
            start = phones[-1].end
    return tuple(phones)


def _ipa(name: str) -> str:
    """A phone of flite as IPA; "" is silence."""
    return "" if name in SILENCES else ARPABET.get(name.upper(), name)


def _run(words: list[str]) -> str:
    found = program()
    if found is None:
        raise VoiceFailure("the program flite is not installed; Debian has it: `apt install flite`", "FS507")
    try:
        done = subprocess.run(
            [str(found), *words], capture_output=True, stdin=subprocess.DEVNULL, timeout=SECONDS, text=True
        )
    except subprocess.TimeoutExpired:
        raise VoiceFailure(f"flite did not answer within {SECONDS:g} s") from None
    except OSError as fault:
        raise VoiceFailure(f"flite cannot be run: {fault.strerror}") from None
    if done.returncode:
        raise VoiceFailure(f"flite broke off{': ' if done.stderr.strip() else ''}{done.stderr.strip()[:200]}")
    return done.stdout
