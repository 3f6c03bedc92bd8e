"""Lines in many languages to sound whose words stand where the text has them."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from saying import line, over, phones_of, words_of

from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.espeak.parts import LEAD, TAIL
from facescript.speech.espeak.voicebox import open_voice, process_voice
from facescript.speech.model import Spoken, VoiceFailure

pytestmark = pytest.mark.usefixtures("synthesiser")

TEXTS = {
    "en-us": "Well, one of the thirty-one dogs didn't cost $1,234.50 & [that] was in 2021!",
    "en-gb": "“Don’t,” she said — the <b> cup is at 10:30… isn't it?",
    "de": "Im Jahr 1998 hatte ich 2.500 Äpfel, z. B. rote.",
    "fr": "Il l'a vu aujourd'hui à l'école. Qu'est-ce que c'est?",
    "es": "¿Dónde está el perro? ¡Aquí!",
    "hi": "मैं तुमसे प्यार करता हूँ।",
    "ru": "Добрый вечер, я потеряла чашку.",
    "ja": "こんばんは、カップをなくしました。",
    "ko": "안녕하세요 저는 학생입니다.",
    "th": "ฉันรักแมวมากครับ",
    "ar": "مساء الخير جميعا.",
    "yue": "我愛你，香港。",
}


def say(text: str, language: str = "en-us", *marks: Stretch, **voice: float) -> Spoken:
    return open_voice().speak(Say(text, Voice(language, **voice), tuple(marks)))


@pytest.mark.parametrize("language", TEXTS)
def test_words_stand_where_the_text_has_them(language: str) -> None:
    text = TEXTS[language]
    spoken = say(text, language)
    assert all(text[word.first : word.last] == word.text for word in spoken.words)
    times = [moment for word in spoken.words for moment in (word.start, word.end)]
    assert times == sorted(times)
    assert all(word.end - word.start > 0.01 for word in spoken.words)
    assert 0 <= times[0] < 0.1
    assert spoken.duration - 0.1 < times[-1] <= spoken.duration
    assert spoken.duration == len(spoken.pcm) / 2 / spoken.rate
    assert spoken.rate == 22_050


@pytest.mark.parametrize("language", TEXTS)
def test_phones_follow_each_other(language: str) -> None:
    phones = say(TEXTS[language], language).phones
    assert all(one.start < one.end == two.start for one, two in pairwise(phones))
    assert not any(sign in phone.symbol for phone in phones for sign in "()ˈˌ")


def test_phones_of_a_line() -> None:
    assert phones_of(say("My *cup*, please.".replace("*", ""))) == "m aɪ k ˈʌ p _ p l ˈiː z _"


def test_every_language_speaks() -> None:
    voice = open_voice()
    for language, _ in process_voice().listed():
        if language in ("en-us", "af", "zu", "sw", "vi", "pt-br", "fr-be", "es-419", "cmn"):
            assert voice.speak(line("Mama 1", language)).words


def test_a_line_is_spoken_once() -> None:
    assert say("Once only.") is say("Once only.")
    assert say("Once only.", volume=0.3) is say("Once only.")
    assert say("Once only.", rate=0.9) is not say("Once only.")


def test_silence_is_as_long_as_it_is_written() -> None:
    text = "One two"
    plain, paused = (say(text, "en-us", Stretch("pause", 3, 3, seconds)) for seconds in ("0.001", "0.7"))
    assert paused.duration - plain.duration == pytest.approx(0.699, abs=1e-4)
    gap = paused.words[1].start - paused.words[0].end
    assert 0.7 <= gap <= 0.7 + LEAD + TAIL + 0.1
    samples = np.frombuffer(paused.pcm, "<i2")
    middle = samples[int((paused.words[0].end + 0.1) * 22_050) :][: int(0.55 * 22_050)]
    assert not middle.any()


def test_a_breath_is_a_short_pause() -> None:
    spoken = say("One two", "en-us", Stretch("breath", 3, 3))
    assert 0.25 <= spoken.words[1].start - spoken.words[0].end <= 0.45


def test_quiet_at_the_ends_is_short() -> None:
    for text in ("Papa", "Shush", "Hello, hello..."):
        spoken = say(text)
        sounding = [phone for phone in spoken.phones if phone.symbol]
        assert sounding[0].start <= LEAD + 1e-3
        assert spoken.duration - sounding[-1].end <= TAIL + 1e-3


def test_stress_lengthens_its_word() -> None:
    text = "I have lost my cup today."
    plain, stressed = say(text), say(text, "en-us", over(text, "cup", "stress"))
    assert words_of(stressed) == words_of(plain)
    lengths = [spoken.words[4].end - spoken.words[4].start for spoken in (plain, stressed)]
    assert lengths[1] > lengths[0]


def test_signs_of_markup_are_text_beside_a_stress() -> None:
    text = "Fish & <b> chips"
    spoken = say(text, "en-us", over(text, "chips", "stress"))
    assert words_of(spoken) == "Fish b chips"
    assert phones_of(spoken).replace("_ ", "").startswith("f ˈɪ ʃ æ n d")


def test_a_reading_in_ipa_is_spoken() -> None:
    text = "I say xyzzy now & then"
    spoken = say(text, "en-us", over(text, "xyzzy", "reading", "/həˈloʊ/"), over(text, "xyzzy", "stress"))
    assert words_of(spoken) == "I say xyzzy now then"
    assert "h ə l ˈoʊ" in phones_of(spoken)


def test_kana_read_a_japanese_word() -> None:
    spoken = say("漢字です。", "ja", Stretch("reading", 0, 2, "かんじ"))
    assert words_of(spoken) == "漢 字 で す"
    assert spoken.phones[0].symbol == "k"


def test_another_spelling_reads_a_word() -> None:
    text = "Meet Siobhan."
    assert "ʃ" in phones_of(say(text, "en-us", over(text, "Siobhan", "reading", "shivawn")))


def test_a_reading_need_not_have_words() -> None:
    assert words_of(say("a [[b]] c")) == "a b c"


def test_rate_and_pitch_are_followed() -> None:
    text = "The council has voted to close the old bridge."
    durations = [say(text, rate=rate).duration for rate in (0.6, 1.0, 1.6)]
    assert durations[0] / durations[1] == pytest.approx(1 / 0.6, rel=0.1)
    assert durations[1] / durations[2] == pytest.approx(1.6, rel=0.1)
    text = "Mama may man. We were away all year."
    low, usual, high = (fundamental(say(text, pitch=pitch)) for pitch in (0.75, 1.0, 1.4))
    assert low / usual == pytest.approx(0.75, rel=0.06)
    assert high / usual == pytest.approx(1.4, rel=0.06)


def fundamental(spoken: Spoken) -> float:
    """The voice's median height in Hz: the shortest lag at which its louder stretches are like themselves."""
    samples = np.frombuffer(spoken.pcm, "<i2").astype(float)
    found = []
    for at in range(0, len(samples) - 1400, 300):
        part = samples[at : at + 1400] - samples[at : at + 1400].mean()
        similar = np.correlate(part, part, "full")[1399:][40:420] / max((part**2).sum(), 1.0)
        peaks = [lag for lag in range(1, 379) if similar[lag] >= max(similar[lag - 1], similar[lag + 1])]
        alike = [lag for lag in peaks if similar[lag] > max(0.6, 0.9 * similar.max())]
        found += alike[:1] if (part**2).mean() > 1e6 else []
    return 22_050 / (40 + float(np.median(found)))


