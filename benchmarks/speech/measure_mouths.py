"""Measures mouths: lips shut for every p, b and m, and on the teeth for every f and v; the time that a mouth takes.

Lines of many languages are spoken from the slowest rate to the fastest by a face that meanwhile smiles, shows its teeth
or drops its jaw. What is looked at is the performance, after the blending law, and the lips and teeth as drawn.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from os import sysconf
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage

import numpy as np
from numpy.typing import NDArray
from row import Row

from facescript.compile import compile_source
from facescript.ir.acts import Say, Voice
from facescript.motion.mouth import MouthTrack
from facescript.motion.perform import perform
from facescript.performance.channels import INDEX
from facescript.performance.performance import Frames
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.rigs import rig
from facescript.schedule.score import Score, TimedLine
from facescript.speech.espeak.client import Espeak, Utterance
from facescript.speech.espeak.voicebox import EspeakVoice, open_voice
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.visemes import PLAIN
from facescript.text import Source, Span
from facescript.world import World

Floats = NDArray[np.float64]

LINES = {
    "en-us": "The baby bumped my big map of five vivid, verbose, improved vampires.",
    "en-gb": "Perhaps my brave friend above the pub has a very puffy, comfy, obvious beaver.",
    "de": "Mama kauft Äpfel, Pampelmusen und viele Waffeln; der Impfstoff war am Bahnhof.",
    "fr-fr": "Ma femme veut faire beaucoup de bons petits problèmes avec un vieux bébé.",
    "es": "Mi mamá compra papas, un buen vino y fruta fresca en la bodega de Pablo.",
    "it": "La mamma beve un buon vino e il bambino fa i compiti con la febbre.",
    "pt-br": "Minha família bebe um bom vinho e faz bolo de abóbora com pimenta.",
    "ru": "Мама купила в магазине белый плафон, варёную рыбу и вкусный пломбир.",
    "pl": "Mama piecze babkę, a fabryka wyprodukowała wspaniałe wafle i pompy.",
    "cs": "Máma a bába vyprávěly o velmi podivném, fialovém famfrnochovi v Plzni.",
    "tr": "Babam pembe bir vapur ve büyük bir fabrika için fazla para verdi.",
    "fi": "Mummo voi paistaa pullaa, ja vanha pappa pumppaa fabriikin pihalla.",
    "ar": "محمد يفهم بعض المواد في فرنسا ومصر وبيروت.",
    "hi": "मेरी माँ ने बाज़ार में भारी फल और वही पुराना बर्तन फिर बेच दिया।",
    "sw": "Mama wa mbali anapenda kuvaa viatu vipya na kufika mapema mjini Mombasa.",
    "ko": "엄마는 봄에 바다를 보며 빵과 밥을 먹고 편지를 보냅니다.",
    "ja": "まいにち ぱぱは ぼくの ふるい ぼうしを かばんに ふたつ いれて でんぱを みます。",
    "cmn": "爸爸妈妈买苹果，跑步把饭放在北方的飞机旁边，风很猛。",
}
LETTERS = (
    "The quick brown fox jumps over a lazy dog; pack my box with five dozen jugs, pleasure, think, this. bcdfghjklmnpq "
    "rstvwxz. éèüöäßñç šžčřě đ ł ő ğ ı ŵ. кириллица щюбжчцхэ. ελληνικά θχψξ. नमस्ते ध्वनि ज्ञान ष्ण. "
    "你好. こんにちは ふぁ. 안녕하세요. مرحبا خغظض. שלום. ไทย. გამარჯობა. բարեւ. வணக்கம். తెలుగు."
)
"""What each voice makes sounds of."""

TIMED = ("en-us", "de", "es", "it", "ru", "pl", "cmn")
RATES = (46, 60, 80, 100, 130, 160, 200, 257)
FACES = ("woman", "man", "dog")
SHOWN = ("smile 100%", "mouth.jaw 80% + mouth.open 60%", "AU10 80% + AU25 60%", "neutral")

STOPS, NASALS, TEETHED = "pbɓʘ", "m", "fvɱʋ"
SHUT, PARTED = 0.03, 0.02
"""The widest gap (of MNS0) of closed lips (bar L3), and seconds before its burst from which a stop is looked at."""

MOMENTS = 5
"""Moments at which each sound is looked at."""

TOUCHING, SHOWING = 0.4, 1.0
"""px of 720: the widest gap between lips that touch, and the least of the teeth that is seen above the lip."""


@dataclass(slots=True)
class Found:
    """How many sounds were looked at, and where which failed."""

    count: int = 0
    failures: list[str] = field(default_factory=list)

    def add(self, good: bool, place: str) -> None:
        self.count += 1
        if not good:
            self.failures.append(place)

    def told(self) -> str:
        examples = "; ".join(self.failures[:6])
        return f"{self.count} looked at, {len(self.failures)} failed{': ' if examples else ''}{examples}"


def rows() -> Iterator[Row]:
    closed, teethed, drawn = Found(), Found(), Found()
    for number, (language, text) in enumerate(LINES.items()):
        for turn, rate in enumerate(RATES):
            face, shown = FACES[turn % len(FACES)], SHOWN[(number + turn) % len(SHOWN)]
            _look_at(_score(language, text, rate, face, shown), f"{language} {rate}%", closed, teethed, drawn)
    over = f"{len(LINES)} languages, rates {RATES[0]} to {RATES[-1]} %"
    bar = "always"
    yield Row(f"p, b, m: lips shut at the burst ({over})", bar, closed.told(), not closed.failures)
    yield Row(f"f, v: lower lip under the upper teeth ({over})", bar, teethed.told(), not teethed.failures)
    yield Row("the same as drawn: lips touch, teeth on the lip", bar, drawn.told(), not drawn.failures)
    yield _known()
    yield _times()


def _score(language: str, text: str, rate: int, face: str, shown: str) -> Score:
    script = f"face ada = {face}, voice {language}, life still\nada: show {shown} over 0ms\n"
    script += f'ada: say "{text}", rate {rate}%\n'
    compiled = compile_source(Source("mouths.face", script), World(Path()), open_voice())
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    return compiled.score


def _look_at(score: Score, place: str, closed: Found, teethed: Found, drawn: Found) -> None:
    """Every labial of the score's one line, in the performance and as drawn."""
    performance, rigged, line = perform(score), rig(score.faces[0]), score.lines[0]
    looks = [(phone, *span) for phone in line.spoken.phones for span in (_shut(phone), _bitten(phone)) if span]
    times = line.start + np.concatenate([np.linspace(first, last, MOMENTS) for _, _, first, last in looks])
    frames = performance.sample_face("ada", times)
    upper, lower, teeth = _edges(rigged, frames)
    for index, (phone, bitten, *_) in enumerate(looks):
        part = slice(MOMENTS * index, MOMENTS * (index + 1))
        where, gap = f"{place} {phone.symbol} at {phone.start:.3f}", lower[part] - upper[part]
        if bitten:
            teethed.add(_on_teeth(frames[part]), where)
            drawn.add(bool((gap >= SHOWING).all() and (teeth[part] >= lower[part] - TOUCHING).all()), where)
        else:
            closed.add(bool(frames[part, INDEX["mouth.open"]].max() <= SHUT), where)
            drawn.add(bool(gap.max() <= TOUCHING), where)


