"""The program flite, where it is installed: words and phones of English sentences at their time."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from saying import over, words_of

from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.flite.engine import FliteEngine
from facescript.speech.flite.program import program
from facescript.speech.model import Spoken, VoiceFailure
from facescript.speech.mouth.visemes import UNKNOWN_CONSONANT, UNKNOWN_VOWEL, visemes

pytestmark = pytest.mark.skipif(program() is None, reason="flite is not installed")

TEXT = "Hello Dr. Smith, it's 21 dogs — isn't it? Papa cut the cake."


def say(text: str, *marks: Stretch, voice: str = "slt", **manner: float) -> Spoken:
    return FliteEngine().speak(Say(text, Voice("en-us", voice, engine="flite", **manner), marks))


def test_words_stand_where_they_are_heard() -> None:
    spoken = say(TEXT)
    assert words_of(spoken) == "Hello Dr Smith it's 21 dogs isn't it Papa cut the cake"
    times = [moment for word in spoken.words for moment in (word.start, word.end)]
    assert times == sorted(times) and times[-1] <= spoken.duration == len(spoken.pcm) / 2 / spoken.rate
    first = {word.text: next(p.symbol for p in spoken.phones if p.start >= word.start - 1e-9) for word in spoken.words}
    assert [first[word] for word in ("Hello", "Smith", "21", "dogs", "Papa", "cake")] == ["h", "s", "t", "d", "p", "k"]


def test_plosives_begin_where_the_sound_rises() -> None:
    spoken = say("Papa took a cup of tea to the big pub.")
    samples = np.frombuffer(spoken.pcm, "<i2").astype(float)
    hop = spoken.rate // 200
    level = 20 * np.log10(np.sqrt((samples[: len(samples) // hop * hop].reshape(-1, hop) ** 2).mean(axis=1)) + 1)
    errors = []
    for phone in spoken.phones:
        if phone.symbol in ("p", "t", "k", "b"):
            at = max(int(phone.start * 200) - 16, 0)
            errors.append(at + 1 + int(np.diff(level[at : at + 32]).argmax()) - phone.start * 200)
    assert abs(float(np.median(errors))) <= 4  # 20 ms


def test_phones_are_known_and_follow_each_other() -> None:
    spoken = say(TEXT)
    assert all(one.end == pytest.approx(two.start) for one, two in pairwise(spoken.phones))
    shapes = [shape for phone in spoken.phones if phone.symbol for shape in visemes(phone.symbol)]
    assert not {UNKNOWN_CONSONANT, UNKNOWN_VOWEL} & set(shapes)


def test_rate_readings_and_pauses_are_followed() -> None:
    plain, fast = say("We were away all year."), say("We were away all year.", rate=1.5)
    assert plain.duration / fast.duration == pytest.approx(1.5, rel=0.1)
    paused = say("We were away.", Stretch("pause", 7, 7, "0.7"))
    assert paused.words[2].start - paused.words[1].end > 0.7
    text = "I say xyzzy now"
    assert say(text, over(text, "xyzzy", "reading", "hello")).pcm == say("I say hello now").pcm


def test_the_same_line_has_the_same_bytes() -> None:
    assert say(TEXT) == say(TEXT)


@pytest.mark.parametrize(
    ("asked", "code", "part"),
    [
        (Say("Hi.", Voice("de", "slt", engine="flite")), "FS501", "flite speaks English, not `de`"),
        (Say("Hi.", Voice("en-gb", "slx", engine="flite")), "FS501", "no voice `slx`; it has `slt`"),
        (Say("Hi.", Voice("en-us", "slt", 9.0, engine="flite")), "FS501", "a rate of 900%"),
        (Say("Hi 长.", Voice("en-us", "slt", engine="flite")), "FS502", "write the reading of `长`"),
        (Say("...", Voice("en-us", "slt", engine="flite")), "FS503", "no letter"),
    ],
)
def test_what_it_cannot_say_is_told(asked: Say, code: str, part: str) -> None:
    with pytest.raises(VoiceFailure, match=part) as failure:
        FliteEngine().speak(asked)
    assert failure.value.code == code


def test_what_it_leaves_out_is_told() -> None:
    (doubt,) = say("A *cup*.".replace("*", ""), Stretch("stress", 2, 5), range=1.5).doubts
    assert (doubt.code, doubt.reason) == ("FS509", "`flite` has no `range` for it and stresses no marked word")
    assert not say("A cup.").doubts
