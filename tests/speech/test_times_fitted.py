"""A line at the times of a file: its words where the file has them, however it spells them, and a mouth that moves."""

from __future__ import annotations

import json
import wave
from pathlib import Path
from random import Random
from time import process_time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from saying import line

from facescript.compile import compile_source
from facescript.ir.acts import Say
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import PhoneTime
from facescript.speech.studio import open_studio
from facescript.speech.timing.fitting import fitted
from facescript.speech.timing.matching import matches
from facescript.speech.timing.times import TimedWord, Times, times_of
from facescript.text import Source
from facescript.world import World


def each(text: str, length: float = 0.5) -> Times:
    """Words of half a second, one after another."""
    return times_of(TimedWord(word, at * length, (at + 1) * length) for at, word in enumerate(text.split()))


def starts(said: str, times: Times, language: str = "en-us") -> list[tuple[str, float]]:
    return [(word.text, round(word.start, 2)) for word in fitted(times, line(said, language)).words]


def doubts(said: str, times: Times) -> list[str]:
    return [doubt.reason for doubt in fitted(times, line(said)).doubts]


def test_case_punctuation_and_small_differences_do_not_matter() -> None:
    times = each("well the COLOR, isn't gray")
    assert starts("Well: the colour isn’t grey!", times) == [
        ("Well", 0), ("the", 0.5), ("colour", 1), ("isn’t", 1.5), ("grey", 2),
    ]  # fmt: skip
    assert doubts("Well: the colour isn’t grey!", times) == []


def test_numbers_take_the_time_of_their_words() -> None:
    times = each("in nineteen eighty four it began")
    assert starts("In 1984 it began", times) == [("In", 0), ("1984", 0.5), ("it", 2), ("began", 2.5)]
    assert doubts("In 1984 it began", times) == []


def test_one_word_of_the_file_may_be_several_characters() -> None:
    assert [text for text, _ in starts("你好世界", each("你好 世界"), "cmn")] == list("你好世界")
    assert starts("你好世界", each("你好 世界"), "cmn")[2] == ("世", 0.5)


def test_missing_words_stand_between_their_neighbours_and_are_told() -> None:
    times = times_of([TimedWord("good", 0, 0.4), TimedWord("everyone", 1.4, 2)])
    assert [text for text, _ in starts("good evening everyone", times)] == ["good", "evening", "everyone"]
    found = fitted(times, line("good evening everyone")).words[1]
    assert found.start == pytest.approx(0.4) and found.end <= 1.4
    assert doubts("good evening everyone", times) == ["it does not have `evening`"]
    assert doubts("good", times) == ["it has `everyone` at 1.40 s, which the line lacks"]


def test_another_text_is_told_and_spread_over_the_time() -> None:
    times = each("completely different content here")
    assert doubts("my lost cup", times) == ["none of the line's 3 words is in it"]
    assert starts("my lost cup", times)[0] == ("my", 0)


@settings(max_examples=30, deadline=None)
@given(
    said=st.lists(st.sampled_from(["a", "b", "cup", "cups", "7", "世"]), min_size=1, max_size=9),
    held=st.lists(st.sampled_from(["a", "b", "cup", "seven", "界", ""]), min_size=1, max_size=9),
)
def test_words_are_always_in_order_and_inside(said: list[str], held: list[str]) -> None:
    times = times_of(TimedWord(word, 0.3 * at, 0.3 * at + 0.2) for at, word in enumerate(held))
    found = fitted(times, line(" ".join(said))).words
    assert [word.text for word in found] == said
    moments = [moment for word in found for moment in (word.start, word.end)]
    assert moments == sorted(moments) and moments[0] >= 0 and moments[-1] <= times.duration + 1e-9


def test_long_texts_are_matched_quickly() -> None:
    draw = Random(1)
    first = [f"w{int(draw.paretovariate(0.6)) % 400}" for _ in range(8000)]
    second = [word for at, word in enumerate(first) if at % 97]
    begun = process_time()
    assert len(matches(first, second)) > 0.98 * len(second)
    assert len(matches(["a"] * 3000, ["b"] * 3000)) == 0
    assert process_time() - begun < 3


def test_rhubarb_words_are_spread_over_the_sounds() -> None:
    cues = [PhoneTime("zh:a", 1, 2), PhoneTime("", 2, 3), PhoneTime("zh:u", 3, 4)]
    found = fitted(times_of((), cues, duration=5), line("one two")).words
    assert found[0].start == 1 and found[1].start == pytest.approx(3) and found[1].end == pytest.approx(4)