def _shut(phone: PhoneTime) -> tuple[bool, float, float] | None:
    """When lips are to be shut for a phone: before a burst, all through an m; None where they need not."""
    symbol, start, end = phone.symbol, phone.start, phone.end
    if symbol == "zh:m":
        return False, end - PARTED, end - 0.001
    if symbol[:1] in tuple(STOPS):
        return False, start - PARTED, start - 0.001
    if symbol[:1] in tuple(NASALS):
        return False, min(start + 0.016, (start + end) / 2), max(end - 0.001, (start + end) / 2)
    return None


def _bitten(phone: PhoneTime) -> tuple[bool, float, float] | None:
    """When the lip is to be on the teeth for a phone: about its middle."""
    if phone.symbol == "zh:f" or phone.symbol[:1] in tuple(TEETHED):
        middle, length = (phone.start + phone.end) / 2, phone.end - phone.start
        return True, middle - 0.1 * length, middle + 0.1 * length
    return None


def _on_teeth(frames: Frames) -> bool:
    opened, lower, teeth = (frames[:, INDEX[f"mouth.{name}"]] for name in ("open", "lower", "teeth"))
    return bool((opened <= SHUT).all() and (lower <= -0.1).all() and (teeth >= 0.5).all())


def _edges(rigged: CartoonRig, frames: Frames) -> tuple[Floats, Floats, Floats]:
    """y (px) of the middle of the upper lip's inner edge, of the lower one's, and of the upper teeth's edge."""
    points = rigged.draw(frames).points
    muzzle = bool(rigged.style.mouth.muzzle)
    places = (("mouth-cavity", 2), ("mouth-cavity", 6)) if muzzle else (("mouth-lip-upper", 8), ("mouth-lip-lower", 7))
    upper, lower = (points[:, _loop(rigged, shape)][:, 3 * place, 1] for shape, place in places)
    return upper, lower, points[:, _loop(rigged, "mouth-teeth-upper"), 1].max(axis=1)


