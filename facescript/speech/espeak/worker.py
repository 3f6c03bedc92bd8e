# SPDX-License-Identifier: GPL-3.0-or-later
"""A program of its own: reads texts from its standard input and answers each with espeak-ng's sound and events.

A frame is a length (4 bytes, big-endian) and that many bytes. A request is one frame of JSON:

    {"do": "voices"}
    {"do": "speak", "text": ..., "voice": ..., "rate": words a minute, "pitch": 0..100, "range": 0..100,
     "ssml": bool, "phonemes": bool}

An answer is a frame of JSON and a frame of sound (16-bit little-endian mono, empty for voices); for a text, a pair for
each stretch of sound, all but the last with `more`. Samples count from the start of the text.

    {"voices": [[name, identifier, [[priority, language], ...]], ...], "variants": [[name, identifier, gender], ...]}
    {"rate": Hz, "events": [["word"|"phone", sample, character from 0, IPA], ...], "more": bool}
    {"failure": sentence}

espeak-ng seeds the noise in its voice with the time and carries it from one utterance into the next, so the seed is set
and each utterance gets a library that has not spoken: a fork of this process where there is fork, else the library is
loaded again. A watchdog ends an utterance that hangs. The program ends with its standard input, and where an utterance
breaks off: who asked starts it again.
"""

from __future__ import annotations

import _ctypes
import ctypes
import faulthandler
import json
import os
import signal
import struct
import sys
from collections.abc import Callable, Iterator
from typing import IO, Any

SYNCHRONOUS = 2
"""Output mode: mode 1 starts a thread, and a fork after it hangs."""

PHONEME_EVENTS, PHONEMES_AS_IPA = 1, 2
RATE, VOLUME, PITCH, RANGE = 1, 2, 3, 4
BY_CHARACTER, UTF8, SSML, PHONEMES = 1, 0x1, 0x10, 0x100
ENDED, WORD, PHONE = 0, 1, 7
LONGEST_REQUEST = 1 << 22
SEED = 1
"""Of the breath in the voice: espeak-ng seeds itself with the time of day."""

SECONDS = 30.0
"""An utterance that takes longer is broken off: later than who asked has given up and ended this program."""

STRETCH = 88_200
"""Bytes of sound, two seconds, that are sent at once: at first whatever there is, then as much as was sent before."""

Answer = tuple[dict[str, Any], bytes]
Reply = Callable[[bytes], Any]
"""Takes what is sent: whole pairs of frames."""


class Event(ctypes.Structure):
    """espeak_EVENT; `id` holds eight bytes of UTF-8 for a phoneme, possibly cut."""

    _fields_ = (
        ("type", ctypes.c_int),
        ("unique_identifier", ctypes.c_uint),
        ("text_position", ctypes.c_int),
        ("length", ctypes.c_int),
        ("audio_position", ctypes.c_int),
        ("sample", ctypes.c_int),
        ("user_data", ctypes.c_void_p),
        ("id", ctypes.c_char * 8),
    )


