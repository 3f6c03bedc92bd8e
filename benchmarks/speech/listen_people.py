"""People's sound with its phones where the voice does not say them: AN4, and Debian's RHVoice and pico.

PocketSphinx (the extra `english`) finds the phones of the words that were said. AN4 is 948 utterances of 74 people
(Carnegie Mellon University, 1991; free for any purpose): its folder is `AN4`, a checkout of cmusphinx/an4. The other
two are in Debian's non-free: `apt-get install rhvoice rhvoice-english libttspico-utils`. None of these people is among
those that are measured: RHVoice's `slt` and `alan` are flite's slt and awb, and are left out.
"""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from listen_voices import Take

from facescript.speech.listen.loop import RATE, bursting, labelled
from facescript.speech.sound.recording import Recording, read_recording
from facescript.speech.sound.resample import resampled, resampled_length

AN4 = Path(os.environ.get("AN4", "an4"))

RHVOICE, PICO = ("bdl", "clb", "lyubov", "evgeniy-eng"), ("en-US", "en-GB")

FRAMES_A_SECOND = 100

BEAMS = {"beam": 1e-80, "pbeam": 1e-80, "wbeam": 1e-60}


def an4(part: str = "train") -> Iterator[Take]:
    """The utterances of a part, `train` or `test`."""
    names = (AN4 / "etc" / f"an4_{part}.fileids").read_text().split()
    for name, line in zip(names, (AN4 / "etc" / f"an4_{part}.transcription").read_text().splitlines(), strict=True):
        words = re.sub(r"</?s>|\([^)]*\)", "", line).split()
        take = spelt(read_recording(AN4 / "wav" / f"{name}.wav"), words, str(AN4 / "etc" / "an4.dic"))
        if take:
            yield take


def rhvoice(text: str, voice: str, rate: float, pitch: float) -> Take | None:
    """A sentence by RHVoice; rate and pitch are times those of the voice."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "take.wav"
        words = ["RHVoice-test", "-p", voice, "-r", f"{rate:.0%}", "-t", f"{pitch:.0%}", "-o", str(path)]
        subprocess.run([word.rstrip("%") for word in words], input=text, text=True, capture_output=True, check=True)
        return spelt(read_recording(path), spoken(text))


def pico(text: str, language: str, rate: float, pitch: float) -> Take | None:
    """A sentence by pico."""
    said = f'<speed level="{rate:.0%}"><pitch level="{pitch:.0%}">{text}</pitch></speed>'.replace("%", "")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "take.wav"
        subprocess.run(["pico2wave", "-l", language, "-w", str(path), said], capture_output=True, check=True)
        return spelt(read_recording(path), spoken(text))


def spoken(text: str) -> list[str]:
    return re.findall(r"[a-z']+", text.lower())


def spelt(recording: Recording, words: Sequence[str], dictionary: str = "") -> Take | None:
    """The recording with the phones of its words; None where PocketSphinx lacks a word or hears others."""
    decoder = _decoder(dictionary)
    if any(decoder.lookup_word(word) is None for word in words):
        return None
    count = resampled_length(len(recording.samples), recording.rate, RATE)
    rough = resampled(recording.samples, recording.rate, RATE, 0, count)
    sound = np.clip(np.rint(rough), -32_768, 32_767).astype("<i2").tobytes()
    decoder.set_align_text(" ".join(words))
    _listen(decoder, sound)
    if decoder.hyp() is None:
        return None
    decoder.set_alignment()
    _listen(decoder, sound)
    alignment = decoder.get_alignment()
    ends = [(phone.name, (phone.start + phone.duration) / FRAMES_A_SECOND) for word in alignment for phone in word]
    return Take(recording, tuple(bursting(labelled(ends, recording.duration))))


@cache
def _decoder(dictionary: str) -> Any:
    from pocketsphinx import Decoder

    own = {"dict": dictionary} if dictionary else {}
    return Decoder(lm=None, bestpath=False, loglevel="FATAL", **BEAMS, **own)


def _listen(decoder: Any, sound: bytes) -> None:
    decoder.start_utt()
    decoder.process_raw(sound, full_utt=True)
    decoder.end_utt()
