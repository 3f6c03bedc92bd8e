"""A program of its own: reads utterances from its standard input and tells when PocketSphinx hears their sounds.

    a length (4 bytes, big-endian), and that many bytes of JSON:
    [{"bytes": of sound, "words": [[ARPAbet name, ...], ...]}, ...]
    the sounds one after another: 16-bit little-endian mono, 16,000 samples a second

An answer is a line of JSON for each, in order: a list of words, each a list of first frames (10 ms), or null where it
finds no way. It is apart from the compiler because a fault in the library ends its process.
"""

from __future__ import annotations

import json
import sys
from typing import Any


def starts(sound: bytes, words: list[list[str]]) -> list[list[int]] | None:
    """First words are found, then their phones; a decoder of its own, for it keeps what it heard. A word is spelt as
    the synthesiser says it, so that no dictionary is needed and none lacks it."""
    from pocketsphinx import Decoder

    decoder: Any = Decoder(lm=None, dict=None, bestpath=False, beam=1e-80, pbeam=1e-80, wbeam=1e-60, loglevel="FATAL")
    for number, names in enumerate(words):
        decoder.add_word(f"w{number}", " ".join(names), number == len(words) - 1)
    try:
        decoder.set_align_text(" ".join(f"w{number}" for number in range(len(words))))
        listen(decoder, sound)
        if decoder.hyp() is None:
            return None
        decoder.set_alignment()
        listen(decoder, sound)
        alignment = decoder.get_alignment()  # its words are gone with it
        found = [[phone.start for phone in word] for word in alignment if word.name.startswith("w")]
    except (RuntimeError, ValueError):
        return None
    return found if [len(each) for each in found] == [len(names) for names in words] else None


def listen(decoder: Any, sound: bytes) -> None:
    decoder.start_utt()
    decoder.process_raw(sound, full_utt=True)
    decoder.end_utt()


def main() -> None:
    size = int.from_bytes(sys.stdin.buffer.read(4), "big")
    for utterance in json.loads(sys.stdin.buffer.read(size)):
        sound = sys.stdin.buffer.read(utterance["bytes"])
        print(json.dumps(starts(sound, utterance["words"])), flush=True)


if __name__ == "__main__":
    main()