# ------------------------------------------------------------------------------------ in a script


def folder_with(folder: Path, text: str, name: str = "take.json", seconds: float = 0) -> World:
    (folder / name).write_text(text, "utf-8")
    if seconds:
        with wave.open(str(folder / "take.wav"), "wb") as file:
            file.setparams((1, 2, 8000, 0, "NONE", ""))
            file.writeframes(bytes(range(1, 251)) * round(8000 * seconds * 2 / 250))
    return World(folder)


WORDS = json.dumps({"words": [{"text": "Mama", "start": 1, "end": 2}, {"text": "came", "start": 3, "end": 3.5}]})


@pytest.mark.usefixtures("synthesiser")
def test_voice_gives_the_phones_that_the_file_lacks(tmp_path: Path) -> None:
    world = folder_with(tmp_path, WORDS)
    asked = Say("Mama came.", line("").voice, times="take.json")
    spoken = open_studio(world).speak(asked)
    sounds = [phone for phone in spoken.phones if phone.symbol]
    assert spoken.pcm == b"" and spoken.duration == 3.5 and not spoken.estimated
    assert [phone.symbol for phone in sounds][:2] == ["m", "ɑː"] and sounds[0].start == pytest.approx(1, abs=0.01)
    assert all(1 - 1e-6 <= phone.start <= 2 or 2.9 < phone.start <= 3.5 for phone in sounds)
    assert EstimatedVoice(world).speak(asked).words == spoken.words


@pytest.mark.usefixtures("synthesiser")
def test_recording_sounds_and_bounds_the_times(tmp_path: Path) -> None:
    world = folder_with(tmp_path, WORDS, seconds=3.25)
    spoken = open_studio(world).speak(Say("Mama came.", line("").voice, recording="take.wav", times="take.json"))
    assert len(spoken.pcm) == 2 * 8000 * 3.25 and spoken.words[0].start == 1 and spoken.words[-1].end == 3.25
    assert [doubt.reason for doubt in spoken.doubts] == ["its times go on to 3.50 s, and the recording ends at 3.25 s"]


@pytest.mark.usefixtures("synthesiser")
def test_text_may_be_left_to_the_file(tmp_path: Path) -> None:
    world = folder_with(tmp_path, WORDS, seconds=4)
    spoken = open_studio(world).speak(Say("", line("").voice, recording="take.wav", times="take.json"))
    assert spoken.words == () and next(phone.symbol for phone in spoken.phones if phone.symbol) == "m"


def test_cues_act_at_the_files_times(tmp_path: Path) -> None:
    script = 'say "Mama [nod]came." timed "take.json" as hello\nat hello."came".end: blink\n'
    world = folder_with(tmp_path, WORDS)
    score = compile_source(Source("script.face", script), world, EstimatedVoice(world)).score
    assert score is not None and not score.estimated
    assert sorted(act.start for act in score.acts) == [0, 3, 3.5]


def test_marks_of_the_file_are_places(tmp_path: Path) -> None:
    marks = [{"name": "here", "time": 1.7}, {"name": "came", "time": 9.0}, {"name": "here", "time": 2.5}]
    world = folder_with(tmp_path, json.dumps({**json.loads(WORDS), "marks": marks}))
    script = 'say "Mama came." timed "take.json" as hello\n    on "here": blink\nat hello."here".2 + 100ms: nod\n'
    score = compile_source(Source("script.face", script), world, EstimatedVoice(world)).score
    assert score is not None and sorted(act.start for act in score.acts) == [0, 1.7, 2.6]
    for text, code in (('on "there": nod', "FS228"), ('on "here".3: nod', "FS228")):
        source = Source("script.face", f'say "Mama came." timed "take.json"\n    {text}\n')
        assert [item.code for item in compile_source(source, world, EstimatedVoice(world)).diagnostics] == [code]


def test_a_broken_file_is_told_once_whatever_hangs_on_it(tmp_path: Path) -> None:
    world = folder_with(tmp_path, "{")
    script = 'say "Mama came." timed "take.json" as hello\n    on "here": blink\nat hello."there": nod\n'
    found = compile_source(Source("script.face", script), world, EstimatedVoice(world)).diagnostics
    assert [item.code for item in found] == ["FS515"]
