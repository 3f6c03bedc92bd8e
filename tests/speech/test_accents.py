"""Accents: where a syllable rises above those around it, in every language and without sound."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from humming import SYLLABLE, hum
from saying import line, over

from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.model import PhoneTime, Spoken
from facescript.speech.sound.accents import Accent, heard

SENTENCE = "Tonight we look at bridges, boats and the people who build them."


def accents(spoken: Spoken) -> tuple[Accent, ...]:
    return heard(spoken).accents


def word_at(spoken: Spoken, time: float) -> str:
    return min(spoken.words, key=lambda word: max(word.start - time, time - word.end, 0.0)).text


def strongest(spoken: Spoken, count: int) -> set[str]:
    """The words with the strongest accents."""
    best = sorted(accents(spoken), key=lambda accent: -accent.strength)[:count]
    return {word_at(spoken, accent.time) for accent in best}


@pytest.mark.parametrize("symbol", ["m", "zh:a"])
def test_sound_alone_makes_accents_of_what_is_higher_or_louder(symbol: str) -> None:
    found = accents(hum(4.0, higher={1.1: 5.0}, louder={2.7: 9.0}, symbol=symbol))
    assert [accent.time for accent in found] == pytest.approx([1.1, 2.7], abs=0.03)


def test_an_accent_is_as_strong_as_it_stands_out() -> None:
    weak, strong, both = (
        accents(hum(3.0, higher={1.5: up}, louder={1.5: more}))[0].strength
        for up, more in ((3.0, 0.0), (6.0, 0.0), (6.0, 9.0))
    )
    assert 0.0 < weak < strong < both < 1.0


def test_a_slow_rise_is_no_accent() -> None:
    assert accents(hum(4.0, higher={at: at for at in np.arange(0.0, 4.0, 0.1)})) == ()


def test_stress_helps_and_does_not_suffice() -> None:
    plain, stressed = (accents(hum(3.0, higher={1.5: 3.0, 2.3: 1.5}, stressed=flags)) for flags in ((), (7, 11)))
    assert len(plain) == 1 and [round(accent.time, 1) for accent in stressed] == [1.5, 2.3]
    assert stressed[0].strength > max(plain[0].strength, stressed[1].strength)
    assert all(accent.strength < 0.1 for accent in accents(hum(3.0, stressed=(3, 9))))


def test_a_syllable_has_one_accent() -> None:
    spoken = hum(2.0, higher={1.0: 6.0})
    halves = tuple(
        PhoneTime("m", start, start + SYLLABLE / 4.0) for start in np.arange(0.0, 2.0, SYLLABLE / 4.0).tolist()
    )
    assert len(accents(replace(spoken, phones=halves))) == 1


def test_without_sound_the_stress_says_where_accents_are() -> None:
    phones = (PhoneTime("a", 0.0, 0.2, True), PhoneTime("t", 0.2, 0.3), PhoneTime("", 0.3, 0.5))
    assert accents(Spoken(b"", 22_050, 0.5, (), phones)) == (Accent(0.1, 0.5),)
    assert accents(Spoken(b"", 22_050, 0.5, (), phones[1:])) == ()


def test_silence_has_no_accents() -> None:
    assert accents(replace(hum(1.0), sound=bytes(44_100))) == ()
    assert accents(replace(hum(1.0, higher={0.5: 6.0}), words=(), phones=(PhoneTime("", 0.0, 1.0),))) == ()


def test_where_no_phones_are_known_the_ear_finds_accents() -> None:
    sound = hum(2.0, higher={0.5: 6.0, 1.5: 6.0})
    for spoken in (replace(sound, phones=(), words=()), replace(sound, phones=(PhoneTime("", 0.0, 2.0),))):
        assert [round(each.time, 1) for each in accents(spoken)] == [0.5, 1.5]


def test_a_line_is_listened_to_once_and_forgotten_with_it() -> None:
    spoken = hum(1.0, higher={0.5: 6.0})
    assert heard(spoken) is heard(replace(spoken))
    other = replace(spoken, phones=spoken.phones[:2])
    assert heard(other).accents != heard(spoken).accents


# ------------------------------------------------------------------------------------------------ voices


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize("variant", ["", "female"])
def test_content_words_are_accented_and_function_words_are_not(variant: str) -> None:
    spoken = open_voice().speak(line(SENTENCE, variant=variant))
    assert strongest(spoken, 4) == {"Tonight", "bridges", "boats", "build"}
    assert not {word_at(spoken, accent.time) for accent in accents(spoken) if accent.strength > 0.3} & {"at", "the"}
    assert all(0.0 <= accent.strength < 1.0 for accent in accents(spoken))


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize(("word", "language"), [("my", "en-us"), ("cup", "en-us"), ("in", "en-gb")])
def test_the_stress_of_the_author_counts(word: str, language: str) -> None:
    text = "I have lost my cup in the garden."
    plain, marked = (open_voice().speak(line(text, language, *marks)) for marks in ((), (over(text, word, "stress"),)))

    def strength(spoken: Spoken) -> float:
        return max((each.strength for each in accents(spoken) if word_at(spoken, each.time) == word), default=0.0)

    assert strength(marked) > strength(plain)
    assert word in strongest(marked, 3)


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("小明在长城脚下长大。", "cmn"),
        ("Bonjour à tous mes amis de Paris.", "fr"),
        ("こんにちは、おげんきですか", "ja"),
        ("สวัสดีครับ", "th"),
        ("He perdido mi taza en el jardín.", "es"),
    ],
)
def test_every_language_has_accents(text: str, language: str) -> None:
    spoken = open_voice().speak(line(text, language))
    found = accents(spoken)
    assert 2 <= len(found) <= spoken.duration / 0.2
    assert [accent.time for accent in found] == sorted(accent.time for accent in found)
    assert max(accent.strength for accent in found) > 0.1