@pytest.mark.parametrize(
    ("asked", "code", "reason"),
    [
        (line("Hi.", "en-uk"), "FS501", "no language `en-uk`; near it are `en-us`, `en-gb`"),
        (line("Hi.", variant="femle"), "FS501", "no variant `femle`; near it are `female"),
        (line("Hi.", rate=0.2), "FS501", "a rate of 20% lies outside what it speaks, 46% to 257%"),
        (Say("Hi.", Voice(pitch=3.0)), "FS501", "a pitch of 300%"),
        (line("?!"), "FS503", "no letter and no number"),
        (line("\u0301", "cmn"), "FS503", "no letter and no number"),
        (line("漢字です。", "ja"), "FS502", "reads kana only"),
        (line("hi", "en-us", Stretch("reading", 0, 2, "/ɧy/")), "FS502", "`ɧ` in `/ɧy/` is no IPA sign"),
        (line("hi", "en-us", Stretch("reading", 0, 2, "/ʎyɣ/")), "FS502", "says only `/ʎ/`"),
    ],
)
def test_what_cannot_be_spoken_is_told(asked: Say, code: str, reason: str) -> None:
    with pytest.raises(VoiceFailure, match=reason.replace("(", r"\(")) as failure:
        open_voice().speak(asked)
    assert failure.value.code == code


def test_variants_sound_different() -> None:
    assert len({say("Hello.", variant=variant).pcm for variant in ("", "female", "male", "whisper")}) == 4  # type: ignore[arg-type]


def test_the_list_of_voices_names_languages_and_variants() -> None:
    listed = dict(process_voice().listed())
    assert listed["en-gb"] == "English (Great Britain)"
    assert listed["female"] == "variant"
    assert len(listed) > 200


FRAGMENTS = (
    "abc XYZ éñß 123 1,2.5 % & < > [[ ]] ] / ' ’ … — 长城 覺 かな カナ 한국어 हिन्दी ไทย عربى русский "
    "\n\x01 😀 ½ ² ١٢ <b> </emphasis> ʃ ǃ 嗯 儿 \u0301 \u202e Ⅻ ２０ 。 ！"
).split(" ")


def spoken_or_refused(asked: Say) -> Spoken | None:
    """None where the text is at fault, and says so."""
    try:
        return open_voice().speak(asked)
    except VoiceFailure as failure:
        if failure.code not in ("FS502", "FS503"):
            raise
        return None


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.sampled_from(FRAGMENTS), min_size=1, max_size=8),
    st.sampled_from(["en-us", "cmn", "ja", "de", "hi", "th", "ko", "ar"]),
    st.data(),
)
def test_any_text_is_spoken_or_refused(fragments: list[str], language: str, data: st.DataObject) -> None:
    text = data.draw(st.sampled_from(["", " "])).join(fragments)
    start = data.draw(st.integers(0, len(text)))
    marks = (Stretch("stress", start, len(text)), Stretch("pause", start, start, "0.2")) if start < len(text) else ()
    spoken = spoken_or_refused(line(text, language, *marks))
    if spoken is None:
        return
    assert spoken.words
    assert all(text[word.first : word.last] == word.text for word in spoken.words)
    moments = [moment for word in spoken.words for moment in (word.start, word.end)]
    assert all(one <= two + 1e-9 for one, two in pairwise([0.0, *moments, spoken.duration]))
    assert all(one.end <= two.start + 1e-9 for one, two in pairwise(spoken.phones))
