"""Sentences to sound with the phones that the voice says it spoke: espeak-ng; Debian's flite, festival, MBROLA."""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from facescript.ir.acts import Voice
from facescript.speech.espeak.client import Espeak, Utterance
from facescript.speech.espeak.manner import Voices, voices
from facescript.speech.espeak.parts import phones
from facescript.speech.listen.loop import bursting, labelled
from facescript.speech.model import PhoneTime
from facescript.speech.sound.recording import Recording, read_recording

IPA = {"o-": "ɤ", "s.": "ʂ", "ts.": "tʂ", "ts.h": "tʂh", "onɡ": "oŋ", "ᵻ": "ɪ"}
"""espeak-ng's own names that come for IPA in its events, and the IPA that they mean."""

RUSSIAN = {"y": "ɨ"}


@dataclass(frozen=True, slots=True)
class Take:
    """A spoken sentence and its phones."""

    recording: Recording
    phones: tuple[PhoneTime, ...]


@cache
def _espeak() -> tuple[Espeak, Voices]:
    program = Espeak()
    return program, voices(program.voices())


def espeak(text: str, language: str, variant: str = "", rate: float = 1.0, pitch: float = 1.0) -> Take:
    """A sentence by espeak-ng, with the phonemes of its events, in IPA; Mandarin is read by pypinyin."""
    import numpy as np

    program, known = _espeak()
    manner = known.manner(Voice(language, variant, rate, pitch))
    sent = _pinyin(text) if language == "cmn" else text
    sound = program.speak(Utterance(sent, manner.voice, manner.rate, manner.pitch))
    names = IPA | (RUSSIAN if language == "ru" else {})
    named = (replace(phone, symbol=names.get(phone.symbol, phone.symbol)) for phone in phones(sound))
    return Take(Recording(np.frombuffer(sound.pcm, dtype="<i2"), sound.rate), tuple(named))


def _pinyin(text: str) -> str:
    from pypinyin import Style, lazy_pinyin

    read = lazy_pinyin(text, Style.TONE3, v_to_u=False, neutral_tone_with_five=True, tone_sandhi=True)
    return " ".join(sign.translate({0xFF0C: ",", 0x3002: ".", 0xFF1F: "?"}) for sign in read)


def flite(text: str, voice: str) -> Take:
    """A sentence by flite, with the segments that it prints."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "take.wav"
        words = ["flite", "-voice", voice, "-psdur", "-t", text, "-o", str(path)]
        printed = subprocess.run(words, capture_output=True, text=True, check=True, env={**os.environ, "LC_ALL": "C"})
        recording = read_recording(path)
    segments = [(name, float(end)) for name, end in re.findall(r"([a-z]+):(\d+\.\d+)", printed.stdout)]
    return Take(recording, tuple(bursting(labelled(segments, recording.duration))))


FESTIVAL = {
    "ked_diphone": ("en-us", "utf-8"),
    "lp_diphone": ("it", "latin-1"),
    "pc_diphone": ("it", "latin-1"),
    "suo_fi_lj_diphone": ("fi", "latin-1"),
    "hy_fi_mv_diphone": ("fi", "latin-1"),
    "czech_dita": ("cs", "iso-8859-2"),
    "czech_krb": ("cs", "iso-8859-2"),
    "czech_machac": ("cs", "iso-8859-2"),
    "czech_ph": ("cs", "iso-8859-2"),
    "upc_ca_ona_hts": ("ca", "latin-1"),
    "msu_ru_nsh_clunits": ("ru", "utf-8"),
    "hindi_NSK_diphone": ("hi", "utf-8"),
}
"""Voices of festival, each made of a person's recordings: their language, and how their text is written."""

_ROMANCE = "a1:a e1:e i1:i o1:o u1:u E:ɛ E1:ɛ O:ɔ O1:ɔ ax:ə S:ʃ Z:ʒ g:ɡ J:ɲ L:ʎ tS:tʃ dZ:dʒ ng:ŋ nf:ɱ rr:r"

NAMED = {
    "it": _ROMANCE,
    "ca": _ROMANCE,
    "fi": "y:y &:æ 7:ø @:ə g:ɡ S:ʃ N:ŋ v:ʋ",
    "cs": "c:ts c~:tʃ ch:x d~:ɟ dz~:dʒ g:ɡ h:ɦ n*:ŋ n~:ɲ r~:r̝ r~*:r̝ s~:ʃ t~:c z~:ʒ",
    "ru": "ii:i yy:ɨ uu:u ee:e oo:o aa:a y:ɨ ae:æ ay:ə ur:u pp:p bb:b tt:t dd:d kk:k g:ɡ gg:ɡ c:ts ch:tɕ ff:f vv:v "
    "ss:s zz:z sh:ʂ sch:ɕ zh:ʐ h:x hh:x mm:m nn:n ll:l rr:r",
    "hi": "aa:a a:ə ih:ɪ iy:i uh:ʊ uw:u eh:e ee:e ay:ɛ oh:o oo:o aw:ɔ g:ɡ ch:tʃ T:ʈ D:ɖ N:ɳ th:t dh:d y:j v:ʋ L:ɭ R:ɽ "
    "sh:ʃ j:dʒ kh:k gh:ɡ td:t tth:ʈ ddh:ɖ bh:b zh:ʒ ksh:kʂ",
}
"""festival's names of phones that are not their IPA, by language; English has CMU's."""

