"""A program of its own: reads sound from its standard input and tells what phrases it hears, a line of JSON each.

    a length (4 bytes, big-endian) and that many bytes of JSON: {"phrases": [text, ...], "least": the confidence that is
    told}
    then stretches: a length and that many bytes of sound, 16-bit little-endian mono, 16,000 samples a second; a length
    with its highest bit set is that many samples that are passed over

It is apart because a fault in the recogniser's library ends its process, and so that listening takes nothing from the
frames. It ends with its input, and tells how much it heard.
"""

from __future__ import annotations

import json
import signal
import sys
from dataclasses import asdict
from functools import partial

import numpy as np

from facescript.live.hearing.ear import DEAF, Ear
from facescript.live.hearing.phrases import phrases, sounds_of
from facescript.live.hearing.sphinx import Sphinx
from facescript.speech.espeak.voicebox import open_voice


def main() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    source = sys.stdin.buffer
    head = json.loads(source.read(int.from_bytes(source.read(4), "big")))
    ear = Ear(Sphinx(phrases(head["phrases"]), partial(sounds_of, voice=open_voice())), head["least"])
    _tell(ready=True)
    while len(size := source.read(4)) == 4:
        count = int.from_bytes(size, "big")
        if count & DEAF:
            ear.deaf(count & ~DEAF)
            continue
        for heard in ear.listen(np.frombuffer(source.read(count), "<i2")):
            _tell(heard=asdict(heard))
    _tell(counts=ear.counts)


def _tell(**message: object) -> None:
    print(json.dumps(message), flush=True)


if __name__ == "__main__":
    main()
