"""Recordings with their words: how near words and phones are to where they are said, how fast, in how much memory."""

from __future__ import annotations

import resource
import subprocess
import sys
from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np
from labels import FOLDER, Labelled, pairs, read
from row import Row

from facescript.ir.acts import Say, Voice
from facescript.speech.align.aligned import aligned
from facescript.speech.espeak.voicebox import process_voice
from facescript.speech.listen.loop import installed
from facescript.speech.model import Spoken
from facescript.speech.sound.recording import Recording, read_recording

TEXTS = {
    "en-us": "The council has voted to close the old harbour bridge. Nobody seems to mind.",
    "de": "Willkommen im Museum, wo jedes Bild eine Geschichte erzählt. Der Zug fährt um halb neun.",
    "fr-fr": "Bienvenue au musée, où chaque tableau raconte une histoire. Le train part de la voie neuf.",
    "es": "Bienvenidos al museo, donde cada cuadro cuenta una historia. El tren sale de la vía nueve.",
    "it": "Il prossimo treno parte dal binario nove, fra dieci minuti. Benvenuti al museo.",
}
MANDARIN = "欢迎来到博物馆，每幅画都讲述一个故事。下一班火车从九号站台开出。"
MANNERS = (
    Voice(variant="f4", rate=0.8, pitch=1.2),
    Voice(variant="m1", rate=1.25, pitch=0.85),
    Voice(rate=1.5),
    Voice(variant="f5", pitch=1.1),
    Voice(variant="m4", rate=0.7, pitch=0.9),
)
"""Other rates, pitches and variants than those that the text is said with."""

MINUTES = 10

SPHINX = "pocketsphinx"

WHO = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)


def rows() -> Iterator[Row]:
    yield from _labelled()
    for language, text in TEXTS.items():
        yield _against_itself(language, text)
    yield _mandarin()
    yield from _long()


def _labelled() -> Iterator[Row]:
    if not FOLDER.exists():
        return
    yield from _against(list(read(FOLDER)), True, 20, 80)
    if installed():
        yield from _against([each for each in read(FOLDER) if each.maker != SPHINX], False, 15, 50)
    else:
        yield Row("phone starts with the extra", "median 15 ms, 90 % in 50 ms", "pocketsphinx is not installed", None)


def _against(recordings: Sequence[Labelled], alone: bool, usual: float, most: float) -> Iterator[Row]:
    """Recordings against their labels, in milliseconds: by the voice `alone`, or with the extra."""
    way = "the voice" if alone else SPHINX
    errors = [list(_errors(each, alone)) for each in recordings]
    for each, found in zip(recordings, errors, strict=True):
        yield Row(f"phone starts by {way}, {each.name}, {len(found)} of {_sounds(each)}", "", _told(found), None)
    found = list(chain(*errors))
    met = np.median(found) <= usual / 1000 and np.percentile(found, 90) <= most / 1000
    what = f"phone starts by {way}, {len(recordings)} recordings, {len(found)} phones"
    yield Row(what, f"median {usual} ms, 90 % in {most} ms", _told(found), bool(met))


def _errors(each: Labelled, alone: bool) -> Iterator[float]:
    """Seconds between the phones of a recording and its labels."""
    line = Say(each.text, Voice())
    times = aligned(read_recording(each.file), line, process_voice(), by_voice_alone=alone).times()
    for i, j in pairs([phone.symbol for phone in times.phones], [symbol for _, symbol in each.labels]):
        yield abs(times.phones[i].start - each.labels[j][0])


def _sounds(each: Labelled) -> int:
    return sum(bool(symbol) for _, symbol in each.labels)


def _told(errors: Sequence[float]) -> str:
    return f"median {1000 * np.median(errors):.1f} ms, 90 % in {1000 * np.percentile(errors, 90):.0f} ms"


def _against_itself(language: str, text: str) -> Row:
    errors: list[float] = []
    for manner in MANNERS:
        spoken = _said(text, language, manner)
        found = aligned(_recording(spoken), Say(text, Voice(language)), process_voice(), by_voice_alone=True)
        ours = [phone for phone in found.phones if phone.symbol]
        truth = [phone for phone in spoken.phones if phone.symbol]
        same = [a.symbol for a in ours] == [b.symbol for b in truth]
        errors += [abs(a.start - b.start) for a, b in zip(ours, truth, strict=True)] if same else [1.0]
    mean = float(np.mean(errors))
    what = f"a voice against itself, {language}, {len(errors)} phone starts"
    return Row(what, "mean 6 ms", f"mean {1000 * mean:.1f} ms, most {1000 * max(errors):.0f}", mean <= 0.006)


def _mandarin() -> Row:
    errors: list[float] = []
    for manner in MANNERS:
        spoken = _said(MANDARIN, "cmn", manner)
        found = aligned(_recording(spoken), Say(MANDARIN, Voice("cmn")), process_voice())
        errors += [abs(a.start - b.start) for a, b in zip(found.words, spoken.words, strict=True)]
    mean = float(np.mean(errors))
    what = f"Mandarin syllable starts, {len(errors)}"
    return Row(what, "mean 6 ms", f"mean {1000 * mean:.1f} ms, most {1000 * max(errors):.0f}", mean <= 0.006)


def _said(text: str, language: str, manner: Voice) -> Spoken:
    return process_voice().speak(Say(text, Voice(language, manner.variant, manner.rate, manner.pitch)))


def _recording(spoken: Spoken) -> Recording:
    return Recording(np.frombuffer(spoken.pcm, "<i2"), spoken.rate)


def _long() -> Iterator[Row]:
    """Ten minutes, in a process of its own, whose memory is told."""
    for alone, bar in ((True, 0.03), (False, 0.1)) if installed() else ((True, 0.03),):
        words = [sys.executable, __file__, *(["alone"] if alone else [])]
        done = subprocess.run(words, capture_output=True, text=True, check=True)
        share, memory = map(float, done.stdout.split())
        what = f"align {MINUTES} minutes by {'the voice' if alone else SPHINX}"
        yield Row(f"{what}, processor time of all processes", f"{bar} of its length", f"{share:.4f}", share <= bar)
        yield Row(f"{what}, memory", "450 MB", f"{memory:.0f} MB", memory <= 450)


def main(alone: bool) -> None:
    """Print what ten minutes take: processor seconds a second, and megabytes of the process that takes most."""
    text = " ".join(TEXTS["en-us"] for _ in range(2 + MINUTES * 60 // 5))
    spoken = _said(text, "en-us", MANNERS[3])
    recording = Recording(np.frombuffer(spoken.pcm, "<i2")[: MINUTES * 60 * spoken.rate], spoken.rate)
    process_voice()._espeak.close()
    before = _seconds()
    aligned(recording, Say(text, Voice()), process_voice(), by_voice_alone=alone)
    process_voice()._espeak.close()
    memory = max(resource.getrusage(who).ru_maxrss for who in WHO) / 1024
    print((_seconds() - before) / recording.duration, memory)


def _seconds() -> float:
    """Processor seconds of this process and of those that it has waited for."""
    used = [resource.getrusage(who) for who in WHO]
    return sum(each.ru_utime + each.ru_stime for each in used)


if __name__ == "__main__":
    main(sys.argv[1:] == ["alone"])