SILENT = ("pau", "#", "##", "_", "SIL", "@", "sri", "x")


def festival(texts: Sequence[str], voice: str, paces: Sequence[float]) -> list[Take]:
    """Sentences by a voice of festival, each its pace times as long, with the segments that they were made of."""
    language, coding = FESTIVAL[voice]
    with tempfile.TemporaryDirectory() as folder:
        script = [f"(voice_{voice})"]
        for place, (text, pace) in enumerate(zip(texts, paces, strict=True)):
            said = text.replace('"', "").replace("·", "")
            script.append(f"(Parameter.set 'Duration_Stretch {pace})")
            script.append(f'(set! said (utt.synth (Utterance Text "{said}")))')
            script.append(f'(utt.save.wave said "{folder}/{place}.wav") (utt.save.segs said "{folder}/{place}.seg")')
        (Path(folder) / "say.scm").write_bytes("\n".join(script).encode(coding, "replace"))
        subprocess.run(["festival", "-b", f"{folder}/say.scm"], capture_output=True, check=True)
        return [_made(language, Path(folder) / str(place)) for place in range(len(texts))]


def _made(language: str, name: Path) -> Take:
    rows = [line.split() for line in name.with_suffix(".seg").read_text("latin-1").splitlines()[1:]]
    segments = [(row[2], float(row[0])) for row in rows]
    recording = read_recording(name.with_suffix(".wav"))
    named = labelled(segments, recording.duration) if language == "en-us" else _named(language, segments)
    return Take(recording, tuple(bursting(named)))


def _named(language: str, segments: list[tuple[str, float]]) -> list[PhoneTime]:
    names = dict(pair.rsplit(":", 1) for pair in NAMED[language].split())
    found: list[PhoneTime] = []
    for name, end in segments:
        start = found[-1].end if found else 0.0
        symbol = "" if name in SILENT else names.get(name.rstrip(":"), name.rstrip(":"))
        found.append(PhoneTime(symbol, start, end))
    return found


MBROLA = {
    "us1": "en-us",
    "us2": "en-us",
    "us3": "en-us",
    "en1": "en-gb",
    "de2-en": "de",
    "de5-en": "de",
    "fr4-en": "fr",
    "nl2-en": "nl",
    "sw2-en": "sv",
    "hu1-en": "hu",
}
"""espeak-ng's voices of MBROLA that read English, and the language of the person whose sounds they are."""

_SAMPA = (
    "p_h p  t_h t  k_h k  ph p  th t  kh k  4 ɾ  5 l  l= l  N ŋ  S ʃ  Z ʒ  T θ  D ð  tS tʃ  dZ dʒ  tj tʃ  dj dʒ  "
    "R ʁ  J ɲ  L ʎ  g ɡ  r ɹ  r= ɝ  @ ə  I ɪ  U ʊ  V ʌ  E ɛ  E: ɛ  { æ  A ɑ  A: ɑ  O ɔ  O: ɔ  O2 ɔ  Q ɒ  3: ɜ  6 ɐ  "
    "2 ø  2: ø  9 œ  u0 ʉ  EI eɪ  eI eɪ  AI aɪ  aI aɪ  OI ɔɪ  OY ɔʏ  @U oʊ  aU aʊ  Ei ɛɪ  Au ʌʊ  I@ ɪə  e@ ɛə  U@ ʊə"
).split()

SAMPA = dict(zip(_SAMPA[::2], _SAMPA[1::2], strict=True)) | {"_": ""}
"""MBROLA's names of phones that are not their IPA; a long vowel that is not among them is its short one."""


def mbrola(text: str, voice: str, rate: float, pitch: float) -> Take:
    """A sentence by a voice of MBROLA, with the phones that espeak-ng has it say; rate and pitch are times its own."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "take.wav"
        words = ["espeak-ng", "-v", f"mb-{voice}", "--pho", "-q", text]
        told = subprocess.run(words, capture_output=True, text=True, check=True).stdout
        person = voice.split("-")[0]
        factors = ["-t", f"{1.0 / rate:.3f}", "-f", f"{pitch:.3f}"]
        words = ["mbrola", "-e", *factors, f"/usr/share/mbrola/{person}/{person}", "-", str(path)]
        subprocess.run(words, input=told, capture_output=True, text=True, check=True)
        recording = read_recording(path)
    found: list[PhoneTime] = []
    for name, length in re.findall(r"^(\S+)\t(\d+)", told, re.MULTILINE):
        start = found[-1].end if found else 0.0
        found.append(PhoneTime(SAMPA.get(name, name.rstrip(":")), start, start + float(length) / (1000.0 * rate)))
    return Take(recording, tuple(bursting(found)))
