"""Estimated times: near the voice's, without a voice, and with the faults that the text alone shows."""

from __future__ import annotations

import statistics
import subprocess
import sys

import pytest
from saying import line, over, words_of

from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import VoiceFailure

FRESH = (
    ("en-us", "Welcome to the museum, where every picture tells a story."),
    ("en-gb", "The next train to Cambridge leaves from platform nine."),
    ("en-us", "It has been raining since Tuesday. Nobody seems to mind."),
    ("de", "Willkommen im Museum, wo jedes Bild eine Geschichte erzählt."),
    ("de", "Der nächste Zug fährt um halb neun von Gleis drei."),
    ("fr", "Bienvenue au musée, où chaque tableau raconte une histoire."),
    ("fr", "Le prochain train part de la voie neuf."),
    ("es", "Bienvenidos al museo, donde cada cuadro cuenta una historia."),
    ("es", "El próximo tren sale de la vía nueve."),
    ("cmn", "欢迎来到博物馆，每幅画都讲述一个故事。"),
    ("cmn", "下一班火车从九号站台开出。"),
    ("it", "Il prossimo treno parte dal binario nove."),
    ("ja", "つぎのでんしゃはきゅうばんせんからでます。"),
)
"""Sentences that were not used to find the lengths of letters."""


@pytest.mark.usefixtures("synthesiser")
def test_estimates_are_near_the_voice() -> None:
    errors = []
    for language, text in FRESH:
        asked = line(text, language)
        estimated, spoken = EstimatedVoice().speak(asked), open_voice().speak(asked)
        errors.append(abs(estimated.duration / spoken.duration - 1))
        assert [(word.first, word.last) for word in estimated.words] == [(w.first, w.last) for w in spoken.words]
    assert statistics.median(errors) < 0.1
    assert max(errors) < 0.25


@pytest.mark.usefixtures("synthesiser")
@pytest.mark.parametrize("rate", [0.6, 1.6])
def test_estimates_follow_the_rate(rate: float) -> None:
    asked = line("The council has voted to close the old harbour bridge.", rate=rate)
    assert EstimatedVoice().speak(asked).duration == pytest.approx(open_voice().speak(asked).duration, rel=0.15)


def test_an_estimate_has_words_and_no_sound() -> None:
    text = "Well, I *never*... said [it]!".replace("*", "")
    spoken = EstimatedVoice().speak(line(text, "en-us", Stretch("pause", 5, 5, "2")))
    assert spoken.estimated
    assert not spoken.pcm
    assert words_of(spoken) == "Well I never said it"
    assert all(text[word.first : word.last] == word.text for word in spoken.words)
    moments = [moment for word in spoken.words for moment in (word.start, word.end)]
    assert moments == sorted(moments)
    assert spoken.words[1].start - spoken.words[0].end > 2
    assert spoken.duration > moments[-1]


def test_nothing_heavy_is_loaded() -> None:
    program = (
        "import sys; from facescript.speech.estimate import EstimatedVoice; from facescript.ir.acts import *;"
        "EstimatedVoice().speak(Say('长城', Voice('cmn'), (Stretch('reading', 0, 1, 'chang2'),)));"
        "print(sorted({'numpy', 'pypinyin', 'espeakng_loader', 'pydantic'} & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout == "[]\n"


@pytest.mark.parametrize(
    ("asked", "code"),
    [
        (line("..."), "FS503"),
        (line("长大", "cmn", Stretch("reading", 0, 1, "zhang")), "FS502"),
        (line("hi", "en-us", Stretch("reading", 0, 2, "/ɧ/")), "FS502"),
        (line("hi", "en-us", over("hi", "hi", "reading", "?")), "FS502"),
        (line("hi", rate=9.0), "FS501"),
        (Say("hi", Voice(pitch=0.1)), "FS501"),
    ],
)
def test_faults_of_the_text_are_found_without_a_voice(asked: Say, code: str) -> None:
    with pytest.raises(VoiceFailure) as failure:
        EstimatedVoice().speak(asked)
    assert failure.value.code == code