class Voice(ctypes.Structure):
    """espeak_VOICE."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("languages", ctypes.c_void_p),
        ("identifier", ctypes.c_char_p),
        ("gender", ctypes.c_ubyte),
        ("age", ctypes.c_ubyte),
        ("variant", ctypes.c_ubyte),
        ("reserved", ctypes.c_ubyte),
        ("score", ctypes.c_int),
        ("spare", ctypes.c_void_p),
    )


CALLBACK = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_short), ctypes.c_int, ctypes.POINTER(Event))


class Espeak:
    """The library, loaded and initialised, and what it has said so far."""

    def __init__(self) -> None:
        import espeakng_loader  # where it is missing, requests must still be answered

        self.library = ctypes.CDLL(espeakng_loader.get_library_path())
        data = os.fsencode(espeakng_loader.get_data_path())
        self.rate = self.library.espeak_Initialize(SYNCHRONOUS, 0, data, PHONEME_EVENTS | PHONEMES_AS_IPA)
        if self.rate <= 0:
            raise OSError("espeak-ng cannot read its data")
        self.library.espeak_ng_SetRandSeed(ctypes.c_long(SEED))
        self.reply: Reply = bytes
        self.sent = 0
        self.sound = bytearray()
        self.events: list[tuple[str, int, int, str]] = []
        self.callback = CALLBACK(self.heard)
        self.library.espeak_SetSynthCallback(self.callback)
        self.library.espeak_ListVoices.restype = ctypes.POINTER(ctypes.POINTER(Voice))

    def heard(self, samples: Any, count: int, events: Any) -> int:
        """Called by the library with each stretch of sound and its events."""
        if samples and count > 0:
            self.sound += ctypes.string_at(samples, 2 * count)
        index = 0
        while events[index].type != ENDED:
            event = events[index]
            place = max(event.text_position - 1, 0)
            if event.type == WORD:
                self.events.append(("word", event.sample, place, ""))
            elif event.type == PHONE:
                self.events.append(("phone", event.sample, place, event.id.decode("utf-8", "ignore")))
            index += 1
        if self.sound and len(self.sound) >= min(self.sent, STRETCH):
            self.send(more=True)
        return 0

    def send(self, more: bool) -> None:
        """Send the sound and the events since the last time."""
        self.reply(packed(({"rate": self.rate, "events": self.events, "more": more}, bytes(self.sound))))
        self.sent += len(self.sound)
        self.sound.clear()
        self.events.clear()

    def speak(self, request: dict[str, Any]) -> Answer:
        if self.library.espeak_SetVoiceByName(request["voice"].encode()) != 0:
            return {"failure": f"espeak-ng has no voice {request['voice']}"}, b""
        manner = ((RATE, request["rate"]), (PITCH, request["pitch"]), (RANGE, request["range"]), (VOLUME, 100))
        for parameter, value in manner:
            self.library.espeak_SetParameter(parameter, int(value), 0)
        text = request["text"].encode() + b"\0"
        flags = UTF8 | (SSML if request["ssml"] else 0) | (PHONEMES if request["phonemes"] else 0)
        size = ctypes.c_size_t(len(text))
        if self.library.espeak_Synth(text, size, 0, BY_CHARACTER, 0, flags, None, None) != 0:
            return {"failure": "espeak-ng cannot speak this text"}, b""
        self.library.espeak_Synchronize()
        return {"rate": self.rate, "events": self.events}, bytes(self.sound)

    def voices(self) -> Answer:
        wanted = ctypes.create_string_buffer(b"variant")
        variant = Voice(languages=ctypes.cast(wanted, ctypes.c_void_p))
        speaking = [(v.name.decode(), v.identifier.decode(), languages(v.languages)) for v in self.listed(None)]
        variants = [(v.name.decode(), v.identifier.decode(), v.gender) for v in self.listed(ctypes.byref(variant))]
        return {"voices": sorted(speaking), "variants": sorted(variants)}, b""

    def listed(self, like: Any) -> list[Voice]:
        found = self.library.espeak_ListVoices(like)
        voices: list[Voice] = []
        while found[len(voices)]:
            voices.append(found[len(voices)].contents)
        return voices

    def answer(self, request: dict[str, Any]) -> Answer:
        return self.voices() if request["do"] == "voices" else self.speak(request)

    def close(self) -> None:
        self.library.espeak_Terminate()
        release = getattr(_ctypes, "FreeLibrary", None) or _ctypes.dlclose
        release(self.library._handle)


def languages(place: int) -> list[tuple[int, str]]:
    """Priority and code of each language at `place`: a byte and a string, again and again, up to a zero."""
    found = []
    while text := ctypes.string_at(place):
        found.append((text[0], text[1:].decode()))
        place += len(text) + 1
    return found


def packed(answer: Answer) -> bytes:
    head = json.dumps(answer[0]).encode()
    return struct.pack(">I", len(head)) + head + struct.pack(">I", len(answer[1])) + answer[1]


def watched(espeak: Espeak, request: dict[str, Any], reply: Reply) -> None:
    """Send the answer to a request; a hang ends the process."""
    with open(os.devnull, "w") as nowhere:
        faulthandler.dump_traceback_later(SECONDS, exit=True, file=nowhere)
        espeak.reply = reply
        reply(packed(espeak.answer(request)))
        faulthandler.cancel_dump_traceback_later()


def forked(espeak: Espeak, request: dict[str, Any], reply: Reply) -> None:
    """Send the answer from a copy of this process that has never spoken."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            watched(espeak, request, reply)
            status = 0
        finally:
            os._exit(status)
    if os.waitpid(child, 0)[1] != 0:
        sys.exit(1)


def reloaded(request: dict[str, Any], reply: Reply) -> None:
    """Send the answer from a library loaded for it."""
    espeak = Espeak()
    watched(espeak, request, reply)
    espeak.close()


def opened() -> Callable[[dict[str, Any], Reply], Any]:
    """What answers requests; where the library cannot be loaded, it says so."""
    try:
        espeak = Espeak()
    except (ImportError, OSError) as fault:
        sorry = packed(({"failure": f"espeak-ng cannot be loaded: {fault}"}, b""))
        return lambda request, reply: reply(sorry)
    if hasattr(os, "fork"):
        return lambda request, reply: forked(espeak, request, reply)
    espeak.close()
    return reloaded


def requests(stream: IO[bytes]) -> Iterator[dict[str, Any]]:
    """The requests of a stream, to its end."""
    while len(head := stream.read(4)) == 4:
        size = struct.unpack(">I", head)[0]
        if size > LONGEST_REQUEST or len(body := stream.read(size)) < size:
            return
        yield json.loads(body)


def main() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    replies = os.fdopen(os.dup(1), "wb", buffering=0)
    os.dup2(nowhere, 1)  # what the library prints must not stand among the answers
    answered = opened()
    for request in requests(sys.stdin.buffer):
        answered(request, lambda pair: write(replies, pair))


def write(replies: IO[bytes], pair: bytes) -> None:
    """Write all of it: without a buffer, a pipe may take a part at a time."""
    rest = memoryview(pair)
    while rest:
        rest = rest[replies.write(rest) :]


if __name__ == "__main__":
    main()