def _loop(rigged: CartoonRig, shape: str) -> slice:
    contour = next(one for one in rigged.shapes if one.id == shape).contours[0]
    return slice(contour.first, contour.first + contour.count)


def _known() -> Row:
    """Whether the table has every sound that any voice makes of letters of many scripts."""
    espeak, lacking, seen = Espeak(), set[str](), set[str]()
    voices = [identifier for _, identifier, _ in espeak.voices()["voices"]]
    for identifier in voices:
        for event in espeak.speak(Utterance(LETTERS, identifier)).events:
            if event.kind == "phone" and not event.symbol.startswith("("):
                seen.add(event.symbol)
                lacking |= {f"{sign} ({identifier})" for sign in PLAIN.unknown(event.symbol)}
    told = f"{len(seen)} symbols of {len(voices)} voices, lacking: {', '.join(sorted(lacking)) or 'none'}"
    return Row("sounds that the table of mouth shapes has", "all", told, not lacking)


def _times() -> Row:
    """Processor time of speaking (this process and the voice's) and of the mouth at 60 frames a second."""
    begun = _spent()
    voice, lines, at = EspeakVoice(Espeak()), [], 0.0
    for language in TIMED:
        spoken = voice.speak(Say(" ".join([LINES[language]] * 3), Voice(language)))
        lines.append(TimedLine("ada", at, spoken, 1.0, Span(Source("mouths.face", ""), 0, 0)))
        at += spoken.duration
    said = _spent()
    MouthTrack(tuple(lines)).sample(np.arange(0.0, at, 1 / 60))
    moved = _spent()
    share = (moved - begun) / at
    told = f"{share:.4f} ({(said - begun) / at:.4f} speaking, {(moved - said) / at:.4f} mouths) of {at:.0f} s"
    return Row(f"speaking and mouths, processor time, {len(TIMED)} languages", "0.02 of the sound", told, share <= 0.02)


def _spent() -> float:
    """Seconds of processor time of this process and of the children that it speaks by, s."""
    return time.process_time() + _children()


def _children() -> float:
    """Seconds of processor time of the children that live, and of those that have ended."""
    ended = getrusage(RUSAGE_CHILDREN)
    ticks, listed = 0, Path("/proc/self/task").glob("*/children")
    for child in " ".join(path.read_text() for path in listed).split():
        fields = Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()
        ticks += int(fields[11]) + int(fields[12])
    return ended.ru_utime + ended.ru_stime + ticks / sysconf("SC_CLK_TCK")
