"""The mouth of a recording alone against the phonemes that were spoken: recall over four classes, speed and memory."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from time import process_time

import numpy as np
from listen_people import AN4, an4
from listen_takes import HELD_OUT
from listen_texts import MEASURED
from listen_voices import Take, espeak, flite
from row import Row

from facescript.speech.listen.bands import FRAMES_A_SECOND
from facescript.speech.listen.classes import CLASSES, frames
from facescript.speech.listen.listened import listened
from facescript.speech.listen.loop import bursting, installed, labelled, looped
from facescript.speech.model import PhoneTime
from facescript.speech.sound.recording import Recording, read_recording

Hearing = Callable[[Recording], tuple[PhoneTime, ...]]

RECORDINGS = Path(__file__).parents[3] / "shared" / "data" / "speech"

FLITE = ("kal16", "awb", "rms", "slt")

VOICES = {"espeak-ng": HELD_OUT, "flite": FLITE}
"""Those that are measured."""

BAR = 0.75

SAMPA = {"@": "ə", "D": "ð", "V": "ʌ", "A": "ɑ", "eI": "eɪ", "aI": "aɪ", "r": "ɹ"}


def rows() -> Iterator[Row]:
    """Every figure is of voices that nothing was trained on. So are the sentences, but for what AN4's people spell and
    count: they use the words and the microphone of those who were learnt from."""
    for name, takes in {"espeak-ng": _espeak("en-us"), "flite": _flite()}.items():
        if takes:
            what = f"a recording alone: English, {len(VOICES[name])} voices of {name}, recall over 4 classes"
            yield _row(what, takes)
    if takes and installed():
        yield _row("the same with the extra `english`", takes, looped)
    mandarin = f"a recording alone: Mandarin, {len(HELD_OUT)} voices of espeak-ng, recall over 4 classes"
    yield _row(mandarin, _espeak("cmn"))
    people = list(_people())
    if people:
        yield _told("a recording alone: five English recordings of people, recall over 4 classes", people)
    if AN4.exists() and installed():
        yield _told("a recording alone: ten people of AN4 who spell and count, recall over 4 classes", an4("test"))
    yield _speed()
    yield _hour()


def _row(what: str, takes: Iterable[Take], hear: Hearing = listened) -> Row:
    shares = recalls(takes, hear)
    each = ", ".join(f"{name} {share:.0%}" for name, share in zip(CLASSES[1:], shares, strict=True))
    mean = float(np.mean(shares))
    return Row(what, f"at least {BAR:.0%}", f"{mean:.1%} ({each})", mean >= BAR)


def _told(what: str, takes: Iterable[Take]) -> Row:
    """A row that is held to nothing: its labels were not made by a voice."""
    return replace(_row(what, takes), bar="told", met=None)


def _espeak(language: str) -> list[Take]:
    return [espeak(text, language, voice) for text in MEASURED[language].splitlines() for voice in HELD_OUT]


def _flite() -> list[Take]:
    """None where flite is not installed."""
    texts = MEASURED["en-us"].splitlines() if shutil.which("flite") else []
    return [flite(text, voice) for text in texts for voice in FLITE]


def recalls(takes: Iterable[Take], hear: Hearing) -> list[float]:
    """The share of the frames of each class, silence left out, in which the heard mouth is in it too."""
    pairs = []
    for take in takes:
        count = round(take.recording.duration * FRAMES_A_SECOND)
        pairs.append((frames(take.phones, count)[1], frames(hear(take.recording), count)[1]))
    truth, heard = (np.concatenate(part) for part in zip(*pairs, strict=True))
    return [float((heard[truth == place] == place).mean()) for place in range(1, len(CLASSES))]


def _people() -> Iterator[Take]:
    """The recordings with labels: by hand, by a model of the speaker, and by pocketsphinx."""
    for path in sorted(RECORDINGS.glob("*.wav")):
        recording = read_recording(path)
        yield Take(recording, tuple(bursting(_labels(path, recording.duration))))


def _labels(path: Path, duration: float) -> list[PhoneTime]:
    if path.with_suffix(".TextGrid").exists():
        tier = path.with_suffix(".TextGrid").read_text("utf-8").split('"syllable"')[0].split('"phons"')[1]
        segments = re.findall(r'([\d.]+)\s+([\d.]+)\s+"([^"]*)"', tier)
        return [PhoneTime(SAMPA.get(name, name), float(start), float(end)) for start, end, name in segments]
    if path.with_suffix(".phone.json").exists():
        whole = json.loads(path.with_suffix(".phone.json").read_text("utf-8"))
        return labelled([(phone["t"], phone["b"] + phone["d"]) for word in whole["w"] for phone in word["w"]], duration)
    lines = path.with_name(path.stem + "_phone.lab").read_text("utf-8").splitlines()
    found = [re.match(r"\d+ (\d+) [^-]*-([^+]*)\+", line) for line in lines]
    return labelled([(match[2], int(match[1]) * 1e-7) for match in found if match], duration)


def _speed() -> Row:
    """Processor time against the length of ten minutes."""
    recording = _long(600.0)
    listened(_long(10.0))
    begun = process_time()
    listened(recording)
    share = (process_time() - begun) / recording.duration
    return Row("a recording alone: processor time, part of its length", "at most 0.02", f"{share:.4f}", share <= 0.02)


def _long(seconds: float) -> Recording:
    take = espeak(" ".join(MEASURED["en-us"].splitlines()), "en-us").recording
    return Recording(np.resize(take.samples, round(seconds * take.rate)), take.rate)


def _hour() -> Row:
    """The memory of a process that listens to an hour, the hour itself left out."""
    program = (
        "import resource, measure_listen as m; sound = m._long(3600.0);"
        "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss; m.listened(sound);"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=Path(__file__).parent, capture_output=True, check=True)
    grown = int(done.stdout) / 1024
    return Row(
        "a recording alone: memory that an hour takes besides its sound",
        "at most 300 MB",
        f"{grown:.0f} MB",
        grown <= 300,
    )
