"""A program of its own: reads lines from its standard input and answers each with piper's sound and its phonemes.

Requests and answers are frames (`voices/frames.py`). A request is

    {"voice": path of an .onnx file, "pieces": [[text, [word, ...]], ...], "slow": times the usual length}

An answer has a part for each sentence, with its sound (16-bit little-endian mono) and how many samples each phoneme
has, and a last part without sound, with what language the voice has and the phonemes of each word spoken alone:

    {"piece": number, "rate": Hz, "sounds": [[phoneme, samples], ...], "more": true}
    {"language": code, "words": [[[phoneme, ...], ...], ...]}
    {"failure": sentence, "code": diagnostic}

piper draws noise, and goes on drawing from one sentence to the next: each line gets a voice that is loaded for it and
seeded, so that it sounds the same every time.
"""

from __future__ import annotations

import json
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from facescript.speech.voices.frames import framed, requests

SEED = 1
BEGIN, END, PAD = "^", "$", "_"

Part = tuple[dict[str, Any], bytes]


def answer(request: dict[str, Any]) -> Iterator[Part]:
    try:
        import onnxruntime
        from piper import PiperVoice, SynthesisConfig
    except ImportError as fault:
        reason = f"piper cannot be loaded ({fault}): `pip install 'piper-tts[alignment]'`"
        yield {"failure": reason, "code": "FS507"}, b""
        return
    onnxruntime.set_default_logger_severity(4)
    onnxruntime.set_seed(SEED)
    try:
        voice = PiperVoice.load(request["voice"], include_alignments=True)
    except Exception as fault:  # onnxruntime has errors of its own for each way in which a file is none
        yield {"failure": f"piper cannot read it: {str(fault)[:200]}"}, b""
        return
    manner = SynthesisConfig(length_scale=voice.config.length_scale * request["slow"])
    for number, (text, _) in enumerate(request["pieces"]):
        for chunk in voice.synthesize(text, manner, include_alignments=True):
            if chunk.phoneme_id_samples is None:
                reason = "this voice tells no times of its phonemes; `pip install 'piper-tts[alignment]'`"
                yield {"failure": reason, "code": "FS507"}, b""
                return
            head = {"piece": number, "rate": chunk.sample_rate, "sounds": sounds(voice.config, chunk), "more": True}
            yield head, chunk.audio_int16_bytes
    apart = [[spelt(voice.phonemize(word)) for word in words] for _, words in request["pieces"]]
    yield {"language": language(request["voice"], voice.config.espeak_voice), "words": apart}, b""


def sounds(config: Any, chunk: Any) -> list[tuple[str, int]]:
    """Each phoneme with its samples and those of the pause that piper puts behind it."""
    found = []
    at = 0
    for phoneme in (BEGIN, *chunk.phonemes, END):
        ids = config.phoneme_id_map.get(phoneme)
        if ids is None:
            continue  # piper leaves out what a voice does not know
        count = len(ids) + (len(config.phoneme_id_map.get(PAD, ())) if phoneme != END else 0)
        found.append((phoneme, int(sum(chunk.phoneme_id_samples[at : at + count]))))
        at += count
    return found


def spelt(sentences: list[list[str]]) -> list[str]:
    return [phoneme for sentence in sentences for phoneme in sentence]


def language(path: str, usual: str) -> str:
    """The code of the voice's language, as its file tells it: `en_US`."""
    told = json.loads(Path(f"{path}.json").read_text("utf-8")).get("language", {})
    return str(told.get("code") or usual)


def main() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what a library prints must not stand among the answers
    for request in requests(sys.stdin.buffer):
        for head, sound in answer(request):
            replies.write(framed(json.dumps(head).encode(), sound))
            replies.flush()


if __name__ == "__main__":
    main()
